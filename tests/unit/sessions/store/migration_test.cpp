#include "sessions/store/migration.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::content;

const schema::Script kLater[] = {
    {1, "this one is behind us"},
    {2, "CREATE TABLE tide (id INTEGER PRIMARY KEY, height_m REAL) STRICT; PRAGMA user_version = 2"},
    {3, "ALTER TABLE tide ADD COLUMN port TEXT; PRAGMA user_version = 3"},
};

class Migration : public testing::Test {
 protected:
  void SetUp() override {
    test::MessageMaker maker;
    path_ = folder_.file("s.leadline");
    ASSERT_NO_FATAL_FAILURE(test::make_session(path_, test::mixed_messages(300, maker)));
    before_ = content(path_);
  }
  test::MadeFolder folder_;
  std::string path_, before_;
};

TEST_F(Migration, ACopyIsMigratedAndTheOriginalKeptByteForByte) {
  const auto kept = migrate(path_, 1, kLater);
  ASSERT_TRUE(kept) << kept.error().line();
  EXPECT_EQ(kept.value(), path_ + ".v1");
  EXPECT_EQ(content(path_ + ".v1"), before_);
  SQLite::Database migrated(path_);
  EXPECT_EQ(migrated.execAndGet("PRAGMA user_version").getInt(), 3);
  EXPECT_EQ(migrated.execAndGet("SELECT count(port) FROM tide").getInt(), 0);
  const SQLite::Database original(path_ + ".v1");
  EXPECT_EQ(migrated.execAndGet("SELECT sum(id) FROM raw_frame").getInt64(),
            SQLite::Database(path_ + ".v1").execAndGet("SELECT sum(id) FROM raw_frame").getInt64());
  EXPECT_EQ(migrated.execAndGet("PRAGMA application_id").getInt(), 0x4C444C4E);
}

TEST_F(Migration, WhatFailsLeavesTheSessionAsItWas) {
  const schema::Script broken[] = {{2, "CREATE TABLE tide (x) ; INSERT INTO nowhere VALUES (1)"}};
  const auto kept = migrate(path_, 1, broken);
  ASSERT_FALSE(kept);
  EXPECT_THAT(kept.error().line(), testing::HasSubstr("is of schema 1 and could not be migrated"));
  EXPECT_EQ(content(path_), before_);
  EXPECT_FALSE(std::filesystem::exists(path_ + ".migrating"));
  EXPECT_TRUE(Session::open(path_, Access::append));
}

TEST_F(Migration, AnEarlierOriginalIsNeverOverwritten) {
  test::write_content(path_ + ".v1", "the first original");
  EXPECT_FALSE(migrate(path_, 1, kLater));
  EXPECT_EQ(content(path_ + ".v1"), "the first original");
  EXPECT_EQ(content(path_), before_);
}

}  // namespace
}  // namespace leadline::sessions
