// `leadline console --screenshot` on sessions as the sea makes them: empty, one row, over the date line, near
// the pole; and on charts that are no charts.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>

#include "core/geo/geodesy.h"
#include "sessions/recorder/recorder.h"
#include "tests/support/picture.h"
#include "tests/support/program.h"

namespace leadline {
namespace {

using testing::HasSubstr;

/// A session with `rows` solutions of a vehicle on its way north-east from a place, one a second.
std::string make_session(const std::string& path, int rows, Geodetic from) {
  sessions::RunInfo info;
  info.kind = sessions::RunKind::record;
  info.started = {1'700'000'000'000'000'000};
  info.engines = {"fusion"};
  info.configuration_file = "dive.toml";
  info.configuration_text = "version = 1\n[vehicle]\nname = \"MDV-1\"\n";
  info.build = "test";
  info.sources.resize(1);
  info.sources[0].info.id = 0;
  info.sources[0].info.name = "usbl";
  info.sources[0].decoder = "nmea0183";
  auto session = sessions::Session::create(path, {});
  EXPECT_TRUE(session) << session.error().line();
  sessions::Recorder::Options options;
  options.lossless = true;
  auto recorder = sessions::Recorder::start(std::move(session.value()), info, options).value();
  for (int i = 0; i < rows; ++i) {
    Envelope e;
    e.seq = static_cast<std::uint64_t>(i) + 1;
    e.arrival = {1'700'000'000'000'000'000 + i * 1'000'000'000LL};
    e.valid = e.wall_utc = e.arrival.host();
    Solution s;
    s.position = geo::displaced(from, 2.0 * i, 2.0 * i);
    s.depth = Depth{100.0};
    s.heading = Angle::deg(45.0);
    s.var_north_m2 = s.var_east_m2 = 1.0;
    s.mode = Mode::B;
    e.message = s;
    recorder->take(e);
  }
  EXPECT_TRUE(recorder->finish());
  return path;
}

std::string place_name(const testing::TestParamInfo<std::pair<const char*, Geodetic>>& info) {
  return info.param.first;
}

class ConsoleAt : public testing::TestWithParam<std::pair<const char*, Geodetic>> {};

TEST_P(ConsoleAt, ShowsSessionsOfNoRowOneRowAndMany) {
  const std::string folder = test::scratch_folder();
  for (const int rows : {0, 1, 300}) {
    const std::string stem = folder + "/rows" + std::to_string(rows);
    make_session(stem + ".leadline", rows, GetParam().second);
    const auto ran = test::leadline("console --session " + stem +
                                    ".leadline --size 1280x800 --palette day --screenshot " + stem + ".png");
    ASSERT_EQ(ran.status, 0) << ran.err;
    const QImage picture(QString::fromStdString(stem + ".png"));
    EXPECT_EQ(picture.size(), QSize(1280, 800));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Places, ConsoleAt,
    testing::Values(std::pair{"Survey", Geodetic{Angle::deg(36.91), Angle::deg(129.905)}},
                    std::pair{"DateLine", Geodetic{Angle::deg(-17.0), Angle::deg(179.999)}},
                    std::pair{"Arctic", Geodetic{Angle::deg(89.0), Angle::deg(10.0)}}),
    place_name);

TEST(Console, TheRecordingsLookAsTheyDid) {
  const std::string folder = test::scratch_folder(), data = LEADLINE_TEST_DATA;
  const std::string nbp = data + "/nmea_openrvdas_nbp1406/NBP1406_", day = "-2014-08-01";
  const auto shown = [&](const std::string& name, const std::string& inputs, const std::string& words) {
    const std::string session = folder + "/" + name + ".leadline", picture = folder + "/" + name + ".png";
    const auto kept =
        test::leadline("replay --quiet --config " + data + "/demo/" + name +
                       ".toml --engine fusion --engine dead-reckoning --session " + session + " " + inputs);
    ASSERT_TRUE(kept.status == 0 || kept.status == 3) << kept.err;
    const auto ran = test::leadline("console --session " + session + " --size 1280x800 " + words +
                                    " --screenshot " + picture);
    ASSERT_EQ(ran.status, 0) << ran.err;
    test::expect_picture(QImage(QString::fromStdString(picture)), "recording_" + name);
  };
  shown("palmer",
        "s330=" + nbp + "s330" + day + " gyr1=" + nbp + "gyr1" + day + " gp02=" + nbp + "gp02" + day +
            " adcp=" + nbp + "adcp" + day,
        "--palette day --after 600");
  shown("riverpro", "adcp=" + data + "/dvl_pd0_adcp/RiverPro_test01.PD0", "--palette night");
}

TEST(Console, ABrokenChartIsABrokenLayerAndNotACrash) {
  const std::string folder = test::scratch_folder();
  make_session(folder + "/s.leadline", 20, {Angle::deg(36.91), Angle::deg(129.905)});
  test::write_file(folder + "/text.tif", "not a chart");
  const auto ran =
      test::leadline("console --session " + folder + "/s.leadline --size 800x600 --palette night --chart " +
                     folder + "/text.tif --chart " LEADLINE_TEST_DATA "/map_tiles/invalid.mbtiles --chart " +
                     folder + "/gone.tif --screenshot " + folder + "/s.png");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_FALSE(QImage(QString::fromStdString(folder + "/s.png")).isNull());
}

TEST(Console, SaysWhatIsWrongWithTheCommandLine) {
  const std::string folder = test::scratch_folder();
  const auto status = [&](const std::string& words, int wanted, const char* said) {
    const auto ran = test::leadline("console " + words);
    EXPECT_EQ(ran.status, wanted) << words << ": " << ran.err;
    EXPECT_THAT(ran.err, HasSubstr(said)) << words;
  };
  status("--size 100x100 --screenshot x.png", 2, "is no size");
  status("--size big --screenshot x.png", 2, "is no size");
  status("--palette pink --screenshot x.png", 2, "pink");
  status("--after 5 --screenshot x.png", 2, "there is none");
  status("--session " + folder + "/none.leadline --screenshot x.png", 1, "none.leadline");
  status("--screenshot " + folder + "/no/such/folder/x.png", 1, "cannot be written");
  test::write_file(folder + "/text.leadline", "this is no session");
  status("--session " + folder + "/text.leadline --screenshot x.png", 1, "text.leadline");
  test::write_file(folder + "/bad.toml", "version = 1\nnonsense = 3\n");
  status("--config " + folder + "/bad.toml --screenshot x.png", 2, "nonsense");
}

TEST(Console, WithoutADisplayItSaysSo) {
  const auto* program = LEADLINE_PROGRAM;
  const std::string folder = test::scratch_folder();
  const std::string command = std::string("env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM ") + program;
  EXPECT_EQ(WEXITSTATUS(std::system((command + " 2>" + folder + "/err").c_str())), 1);
  EXPECT_THAT(test::read_text(folder + "/err"), HasSubstr("there is no display"));
  const std::string wrong = std::string("env -u QT_QPA_PLATFORM DISPLAY=:987 ") + program;
  EXPECT_EQ(WEXITSTATUS(std::system((wrong + " 2>" + folder + "/err").c_str())), 1);
  EXPECT_THAT(test::read_text(folder + "/err"), HasSubstr("there is no display to open"));
  // A picture needs none.
  EXPECT_EQ(WEXITSTATUS(std::system(
                (command + " console --size 800x600 --screenshot " + folder + "/x.png 2>&1").c_str())),
            0);
}

}  // namespace
}  // namespace leadline
