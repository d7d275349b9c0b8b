#include "sessions/export/session_csv.h"

#include <gtest/gtest.h>

#include "sessions/export/solution_csv.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

TEST(SessionCsv, IsWhatTheReplayWroteByteForByte) {
  test::MadeFolder folder;
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(6000, maker);
  const std::string path = folder.file("s.leadline");
  ASSERT_NO_FATAL_FAILURE(test::make_session(path, messages));

  const auto info = test::two_source_run();
  std::vector<SourceInfo> sources;
  for (const auto& source : info.sources) sources.push_back(source.info);
  auto live = SolutionCsv::create(folder.file("live"), info.engines, sources).value();
  for (const auto& message : messages) live.take(message.shown());
  ASSERT_TRUE(live.close());

  auto session = Session::open(path, Access::read).value();
  const auto done = export_csv(session, 1, folder.file("later"));
  ASSERT_TRUE(done) << done.error().line();
  for (const char* name :
       {"fusion.csv", "dead-reckoning.csv", "fixes.csv", "dead-reckoning_fixes.csv", "ship.csv"}) {
    const std::string text = test::content(folder.file(std::string("live/") + name));
    EXPECT_GT(text.size(), std::string(name) == "fixes.csv" ? 50U : 1000U) << name;
    EXPECT_EQ(text, test::content(folder.file(std::string("later/") + name))) << name;
  }
}

TEST(SessionCsv, ARunThatIsNotThereIsSaid) {
  test::MadeFolder folder;
  auto session = Session::create(folder.file("s.leadline"), {}).value();
  EXPECT_FALSE(export_csv(session, 1, folder.file("csv")));
}

}  // namespace
}  // namespace leadline::sessions
