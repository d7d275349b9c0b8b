#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "sessions/schema/scripts.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::MadeFolder;

class Schema : public testing::Test {
 protected:
  void SetUp() override {
    test::MessageMaker maker;
    path_ = folder_.file("s.leadline");
    ASSERT_NO_FATAL_FAILURE(test::make_session(path_, test::mixed_messages(2000, maker)));
    database_ = std::make_unique<SQLite::Database>(path_);  // as any other tool would
  }
  std::int64_t number(const std::string& sql) { return database_->execAndGet(sql).getInt64(); }

  MadeFolder folder_;
  std::string path_;
  std::unique_ptr<SQLite::Database> database_;
};

TEST_F(Schema, TheFileSaysWhoseItIs) {
  EXPECT_EQ(number("PRAGMA application_id"), 0x4C444C4E);
  EXPECT_EQ(number("PRAGMA user_version"), schema::scripts().back().version);
  EXPECT_EQ(number("SELECT count(*) FROM session WHERE length(uid) = 32"), 1);
}

TEST_F(Schema, EveryTableIsStrict) {
  EXPECT_GT(
      number("SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"), 30);
  EXPECT_EQ(number("SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND strict = 0 "
                   "AND name NOT LIKE 'sqlite_%'"),
            0);
}

TEST_F(Schema, EveryPromisedNameAnswers) {
  for (const char* name : {"source", "frame", "fix", "solution", "mode", "alarm", "event", "calibration",
                           "waypoint", "target", "configuration", "run"})
    EXPECT_GE(number(std::string("SELECT count(*) FROM ") + name), 0) << name;
  for (const char* name : {"source", "frame", "fix", "solution", "mode", "configuration", "run"})
    EXPECT_GT(number(std::string("SELECT count(*) FROM ") + name), 0) << name;
}

TEST_F(Schema, SolutionHasTheColumnsOfTheCsvBehindRunAndEngine) {
  SQLite::Statement query(*database_, "SELECT group_concat(name, ',') FROM pragma_table_info('solution')");
  ASSERT_TRUE(query.executeStep());
  EXPECT_EQ(query.getColumn(0).getString(),
            "run,engine,unix_s,utc,lat_deg,lon_deg,depth_m,roll_deg,pitch_deg,heading_deg,vel_north_mps,"
            "vel_east_mps,vel_down_mps,sd_north_m,sd_east_m,sd_down_m,sd_heading_deg,heading_bias_deg,mode,"
            "position_source");
  EXPECT_EQ(number("SELECT count(*) FROM solution WHERE heading_deg < 0 OR heading_deg >= 360"), 0);
  EXPECT_EQ(number("SELECT count(DISTINCT engine) FROM solution"), 3);
}

TEST_F(Schema, ViewsSpeakOfNamesAndDegrees) {
  EXPECT_EQ(number("SELECT count(*) FROM frame WHERE source IN ('dvl', 'gps')"),
            number("SELECT count(*) FROM frame"));
  EXPECT_EQ(
      number("SELECT count(*) FROM solution s JOIN engine_solution r ON r.valid_ns / 1e9 = s.unix_s "
             "WHERE r.run = s.run AND abs(s.lat_deg - r.lat_rad * 180 / 3.14159265358979323846) < 1e-12") >=
          number("SELECT count(*) FROM solution"),
      1);
  EXPECT_EQ(number("SELECT count(*) FROM frame WHERE utc NOT LIKE '2023-11-14T22:%Z'"), 0);
  EXPECT_EQ(number("SELECT count(*) FROM source WHERE name = 'dvl' AND abs(mount_yaw_deg - 45) < 1e-9 "
                   "AND abs(declination_deg + 7.8) < 1e-9"),
            1);
}

TEST_F(Schema, RowsPointToRowsThatAreThere) {
  SQLite::Statement check(*database_, "PRAGMA foreign_key_check");
  EXPECT_FALSE(check.executeStep());
  EXPECT_EQ(
      number("SELECT count(*) FROM attitude a LEFT JOIN raw_frame f ON f.id = a.frame WHERE f.id IS NULL"),
      0);
}

TEST_F(Schema, AClosedSessionIsOneFile) {
  for (const char* beside : {"-wal", "-shm", "-journal"})
    EXPECT_FALSE(std::filesystem::exists(path_ + beside)) << beside;
}

}  // namespace
}  // namespace leadline::sessions
