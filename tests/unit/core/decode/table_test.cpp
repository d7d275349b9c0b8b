#include "core/decode/table.h"

#include <random>

#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::decode {
namespace {

using test::as_bytes;
using test::Decoded;

using Columns = std::vector<std::string>;

TableOptions table(Columns columns, std::string separator = ",", std::string comment = "") {
  TableOptions options;
  options.columns = std::move(columns);
  options.separator = std::move(separator);
  options.comment = std::move(comment);
  return options;
}

std::unique_ptr<Decoder> made(const TableOptions& options, const DecoderSettings& settings = {}) {
  auto result = make_table(settings, options);
  EXPECT_TRUE(result) << result.error().line();
  return std::move(result).value();
}

Decoded rows(const std::string& text, const TableOptions& options, const DecoderSettings& settings = {}) {
  return test::decode_all(*made(options, settings), as_bytes(text));
}

std::string error(const TableOptions& options) {
  const auto result = make_table({}, options);
  return result ? "" : result.error().line();
}

/// Reason of each report, "ok" for rows, "#" for comment.
Columns outcome(const Decoded& decoded) {
  Columns words;
  for (const auto& f : decoded.frames)
    words.push_back(f.byte_class == ByteClass::comment   ? "#"
                    : f.byte_class == ByteClass::refused ? std::string(f.reason)
                                                         : "ok");
  return words;
}

const Columns kImu = {"unix_s",       "gyro_x_rps",   "gyro_y_rps",  "gyro_z_rps",
                      "accel_x_mps2", "accel_y_mps2", "accel_z_mps2"};

TEST(Table, AnImuRowIsAClockReadingAndASample) {
  const auto decoded = rows("1501545600.123456,1e-3,-2.5E-3,0.003,0.1,-.2,-9.80665\n", table(kImu));
  ASSERT_EQ(decoded.facts.size(), 2u);
  const Time time{1501545600123456000};
  EXPECT_EQ(decoded.facts[0].device_time, time);
  EXPECT_EQ(std::get<ClockReading>(decoded.facts[0].message), (ClockReading{"row", time.ns, {}}));
  EXPECT_EQ(decoded.facts[1].device_time, time);
  EXPECT_EQ(std::get<ImuSample>(decoded.facts[1].message),
            (ImuSample{false, {1e-3, -2.5e-3, 0.003}, {0.1, -0.2, -9.80665}}));
  ASSERT_EQ(decoded.frames.size(), 1u);
  EXPECT_EQ(decoded.frames[0].kind, "row");
  EXPECT_EQ(decoded.frames[0].checksum, ChecksumState::none);
}

TEST(Table, DegreesAndGBecomeSiAndIncrementsAreMarked) {
  const auto scaled =
      rows("180,-90,0,1,-1,0.5\n",
           table({"gyro_x_dps", "gyro_y_dps", "gyro_z_dps", "accel_x_g", "accel_y_g", "accel_z_g"}));
  const auto samples = scaled.all<ImuSample>();
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_DOUBLE_EQ(samples[0].gyro.x, kPi);
  EXPECT_DOUBLE_EQ(samples[0].gyro.y, -kPi / 2);
  EXPECT_DOUBLE_EQ(samples[0].accel.x, 9.80665);
  EXPECT_DOUBLE_EQ(samples[0].accel.z, 9.80665 / 2);
  EXPECT_FALSE(samples[0].increments);
  EXPECT_EQ(scaled.facts[0].device_time, std::nullopt) << "a row without a time column has no device time";

  const auto steps = rows(
      "1;2;3;4;5;6\n",
      table({"dvel_x_mps", "dvel_y_mps", "dvel_z_mps", "dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad"}, ";"));
  EXPECT_EQ(steps.all<ImuSample>(), (std::vector<ImuSample>{{true, {4, 5, 6}, {1, 2, 3}}}));
}

TEST(Table, UnixSecondsAreExactAndMayStartAtZero) {
  const auto decoded = rows("1795350919.123456789,1\n0,1\n12.3,1\n-0.25,1\n1.5e3,1\n9.3e9,1\n1x,1\n",
                            table({"unix_s", "depth_m"}));
  std::vector<std::int64_t> ns;
  for (const auto& reading : decoded.all<ClockReading>()) ns.push_back(reading.device_ns);
  EXPECT_EQ(ns, (std::vector<std::int64_t>{1795350919123456789, 0, 12300000000, -250000000, 1500000000000}));
  EXPECT_EQ(outcome(decoded), (Columns{"ok", "ok", "ok", "ok", "ok", "range", "fields"}));
}

TEST(Table, DateAndTimeMayHaveSlashesOrDashes) {
  const auto decoded = rows(
      "2017/08/01 06:07:08.5 1\n2017-08-01 06:07:08.500Z 1\n2017/8/1 6:07:08.5 1\n2017/02/30 06:07:08 1\n"
      "2017/08-01 06:07:08 1\n01/08/2017 06:07:08 1\n2017/08/01 06:07 1\n2017/08/01 25:00:00 1\n",
      table({"date", "time", "depth_m"}, " "));
  const Time expected = *parse_iso8601("2017-08-01T06:07:08.5Z");
  ASSERT_EQ(decoded.all<ClockReading>().size(), 3u);
  for (const auto& reading : decoded.all<ClockReading>()) EXPECT_EQ(reading.device_ns, expected.ns);
  EXPECT_EQ(outcome(decoded), (Columns{"ok", "ok", "ok", "range", "fields", "fields", "fields", "range"}));
}

TEST(Table, APositionRowIsAFixWithItsSigmas) {
  const auto decoded =
      rows("-22.5,197.9,41.25,0.5,0.75,1.5\n",
           table({"lat_deg", "lon_deg", "ellipsoid_height_m", "sd_north_m", "sd_east_m", "sd_down_m"}));
  const auto fixes = decoded.all<GnssFix>();
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_DOUBLE_EQ(fixes[0].position.lat.deg(), -22.5);
  EXPECT_NEAR(fixes[0].position.lon.deg(), -162.1, 1e-12);
  EXPECT_EQ(fixes[0].height, EllipsoidHeight{41.25});
  EXPECT_EQ(fixes[0].sd_north_m, 0.5);
  EXPECT_EQ(fixes[0].sd_east_m, 0.75);
  EXPECT_EQ(fixes[0].sd_down_m, 1.5);
  EXPECT_EQ(rows("0,180\n", table({"lat_deg", "lon_deg"})).all<GnssFix>().at(0).position.lon,
            Angle::deg(-180));
}

TEST(Table, InstrumentVelocityIsADvlVelocityOverGround) {
  const auto full =
      rows("1.5,-0.25,0.125,0.02\n", table({"vel_x_mps", "vel_y_mps", "vel_z_mps", "sd_vel_mps"}));
  DvlVelocity expected;
  expected.x_mps = 1.5, expected.y_mps = -0.25, expected.z_mps = 0.125, expected.valid = true,
  expected.sd_mps = 0.02;
  EXPECT_EQ(full.all<DvlVelocity>(), (std::vector<DvlVelocity>{expected}));
  EXPECT_EQ(expected.reference, DvlReference::bottom);
  EXPECT_EQ(expected.frame, DvlFrame::instrument);
  EXPECT_FALSE(expected.tilt_applied);

  const auto level =
      rows("0.01,1.5,0.03,-0.25\n", table({"sd_vel_x_mps", "vel_x_mps", "sd_vel_y_mps", "vel_y_mps"}));
  expected.z_mps = 0.0, expected.sd_mps = 0.03;
  EXPECT_EQ(level.all<DvlVelocity>(), (std::vector<DvlVelocity>{expected})) << "without z; the larger sigma";
  EXPECT_TRUE(rows("1,2,\n", table({"vel_x_mps", "vel_y_mps", "vel_z_mps"})).facts.empty())
      << "z is absent, not 0";
}

TEST(Table, NorthAndEastVelocityAreACourse) {
  const auto decoded = rows("-3,-4,0.5\n0,0,\n", table({"vel_north_mps", "vel_east_mps", "vel_down_mps"}));
  const auto courses = decoded.all<Course>();
  ASSERT_EQ(courses.size(), 2u);
  EXPECT_DOUBLE_EQ(courses[0].speed_mps, 5.0);
  EXPECT_NEAR(courses[0].course->deg(), 180.0 + 53.13010235415598, 1e-9);
  EXPECT_EQ(courses[0].vel_down_mps, 0.5);
  EXPECT_EQ(courses[1].course, std::nullopt) << "at rest there is none";
  EXPECT_EQ(courses[1].vel_down_mps, std::nullopt);
}

TEST(Table, HeadingMeansWhatTheSourceSaysAndMagneticHeadingIsMagnetic) {
  const Columns both = {"heading_deg", "magnetic_heading_deg", "sd_heading_deg"};
  const auto as_true = rows("-10,360,0.5\n", table(both)).all<Heading>();
  ASSERT_EQ(as_true.size(), 2u);
  EXPECT_NEAR(as_true[0].heading.deg(), 350.0, 1e-12);
  EXPECT_EQ(as_true[0].reference, HeadingReference::true_north);
  EXPECT_EQ(as_true[0].sd, Angle::deg(0.5));
  EXPECT_EQ(as_true[1].heading, Angle::deg(0));
  EXPECT_EQ(as_true[1].reference, HeadingReference::magnetic_north);
  DecoderSettings magnetic;
  magnetic.heading_magnetic = true;
  EXPECT_EQ(rows("-10,360,0.5\n", table(both), magnetic).all<Heading>()[0].reference,
            HeadingReference::magnetic_north);
}

TEST(Table, TheFactsOfARowComeInAFixedOrder) {
  const auto decoded = rows("60,5,10,20,1,2,3,4,5,6,0.1,7,8,9,1,1,100,-2.5,1.25,90\n",
                            table({"lat_deg",      "lon_deg",       "altitude_above_bottom_m",
                                   "depth_m",      "vel_north_mps", "vel_east_mps",
                                   "vel_x_mps",    "vel_y_mps",     "accel_x_mps2",
                                   "accel_y_mps2", "gyro_x_rps",    "accel_z_mps2",
                                   "gyro_y_rps",   "gyro_z_rps",    "rate_z_rps",
                                   "valid",        "unix_s",        "pitch_deg",
                                   "roll_deg",     "heading_deg"}));
  ASSERT_EQ(decoded.facts.size(), 10u);
  EXPECT_TRUE(std::holds_alternative<ClockReading>(decoded.facts[0].message));
  EXPECT_EQ(std::get<Attitude>(decoded.facts[1].message).roll, Angle::deg(1.25));
  EXPECT_EQ(std::get<Attitude>(decoded.facts[1].message).pitch, Angle::deg(-2.5));
  EXPECT_EQ(std::get<Heading>(decoded.facts[2].message).heading, Angle::deg(90));
  EXPECT_EQ(std::get<Rates>(decoded.facts[3].message), Rates{1.0});
  EXPECT_EQ(std::get<ImuSample>(decoded.facts[4].message), (ImuSample{false, {0.1, 8, 9}, {5, 6, 7}}));
  EXPECT_EQ(std::get<DvlVelocity>(decoded.facts[5].message).y_mps, 4.0);
  EXPECT_DOUBLE_EQ(std::get<Course>(decoded.facts[6].message).speed_mps, std::hypot(1.0, 2.0));
  EXPECT_EQ(std::get<DepthMeasured>(decoded.facts[7].message).depth, Depth{20});
  EXPECT_EQ(std::get<AltitudeAboveBottom>(decoded.facts[8].message).above_bottom_m, 10.0);
  EXPECT_TRUE(std::holds_alternative<GnssFix>(decoded.facts[9].message));
  for (const auto& fact : decoded.facts) EXPECT_EQ(fact.device_time, Time{100'000'000'000});
}

TEST(Table, AnEmptyFieldAndNanAreAbsent) {
  const auto decoded = rows("1,,5\n2,nan,6\n3,NaN,\n ,7,-nan\n", table({"unix_s", "depth_m", "heading_deg"}));
  EXPECT_EQ(outcome(decoded), (Columns{"ok", "ok", "ok", "ok"}));
  EXPECT_EQ(decoded.all<DepthMeasured>(), (std::vector<DepthMeasured>{{Depth{7}, {}}}));
  EXPECT_EQ(decoded.all<Heading>().size(), 2u);
  EXPECT_EQ(decoded.all<ClockReading>().size(), 3u);
  EXPECT_EQ(decoded.facts.back().device_time, std::nullopt);
  const auto imu = rows("1,1,2,3,4,5,nan\n", table(kImu));
  EXPECT_TRUE(imu.all<ImuSample>().empty()) << "all six are needed";
}

TEST(Table, AnInvalidRowSaysOnlyThatThereIsNoLock) {
  const Columns columns = {"unix_s", "valid", "vel_x_mps", "vel_y_mps", "depth_m"};
  const auto decoded =
      rows("1,1,0.5,0.1,2\n2,0,-32768,-32768,x\n3,N,1,1,1\n4,false,,,\n5,,0.5,0.1,2\n6,maybe,1,1,1\n",
           table(columns));
  EXPECT_EQ(outcome(decoded), (Columns{"ok", "ok", "ok", "ok", "ok", "fields"}));
  const auto velocities = decoded.all<DvlVelocity>();
  ASSERT_EQ(velocities.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(velocities[i].valid, i == 0 || i == 4) << i;
  for (std::size_t i : {1u, 2u, 3u}) EXPECT_EQ(velocities[i], DvlVelocity{});
  EXPECT_EQ(decoded.all<DepthMeasured>().size(), 2u);
  EXPECT_TRUE(rows("0,5\n", table({"valid", "depth_m"})).facts.empty());
  for (const char* yes : {"1", "y", "Y", "true", "TRUE", "1.0"})
    EXPECT_EQ(rows(std::string(yes) + ",5\n", table({"valid", "depth_m"})).facts.size(), 1u) << yes;
}

TEST(Table, MalformedAndOutOfRangeRowsAreRefused) {
  const auto decoded = rows(
      "90,0,0\n91,0,0\n0,361,0\n0,0,361\n0,0,-181\n0,0,inf\n0,0,1e400\n0,0,0x10\n0,0,1 "
      "2\n0,0\n0,0,0,\n0,0,0,0\n\n",
      table({"lat_deg", "lon_deg", "heading_deg"}));
  EXPECT_EQ(outcome(decoded), (Columns{"ok", "range", "range", "range", "range", "fields", "fields", "fields",
                                       "fields", "fields", "ok", "fields", "#"}));
  EXPECT_EQ(decoded.ledger.refusals().size(), 2u);
  EXPECT_EQ(decoded.all<GnssFix>().size(), 2u) << "a refused row gives no fact at all";
}

TEST(Table, HeaderLinesAndCommentsAreComment) {
  TableOptions options = table({"-", "depth_m"}, "\t", "%");
  options.skip_lines = 2;
  const auto decoded = rows("time\tdepth\ns\tm\nx\t1\n  % note\r\n \r\ny\t2\r\n%\n", options);
  EXPECT_EQ(outcome(decoded), (Columns{"#", "#", "ok", "#", "#", "ok", "#"}));
  EXPECT_EQ(decoded.all<DepthMeasured>().size(), 2u);
  EXPECT_EQ(rows("\xEF\xBB\xBF"
                 "1,2\n",
                 table({"-", "depth_m"}))
                .frames.size(),
            1u);
  EXPECT_EQ(rows("\xEF\xBB\xBF"
                 "1,2\n",
                 table({"depth_m", "-"}))
                .all<DepthMeasured>()
                .size(),
            1u)
      << "byte order mark";
}

TEST(Table, ABlankSeparatorTakesAnyRunOfBlanks) {
  const auto decoded =
      rows("   1.0\t 2.0   3.0  \n1 2\n", table({"unix_s", "depth_m", "roll_deg", "pitch_deg"}, " "));
  EXPECT_EQ(outcome(decoded), (Columns{"fields", "fields"}));
  const auto three = rows("   1.0\t 2.0   3.0  \r\n4 5 6", table({"unix_s", "depth_m", "heading_deg"}, " "));
  EXPECT_EQ(outcome(three), (Columns{"ok", "ok"}));
  EXPECT_EQ(three.all<DepthMeasured>()[1].depth, Depth{5});
}

TEST(Table, AWordForTabIsTakenToo) {
  EXPECT_EQ(rows("1\t2\n", table({"unix_s", "depth_m"}, "\\t")).all<DepthMeasured>().size(), 1u);
}

TEST(Table, TheLastRowNeedsNoNewlineButAllItsFields) {
  EXPECT_EQ(outcome(rows("1,2\n3,4", table({"unix_s", "depth_m"}))), (Columns{"ok", "ok"}));
  EXPECT_EQ(outcome(rows("1,2\n3", table({"unix_s", "depth_m"}))), (Columns{"ok", "truncated"}));
}

TEST(Table, ALineAboveTheCeilingIsRefusedOnceHoweverItComes) {
  const TableOptions options = table({"unix_s", "depth_m"});
  const std::string just = std::string(65536 - 4, ' ') + "1,2\n", above = " " + just;
  EXPECT_EQ(outcome(rows(just, options)), (Columns{"ok"}));
  const std::string text = above + just + std::string(300000, 'x');
  const auto whole = rows(text, options);
  EXPECT_EQ(outcome(whole), (Columns{"too long", "ok", "too long"}));
  for (const std::size_t chunk : {1000u, 65535u, 65536u, 65537u, 100000u})
    EXPECT_TRUE(test::same(whole, test::decode_all(*made(options), as_bytes(text), {}, chunk))) << chunk;
  EXPECT_EQ(whole.ledger.bytes_total(), text.size());
}

TEST(Table, AnySplitOfAnyDamagedTableGivesTheSameAndEveryByteIsAccounted) {
  TableOptions options =
      table({"unix_s", "heading_deg", "-", "lat_deg", "lon_deg", "valid", "depth_m"}, ",", "#");
  options.skip_lines = 1;
  std::string text = "header\n";
  for (int i = 0; i < 40; ++i)
    text += std::to_string(1e9 + i * 0.1) + "," + std::to_string(i * 9) + ",x,60.5,5.25," +
            (i % 5 ? "1" : "0") + "," + (i % 7 ? std::to_string(i * 0.1) : "nan") + (i % 2 ? "\r\n" : "\n") +
            (i % 10 ? "" : "# note\n\n");
  std::mt19937 random(17);
  for (int round = 0; round < 200; ++round) {
    std::string bad = text;
    if (round > 0) {
      for (char& c : bad)
        if (random() % 50 == 0) c = static_cast<char>(random() % 256);
      bad.resize(random() % (bad.size() + 1));
    }
    const auto whole = rows(bad, options);
    ASSERT_EQ(whole.ledger.bytes_total(), bad.size()) << round;
    std::uint64_t offset = 0;
    for (const auto& f : whole.frames) {
      ASSERT_EQ(f.offset, offset);
      offset += f.length;
    }
    for (const std::size_t chunk : {1u, 2u, 7u, 64u, 1000u})
      ASSERT_TRUE(test::same(whole, test::decode_all(*made(options), as_bytes(bad), {}, chunk)))
          << round << " " << chunk;
  }
}

TEST(Table, AResearchTableOf18000RowsIsReadWhole) {
  const std::string text = test::read_text(test::data_path("reference-navigation/fusion_1h.csv"));
  Columns columns(28, "-");
  columns[0] = "unix_s", columns[4] = "vel_x_mps", columns[5] = "vel_y_mps", columns[6] = "vel_z_mps";
  columns.resize(static_cast<std::size_t>(std::count(
                     text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find('\n')), ',')) +
                     1,
                 "-");
  TableOptions options = table(columns);
  options.skip_lines = 1;
  const auto decoded = rows(text, options);
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(decoded.frames.size(), lines);
  EXPECT_EQ(decoded.all<DvlVelocity>().size(), lines - 1);
  EXPECT_TRUE(decoded.ledger.refusals().empty());
  EXPECT_EQ(decoded.all<DvlVelocity>()[0].x_mps, 0.5065383086);
  EXPECT_EQ(decoded.facts[0].device_time, Time{200'000'000});
}

TEST(Table, WrongColumnsAreExplained) {
  EXPECT_EQ(error(table({"unix_s", "depht_m"})),
            "columns: unknown column \"depht_m\"; did you mean \"depth_m\"? \"-\" skips a column");
  EXPECT_THAT(error(table({"gyro_x_rpm"})), ::testing::HasSubstr("did you mean \"gyro_x_rps\""));
  EXPECT_THAT(error(table({})), ::testing::HasSubstr("columns: are missing"));
  EXPECT_THAT(error(table({"unix_s", "-"})), ::testing::HasSubstr("hold nothing measured"));
  EXPECT_THAT(error(table({"depth_m", "depth_m"})), ::testing::HasSubstr("give the same twice"));
  EXPECT_THAT(error(table({"gyro_x_rps", "gyro_x_dps"})), ::testing::HasSubstr("give the same twice"));
  EXPECT_THAT(error(table({"gyro_x_rps", "dtheta_x_rad"})), ::testing::HasSubstr("mix increments and rates"));
  EXPECT_THAT(error(table({"gyro_x_rps", "dvel_x_mps"})), ::testing::HasSubstr("mix increments and rates"));
  EXPECT_THAT(error(table({"unix_s", "date", "time", "depth_m"})),
              ::testing::HasSubstr("give the time twice"));
  const std::pair<const char*, const char*> incomplete[] = {
      {"gyro_x_rps", "gyro_y_rps"},
      {"dvel_z_mps", "dtheta_x_rad"},
      {"lat_deg", "lon_deg"},
      {"sd_depth_m", "depth_m"},
      {"roll_deg", "pitch_deg"},
      {"vel_z_mps", "vel_x_mps"},
      {"vel_east_mps", "vel_north_mps"},
      {"time", "date"},
      {"sd_heading_deg", "heading_deg"},
  };
  for (const auto& [given, needed] : incomplete)
    EXPECT_EQ(error(table({given})).substr(0, error(table({given})).find(';')),
              "columns: \"" + std::string(given) + "\" needs \"" + needed + "\"");
}

TEST(Table, ASigmaWithoutAPlaceIsSkippedAndAWrongSeparatorExplained) {
  EXPECT_EQ(rows("1,x\n", table({"altitude_above_bottom_m", "sd_altitude_above_bottom_m"})).facts.size(), 1u);
  EXPECT_THAT(error(table({"sd_-", "depth_m"})), ::testing::HasSubstr("unknown column"));
  EXPECT_THAT(error(table({"depth_m"}, "")), ::testing::HasSubstr("separator: \"\" is no separator"));
  EXPECT_THAT(error(table({"depth_m"}, ", ")), ::testing::HasSubstr("use one character"));
}

TEST(Table, ItsKeysAreTheContracts) {
  TableOptions options;
  Columns names;
  for (const BoundKey& key : bind(table_keys(), options)) {
    names.emplace_back(key.name);
    EXPECT_FALSE(key.help.empty()) << key.name;
  }
  EXPECT_EQ(names, (Columns{"separator", "skip_lines", "comment", "columns"}));
}

}  // namespace
}  // namespace leadline::decode
