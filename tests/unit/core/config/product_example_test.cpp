// The configuration that the product page shows must be read as it stands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "tests/unit/core/config/readers.h"

namespace leadline::config {
namespace {

using test::lines_of;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const char* const kExample = R"(version = 1
[vehicle]
name = "MDV-1"
[navigation]
engine = "fusion"             # dead-reckoning | fusion | ekf7 | ins11 | ins13 | ins24 | ins
body = "vehicle"              # whose solution the engine makes
output_hz = 10.0              # at most
[navigation.fusion]
variant = "error-state"       # error-state | windowed-ci | plain-ci
[navigation.aiding]           # one sigma a sample
gnss_drms_m = 2.0
gnss_height_noise_m = 4.0
usbl_drms_m = 5.0
dvl_noise_mps = 0.005
dvl_scale_ppm = 0.0           # 0: not estimated
dvl_misalignment_deg = 0.0
depth_noise_m = 0.1
heading_noise_deg = 0.3
[navigation.initial]          # when given, used instead of initial alignment
lat_deg = 37.5
lon_deg = 126.0
depth_m = 50.0                # or ellipsoid_height_m
vel_north_mps = 0.0
roll_deg = 0.0
sd_position_m = 10.0
[navigation.imu]
gyro_bias_deg_h = 0.1
gyro_noise_deg_sqrt_h = 0.01
bias_time_constant_s = 0.0    # 0: constant
[[source]]
name = "dvl"
link = "udp://0.0.0.0:4001"   # may be left out where the input is a log
decoder = "trdi-pd6"
body = "vehicle"              # vehicle | ship | target (a transponder on the target)
mount = { roll_deg = 0.0, pitch_deg = 0.0, yaw_deg = 45.0, x_m = 0.2, y_m = 0.0, z_m = 0.5 }
checksum = "required"         # required | optional (accept telegrams that carry none)
heading = "true"              # true | magnetic
declination_deg = -7.8        # instead of the world magnetic model at place and date
time_scale = "utc"            # utc | gps
time_offset_s = 0.0           # added to the device's clock
latency_s = 0.0
rate_hz = 0.0
date = "2017-08-01"
address = "B07"
[[source]]                    # a table: one row a sample, columns named by what they hold
name = "imu"
decoder = "table"
separator = ","               # " " takes any run of blanks
skip_lines = 1
comment = "%"
columns = ["unix_s", "gyro_x_rps", "gyro_y_rps", "gyro_z_rps", "accel_x_mps2", "accel_y_mps2", "accel_z_mps2"]
[[calibration]]               # in force when the session carries none
source = "dvl"
yaw_deg = 0.0                 # added to the mount; roll_deg, pitch_deg likewise
scale = 1.0
[[output]]
name = "repeater"
link = "udp://127.0.0.1:10110"
sentences = ["GGA", "RMC", "HDT", "DPT"]
rate_hz = 1.0
body = "vehicle"
)";

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Numbers by their names.
struct Numbers {
  std::map<std::string, std::optional<double>, std::less<>> values;
  explicit Numbers(std::vector<std::string> names) {
    for (auto& name : names) values[std::move(name)];
  }
  [[nodiscard]] std::vector<BoundKey> keys() {
    std::vector<BoundKey> bound;
    for (auto& [name, value] : values) bound.push_back({name, &value, "", -kInf, kInf, {}});
    return bound;
  }
};

struct Texts {
  std::map<std::string, std::string, std::less<>> values;
  explicit Texts(std::vector<std::string> names) {
    for (auto& name : names) values[std::move(name)];
  }
  [[nodiscard]] std::vector<BoundKey> keys() {
    std::vector<BoundKey> bound;
    for (auto& [name, value] : values) bound.push_back({name, &value, "", -kInf, kInf, {}});
    return bound;
  }
};

TEST(ProductExample, IsReadWithoutAProblem) {
  Document document = Document::parse(kExample, "leadline.toml");
  Table root = document.root();
  std::int64_t version = 0;
  root.read({{"version", &version, "", 1, 1, {}}});
  EXPECT_EQ(version, 1);

  Texts vehicle({"name"}), navigation({"engine", "body"}), fusion({"variant"});
  Numbers output({"output_hz"});
  Numbers aiding({"gnss_drms_m", "gnss_height_noise_m", "usbl_drms_m", "dvl_noise_mps", "dvl_scale_ppm",
                  "dvl_misalignment_deg", "depth_noise_m", "heading_noise_deg"});
  Numbers initial({"lat_deg", "lon_deg", "depth_m", "vel_north_mps", "roll_deg", "sd_position_m"});
  Numbers imu({"gyro_bias_deg_h", "gyro_noise_deg_sqrt_h", "bias_time_constant_s"});
  root.table("vehicle").read(vehicle.keys());
  Table nav = root.table("navigation");
  nav.read(navigation.keys());
  nav.read(output.keys());
  nav.table("fusion").read(fusion.keys());
  nav.table("aiding").read(aiding.keys());
  nav.table("initial").read(initial.keys());
  nav.table("imu").read(imu.keys());
  EXPECT_EQ(vehicle.values["name"], "MDV-1");
  EXPECT_EQ(navigation.values["engine"], "fusion");
  EXPECT_EQ(fusion.values["variant"], "error-state");
  EXPECT_EQ(aiding.values["dvl_noise_mps"], 0.005);
  EXPECT_EQ(initial.values["lon_deg"], 126.0);

  auto sources = root.tables("source");
  ASSERT_THAT(sources, SizeIs(2));
  SourceOptions dvl, imu_source;
  MountOptions mount;
  sources[0].read(bind(source_keys(), dvl));
  sources[0].table("mount").read(bind(mount_keys(), mount));
  sources[1].read(bind(source_keys(), imu_source));
  EXPECT_FALSE(sources[1].table("mount").given());
  EXPECT_EQ(dvl.decoder, "trdi-pd6");
  EXPECT_EQ(dvl.declination_deg, -7.8);
  EXPECT_EQ(dvl.date, "2017-08-01");
  EXPECT_EQ(mount.yaw_deg, 45.0);
  EXPECT_EQ(mount.z_m, 0.5);
  EXPECT_FALSE(imu_source.declination_deg);

  Texts table({"separator", "comment"});
  std::vector<std::string> columns;
  std::int64_t skip_lines = 0;
  sources[1].read(table.keys());
  sources[1].read({{"columns", &columns, "", -kInf, kInf, {}}, {"skip_lines", &skip_lines, "", 0, kInf, {}}});
  EXPECT_THAT(columns, SizeIs(7));
  EXPECT_EQ(skip_lines, 1);

  CalibrationOptions calibration;
  for (Table& t : root.tables("calibration")) t.read(bind(calibration_keys(), calibration));
  EXPECT_EQ(calibration.source, "dvl");

  Texts repeater({"name", "link", "body"});
  Numbers rate({"rate_hz"});
  std::vector<std::string> sentences;
  for (Table& t : root.tables("output")) {
    t.read(repeater.keys());
    t.read(rate.keys());
    t.read({{"sentences", &sentences, "", -kInf, kInf, {"GGA", "RMC", "HDT", "DPT"}}});
  }
  EXPECT_THAT(sentences, ElementsAre("GGA", "RMC", "HDT", "DPT"));

  document.finish();
  EXPECT_THAT(lines_of(document), IsEmpty());
}

TEST(ProductExample, AMistypedKeyIsNamedWithItsLineAndItsNeighbour) {
  std::string text = kExample;
  text.replace(text.find("gnss_drms_m"), 11, "gnss_drm_m");
  Document document = Document::parse(text, "leadline.toml");
  Numbers aiding({"gnss_drms_m", "usbl_drms_m", "gnss_height_noise_m", "dvl_noise_mps", "dvl_scale_ppm",
                  "dvl_misalignment_deg", "depth_noise_m", "heading_noise_deg"});
  document.root().table("navigation").table("aiding").read(aiding.keys());
  document.finish();
  EXPECT_THAT(lines_of(document),
              testing::Contains(
                  "leadline.toml:11: navigation.aiding.gnss_drm_m: unknown key; the nearest known key is "
                  "gnss_drms_m"));
}

}  // namespace
}  // namespace leadline::config
