// Files as bad disks, foreign hands and power cuts leave them.

#include <gtest/gtest.h>

#include <chrono>

#include "sessions/store/frames.h"
#include "sessions/store/session.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::content;
using test::MadeFolder;
using test::write_content;

/// A session as a killed program leaves it: most of it in the write-ahead log.
struct Killed {
  std::string file, wal;
};

Killed killed_session(const MadeFolder& folder, const std::string& name) {
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(400, maker);
  const std::string path = folder.file(name);
  auto session = Session::create(path, {}).value();
  EXPECT_TRUE(session.begin_run(test::two_source_run()));
  EXPECT_TRUE(session.begin(Sync::normal));
  for (const auto& message : messages) EXPECT_TRUE(session.put(message.shown()));
  EXPECT_TRUE(session.commit());
  return {content(path), content(path + "-wal")};
}

/// Everything a session can be asked, so that every page is walked; no crash is the point.
bool read_through(Session& session) {
  bool sound = true;
  const auto runs = session.runs();
  if (!runs) return false;
  sound = session.identity().ok() && session.events().ok() && session.configuration().ok();
  for (const Run& run : runs.value()) {
    sound = session.sources(run.id).ok() && session.seek(run.id, {test::kStartNs}).ok() && sound;
    FrameReader reader(session, run.id);
    StoredFrame frame;
    for (;;) {
      const auto more = reader.next(frame);
      sound = more.ok() && sound;
      if (!more || !more.value()) break;
    }
    const auto none = [](const Envelope&) { return true; };
    sound = session.read<Solution>(run.id, none).ok() && session.read<Heading>(run.id, none).ok() && sound;
  }
  return sound;
}

TEST(Damage, NoDamagedFileIsChangedOrBringsTheProgramDown) {
  MadeFolder made;
  test::MessageMaker maker;
  const std::string closed_path = made.file("closed.leadline");
  ASSERT_NO_FATAL_FAILURE(test::make_session(closed_path, test::mixed_messages(400, maker)));
  const std::string closed = content(closed_path);
  const Killed killed = killed_session(made, "killed.leadline");
  std::mt19937 random(5);
  int refused = 0, opened = 0;
  double worst_s = 0.0;
  constexpr int kRounds = 24;
  for (int round = 0; round < kRounds; ++round) {
    MadeFolder folder;
    const std::string path = folder.file("s.leadline");
    std::string file = round % 2 ? closed : killed.file, wal = round % 2 ? "" : killed.wal;
    std::string& hurt = round % 4 == 2 ? wal : file;
    const int kind = round % 3;
    if (kind == 0) {  // bit flips
      for (int i = 0; i < 40; ++i) hurt[random() % hurt.size()] ^= static_cast<char>(1U << (random() % 8));
    } else if (kind == 1) {  // cut
      hurt.resize(random() % hurt.size());
    } else {  // a page of noise
      const std::size_t at = random() % hurt.size() / 4096 * 4096;
      for (std::size_t i = at; i < std::min(at + 4096, hurt.size()); ++i)
        hurt[i] = static_cast<char>(random());
    }
    write_content(path, file);
    if (!wal.empty()) write_content(path + "-wal", wal);
    const auto begun = std::chrono::steady_clock::now();
    {
      auto reading = Session::open(path, Access::read);
      if (reading) (void)read_through(reading.value());
      EXPECT_EQ(content(path), file) << "reading changed round " << round;
    }
    auto session = Session::open(path, Access::append);
    worst_s =
        std::max(worst_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    if (!session) {
      ++refused;
      EXPECT_THAT(session.error().line(), testing::HasSubstr(path));
      EXPECT_EQ(content(path), file) << "round " << round << ": " << session.error().line();
      if (!wal.empty()) {
        EXPECT_EQ(content(path + "-wal"), wal) << "round " << round;
      }
      // The way on: it is moved away with all that belongs to it, and a new session takes its name.
      const auto aside = Session::set_aside(path);
      ASSERT_TRUE(aside) << aside.error().line();
      EXPECT_EQ(content(aside.value()), file);
      EXPECT_TRUE(Session::create(path, {}));
    } else {
      ++opened;  // only payload was hurt, or the log's tail: it is read as far as it is sound
      (void)read_through(session.value());
    }
  }
  std::printf("damage: %d files, %d refused, %d opened, at most %.0f ms\n", kRounds, refused, opened,
              worst_s * 1e3);
  EXPECT_GE(refused, kRounds / 4);
}

TEST(Damage, ALostLogCostsItsMessagesAndNothingElse) {
  MadeFolder made, folder;
  const Killed killed = killed_session(made, "k.leadline");
  const std::string path = folder.file("s.leadline");
  write_content(path, killed.file);
  auto session = Session::open(path, Access::append);
  ASSERT_TRUE(session) << session.error().line();
  EXPECT_TRUE(session.value().runs().value().empty());
  EXPECT_TRUE(session.value().begin_run(test::two_source_run()));
}

TEST(Damage, AnotherSessionsLogIsNeverFoldedIn) {
  MadeFolder made, folder;
  const Killed one = killed_session(made, "one.leadline"), other = killed_session(made, "other.leadline");
  const std::string path = folder.file("s.leadline");
  test::MessageMaker maker;
  ASSERT_NO_FATAL_FAILURE(test::make_session(folder.file("c.leadline"), test::mixed_messages(400, maker)));
  for (const std::string& file : {one.file, content(folder.file("c.leadline"))}) {
    write_content(path, file);
    write_content(path + "-wal", other.wal);
    auto session = Session::open(path, Access::append);
    ASSERT_FALSE(session);
    EXPECT_THAT(session.error().line(), testing::HasSubstr("-wal"));
    EXPECT_EQ(content(path), file);
    EXPECT_EQ(content(path + "-wal"), other.wal);
    std::filesystem::remove(path + "-wal");
    std::filesystem::remove(path + "-shm");
    EXPECT_TRUE(Session::open(path, Access::append));
  }
}

TEST(Damage, AKilledSessionGoesOnAsItself) {
  MadeFolder made, folder;
  const Killed killed = killed_session(made, "k.leadline");
  const std::string path = folder.file("s.leadline");
  write_content(path, killed.file);
  write_content(path + "-wal", killed.wal);
  auto session = Session::open(path, Access::append);
  ASSERT_TRUE(session) << session.error().line();
  ASSERT_EQ(session.value().begin_run(test::two_source_run()).value(), 2);
  const auto runs = session.value().runs().value();
  EXPECT_EQ(runs[0].end, RunEnd::died);
  EXPECT_EQ(runs[1].end, RunEnd::open);
  const auto events = session.value().events().value();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_THAT(events[0].text,
              testing::StartsWith("gap: the program ended without closing; last frame at 2023-11-14T22:"));
}

}  // namespace
}  // namespace leadline::sessions
