#include "sessions/store/session.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::content;
using test::MadeFolder;
using testing::HasSubstr;

std::string refusal(Result<Session> result) {
  EXPECT_FALSE(result.ok());
  return result.ok() ? "" : result.error().line();
}

/// Refused with these words, whichever way it is opened, and not a byte of it changed.
void expect_refused(const std::string& path, const std::string& words) {
  const std::string before = content(path);
  EXPECT_THAT(refusal(Session::open(path, Access::append)), HasSubstr(words));
  EXPECT_THAT(refusal(Session::open(path, Access::read)), HasSubstr(words));
  EXPECT_EQ(content(path), before);
}

class SessionDoor : public testing::Test {
 protected:
  void SetUp() override {
    path_ = folder_.file("s.leadline");
    test::MessageMaker maker;
    messages_ = test::mixed_messages(200, maker);
  }
  void make() { ASSERT_NO_FATAL_FAILURE(test::make_session(path_, messages_)); }

  MadeFolder folder_;
  std::string path_;
  std::vector<test::KeptEnvelope> messages_;
};

TEST_F(SessionDoor, AnExistingFileIsKeptUnlessForced) {
  test::write_content(path_, "precious");
  EXPECT_THAT(refusal(Session::create(path_, {})),
              HasSubstr("exists already; choose another name, or replace it with --force"));
  EXPECT_EQ(content(path_), "precious");
  Session::Birth birth;
  birth.force = true, birth.build = "9.9", birth.predecessor = "yesterday.leadline";
  auto session = Session::create(path_, birth);
  ASSERT_TRUE(session) << session.error().line();
  const auto identity = session.value().identity().value();
  EXPECT_EQ(identity.build, "9.9");
  EXPECT_EQ(identity.predecessor, "yesterday.leadline");
  EXPECT_EQ(identity.uid.size(), 32U);
}

TEST_F(SessionDoor, WhatIsNoSessionIsRefusedAndLeftAlone) {
  EXPECT_THAT(refusal(Session::open(path_, Access::append)), HasSubstr("No such file"));
  test::write_content(path_, "");
  expect_refused(path_, "is empty, so it is no session");
  test::write_content(path_, "(1.5) gps $GPGGA\n" + std::string(200, '.'));
  expect_refused(path_, "is no Leadline session");
  std::filesystem::remove(path_);
  SQLite::Database(path_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (x)");
  expect_refused(path_, "another program's database");
  EXPECT_THAT(refusal(Session::open("/tmp", Access::read)), HasSubstr("/tmp"));
}

TEST_F(SessionDoor, ANewerSchemaIsRefusedUntouched) {
  make();
  SQLite::Database(path_, SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
  expect_refused(path_, "was written by a newer Leadline: schema 99, this one knows 1");
  EXPECT_FALSE(std::filesystem::exists(path_ + "-wal"));
}

TEST_F(SessionDoor, ASchemaThatActsOnItsOwnIsRefused) {
  make();
  const std::string sound = content(path_);
  SQLite::Database(path_, SQLite::OPEN_READWRITE)
      .exec("CREATE TRIGGER t AFTER INSERT ON raw_frame BEGIN DELETE FROM event; END");
  expect_refused(path_, "trigger t");
  test::write_content(path_, sound);
  SQLite::Database(path_, SQLite::OPEN_READWRITE)
      .exec(
          "DROP TABLE event; CREATE VIEW event AS WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i FROM "
          "r) "
          "SELECT i AS at_ns FROM r");
  expect_refused(path_, "event is not as Leadline makes it");
  test::write_content(path_, sound);
  SQLite::Database(path_, SQLite::OPEN_READWRITE).exec("CREATE TABLE qgis_style (name TEXT)");
  EXPECT_TRUE(Session::open(path_, Access::append)) << "what others keep beside ours is theirs";
}

TEST_F(SessionDoor, TheSecondRecordingIsRefusedAndAWatcherIsNot) {
  make();
  auto first = Session::open(path_, Access::append);
  ASSERT_TRUE(first) << first.error().line();
  EXPECT_THAT(refusal(Session::open(path_, Access::append)), HasSubstr("another Leadline records into it"));
  Session::Birth birth;
  birth.force = true;
  EXPECT_THAT(refusal(Session::create(path_, birth)), HasSubstr("another Leadline records into it"));
  // Another process is refused, too, by the kernel's lock.
  const pid_t child = ::fork();
  if (child == 0) {
    std::FILE* out = ::popen(("flock -n " + path_ + " true").c_str(), "r");
    ::_exit(::pclose(out) == 0 ? 1 : 0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  auto watching = Session::open(path_, Access::read);
  ASSERT_TRUE(watching) << watching.error().line();
  ASSERT_TRUE(first.value().begin_run(test::two_source_run()));
  EXPECT_EQ(watching.value().runs().value().size(), 2U);
}

TEST_F(SessionDoor, AFolderThatCannotBeWrittenIsSaid) {
  EXPECT_THAT(refusal(Session::create("/proc/s.leadline", {})), HasSubstr("the session cannot be made"));
  EXPECT_THAT(refusal(Session::create(folder_.file("none/s.leadline"), {})),
              HasSubstr("No such file or directory"));
  // Root may write everywhere: a child without its rights looks.
  make();
  const std::string folder = std::filesystem::path(path_).parent_path().string();
  ::chmod(folder.c_str(), 0555);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(9);
    const auto made = Session::create(folder + "/t.leadline", {});
    auto read = Session::open(path_, Access::read);
    const bool right = !made && made.error().what.find("Permission denied") != std::string::npos && read &&
                       read.value().runs() && !Session::open(path_, Access::append);
    ::_exit(right ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  ::chmod(folder.c_str(), 0755);
}

TEST_F(SessionDoor, OpeningAndClosingLeavesNothingBesideTheFile) {
  make();
  { ASSERT_TRUE(Session::open(path_, Access::append)); }
  { ASSERT_TRUE(Session::open(path_, Access::read)); }
  for (const char* beside : {"-wal", "-shm", "-journal"})
    EXPECT_FALSE(std::filesystem::exists(path_ + beside)) << beside;
}

TEST_F(SessionDoor, TheLogOfARemovedSessionIsNotLost) {
  test::write_content(path_ + "-wal", "somebody's last words");
  EXPECT_THAT(refusal(Session::create(path_, {})), HasSubstr("was removed, but not its -wal"));
  EXPECT_EQ(content(path_ + "-wal"), "somebody's last words");
  EXPECT_FALSE(std::filesystem::exists(path_));
  test::write_content(path_ + "-wal", "");
  EXPECT_TRUE(Session::create(path_, {}));
}

TEST_F(SessionDoor, RunsSourcesAndConfigurationComeBack) {
  make();
  auto session = Session::open(path_, Access::read).value();
  const auto info = test::two_source_run();
  const auto run = session.runs().value().at(0);
  EXPECT_EQ(run.kind, RunKind::record);
  EXPECT_EQ(run.started, info.started);
  EXPECT_EQ(run.end, RunEnd::clean);
  EXPECT_EQ(run.engines, info.engines);
  EXPECT_EQ(run.build, info.build);
  EXPECT_EQ(run.first, messages_.front().envelope.arrival);
  EXPECT_EQ(run.last, messages_.back().envelope.arrival);
  EXPECT_EQ(session.configuration().value(), info.configuration_text);
  const auto sources = session.sources(1).value();
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[0].info.name, "dvl");
  EXPECT_EQ(sources[0].link, "udp://0.0.0.0:4001");
  EXPECT_NEAR(sources[0].info.mount.heading.deg(), 45.0, 1e-12);
  EXPECT_EQ(sources[0].info.lever, info.sources[0].info.lever);
  EXPECT_EQ(sources[0].info.latency_ns, 120'000'000);
  EXPECT_EQ(sources[1].info.body, Body::ship);
  EXPECT_FALSE(sources[1].info.declination);
}

TEST_F(SessionDoor, SeekFindsTheFirstFrameAtOrAfterAnArrival) {
  make();
  auto session = Session::open(path_, Access::read).value();
  std::vector<const Envelope*> frames;
  for (const auto& m : messages_)
    if (std::holds_alternative<RawFrame>(m.envelope.message)) frames.push_back(&m.envelope);
  for (const Envelope* frame : frames) {
    for (const std::int64_t earlier_ns : {0, 1}) {
      const Arrival at{frame->arrival.ns - earlier_ns};
      const auto expected =
          *std::find_if(frames.begin(), frames.end(), [&](auto* f) { return f->arrival >= at; });
      EXPECT_EQ(session.seek(1, at).value(), std::optional(expected->seq));
    }
  }
  EXPECT_EQ(session.seek(1, frames.back()->arrival + Duration(1)).value(), std::nullopt);
  EXPECT_EQ(session.seek(2, {0}).value(), std::nullopt);
}

}  // namespace
}  // namespace leadline::sessions
