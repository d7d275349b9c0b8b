#include "ui/models/session_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/ui/models/made_dive.h"

namespace leadline::ui {
namespace {

using test::differences;
using test::Dive;
using test::kDiveNs;
using test::load_all;
using test::MadeFolder;
using test::open_player;

Time at(double s) { return Time{kDiveNs} + duration(s); }

/// Half an hour, with alarms, changes of mode, a compass that dies after two minutes and a minute of silence.
Dive long_dive() {
  Dive dive;
  dive.sail(0.0, 120.0);
  dive.say(kNoSource, ModeChange{0, Mode::E0, Mode::B, "a fix that agrees"});
  dive.spare = false;
  dive.sail(120.0, 600.0);
  dive.say(kNoSource, Alarm{Alarm::Priority::warning, "blocked", "engine dead-reckoning takes long"});
  dive.frame(test::kPress);
  dive.say(test::kPress, Rejected{"checksum", 5, 12});
  dive.sail(660.0, 1'200.0);
  dive.say(kNoSource, ModeChange{0, Mode::B, Mode::A, "GNSS found"});
  dive.sail(1'200.0, 1'800.0);
  return dive;
}

class Player : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new MadeFolder;
    dive_ = new Dive(long_dive());
    test::record(folder_->file("dive.leadline"), dive_->messages);
  }
  static void TearDownTestSuite() {
    delete dive_;
    delete folder_;
  }
  void SetUp() override {
    auto opened = open_player(folder_->file("dive.leadline"));
    ASSERT_TRUE(opened) << opened.error().line();
    player_ = std::move(opened).value();
  }
  /// The state after every message heard until then, by a builder that heard them all.
  static Snapshot expected(Time t) {
    SnapshotBuilder builder(setup());
    for (const Envelope& e : dive_->messages)
      if (e.arrival.host() <= t) builder.take(e);
    return builder.snapshot(t);
  }
  static ConsoleSetup setup() {
    ConsoleSetup setup = test::dive_setup();
    setup.replay = true, setup.vehicle = "vehicle", setup.ship = "ship";
    setup.dive = "dive", setup.file = "dive.leadline";
    return setup;
  }

  static MadeFolder* folder_;
  static Dive* dive_;
  std::unique_ptr<SessionPlayer> player_;
};
MadeFolder* Player::folder_ = nullptr;
Dive* Player::dive_ = nullptr;

TEST_F(Player, OpensPausedAtItsEndWithTheNewestState) {
  EXPECT_FALSE(player_->playing());
  EXPECT_EQ(player_->now(), player_->run().until);
  EXPECT_EQ(player_->now(), dive_->messages.back().arrival.host());
  ASSERT_TRUE(player_->snapshot().vehicle);
  EXPECT_EQ(player_->snapshot().vehicle->solution, expected(player_->now()).vehicle->solution);
  EXPECT_EQ(player_->snapshot().availability.mode, Mode::A);
  EXPECT_TRUE(player_->snapshot().replay);
  EXPECT_EQ(player_->snapshot().file, "dive.leadline");
}

TEST_F(Player, AnyTimeHasTheStateOfHavingHeardEverything) {
  ASSERT_TRUE(load_all(*player_));
  std::mt19937 random(8);
  for (int i = 0; i < 60; ++i) {
    const Time t = i % 2 == 0 ? at(static_cast<double>(random() % 18'000) * 0.1)
                              : dive_->messages[random() % dive_->messages.size()].arrival.host();
    player_->seek(t);
    ASSERT_EQ(player_->now(), t);
    ASSERT_EQ(differences(player_->snapshot(), expected(t)), "") << seconds(t - at(0.0));
  }
}

TEST_F(Player, BeforeEverythingIsReadTheSolutionAndFeedsAreRightAlready) {
  for (const double s : {1'799.0, 10.0, 900.0, 300.0, 630.0}) {
    player_->seek(at(s));
    const Snapshot full = expected(at(s));
    EXPECT_EQ(player_->snapshot().vehicle->solution, full.vehicle->solution);
    EXPECT_EQ(player_->snapshot().vehicle->heading, full.vehicle->heading);
    EXPECT_EQ(player_->snapshot().vehicle->position, full.vehicle->position);
    EXPECT_EQ(player_->snapshot().availability, full.availability);
  }
}

TEST_F(Player, PlayingToATimeAndGoingThereGiveTheSame) {
  ASSERT_TRUE(load_all(*player_));
  auto other = open_player(folder_->file("dive.leadline")).value();
  ASSERT_TRUE(load_all(*other));
  for (const double begin : {0.0, 70.0, 590.0, 1'190.0}) {
    player_->seek(at(begin));
    player_->set_speed(20.0);
    player_->play();
    for (int i = 0; i < 40; ++i) {
      ASSERT_TRUE(player_->advance(std::chrono::milliseconds(50 + i)));
      if (i % 8 != 0) continue;
      other->seek(player_->now());
      ASSERT_EQ(differences(player_->snapshot(), other->snapshot()), "") << begin << " " << i;
    }
  }
}

TEST_F(Player, PlaysAtItsSpeedThroughAGapAndStopsAtTheEnd) {
  player_->seek(at(595.0));
  player_->set_speed(60.0);
  player_->play();
  for (int i = 0; i < 20; ++i) player_->advance(std::chrono::milliseconds(50));
  EXPECT_EQ(player_->now(), at(655.0)) << "silence lasts as long as it did";
  EXPECT_GT(seconds(player_->now() - player_->snapshot().vehicle->valid), 50.0);
  player_->seek(at(1'790.0));
  for (int i = 0; i < 20; ++i) player_->advance(std::chrono::milliseconds(50));
  EXPECT_EQ(player_->now(), player_->run().until);
  EXPECT_FALSE(player_->playing());
  player_->play();
  EXPECT_EQ(player_->now(), player_->run().from) << "at the end, play begins again";
  player_->pause();
  EXPECT_FALSE(player_->advance(std::chrono::milliseconds(50)));
  player_->set_speed(0.01);
  EXPECT_EQ(player_->speed(), 0.25);
  player_->set_speed(1e9);
  EXPECT_EQ(player_->speed(), 60.0);
}

TEST_F(Player, AsFastAsPossibleComesToTheEndWithTheSameState) {
  ASSERT_TRUE(load_all(*player_));
  const Snapshot end = player_->snapshot();
  player_->seek(at(0.0));
  player_->set_speed({});
  player_->play();
  int advances = 0;
  while (player_->playing() && ++advances < 100) player_->advance(std::chrono::milliseconds(50));
  EXPECT_GT(advances, 2);
  EXPECT_LT(advances, 20);
  EXPECT_EQ(differences(player_->snapshot(), end), "");
}

TEST_F(Player, StepsGoFromSolutionToSolutionOfTheEngineShown) {
  std::vector<const Envelope*> epochs;
  for (const Envelope& e : dive_->messages)
    if (const auto* s = std::get_if<Solution>(&e.message); s != nullptr && s->engine == 0)
      epochs.push_back(&e);
  player_->seek(at(598.05));
  auto next = std::find_if(epochs.begin(), epochs.end(),
                           [](const Envelope* e) { return e->arrival.host() > at(598.05); });
  for (int i = 0; i < 30; ++i, ++next) {
    player_->step_forward();
    ASSERT_EQ(player_->snapshot().vehicle->solution, std::get<Solution>((*next)->message)) << i;
    ASSERT_EQ(player_->now(), (*next)->arrival.host());
  }
  --next;
  for (int i = 0; i < 30; ++i) {
    player_->step_back();
    --next;
    ASSERT_EQ(player_->snapshot().vehicle->solution, std::get<Solution>((*next)->message)) << i;
  }
  player_->seek(at(0.0));
  player_->step_back();
  EXPECT_EQ(player_->now(), at(0.0)) << "before the first there is nothing";
  player_->seek(player_->run().until);
  player_->step_forward();
  EXPECT_EQ(player_->now(), player_->run().until);
}

TEST_F(Player, LoopsFromAToB) {
  player_->set_loop(TimeSpan{at(100.0), at(102.0)});
  player_->seek(at(100.0));
  player_->set_speed(4.0);
  player_->play();
  int returns = 0;
  Time last = player_->now();
  for (int i = 0; i < 60; ++i) {
    player_->advance(std::chrono::milliseconds(50));
    EXPECT_GE(player_->now(), at(100.0));
    EXPECT_LE(player_->now(), at(102.0));
    returns += player_->now() < last ? 1 : 0;
    last = player_->now();
  }
  EXPECT_GE(returns, 4);
  player_->set_loop(TimeSpan{at(5'000.0), at(6'000.0)});
  EXPECT_FALSE(player_->loop()) << "it lies outside";
}

TEST_F(Player, GoesFromEventToEvent) {
  ASSERT_TRUE(load_all(*player_));
  std::vector<double> stops;
  player_->seek(at(0.0));
  while (player_->next_event()) stops.push_back(seconds(player_->now() - at(0.0)));
  EXPECT_THAT(stops,
              testing::ElementsAre(testing::DoubleNear(120.0, 1e-6), testing::DoubleNear(600.0, 1e-6),
                                   testing::DoubleNear(660.0, 0.2), testing::DoubleNear(1'200.0, 1e-6)));
  std::size_t back = 0;
  while (player_->previous_event()) ++back;
  EXPECT_EQ(back, 3U);
  EXPECT_EQ(player_->now(), at(120.0));
  EXPECT_EQ(player_->snapshot().availability.reason, "a fix that agrees");
}

TEST_F(Player, TheHistoryIsAllThereIs) {
  ASSERT_TRUE(load_all(*player_));
  HistoryBuilder builder(setup());
  for (const Envelope& e : dive_->messages) builder.take(e);
  const History all = builder.take_new();
  const History& h = player_->history();
  ASSERT_EQ(h.tracks.size(), all.tracks.size());
  for (std::size_t i = 0; i < h.tracks.size(); ++i) EXPECT_EQ(h.tracks[i].points, all.tracks[i].points);
  EXPECT_EQ(h.fixes, all.fixes);
  EXPECT_EQ(h.modes, all.modes);
  EXPECT_EQ(h.events, all.events);
  EXPECT_EQ(h.first, at(0.0));
  EXPECT_EQ(h.last, player_->run().until);
}

TEST_F(Player, ALongSilentSourceIsShownLostAsSoonAsEverythingIsRead) {
  ASSERT_TRUE(load_all(*player_));
  const auto& spare = player_->snapshot().sources[test::kSpareCompass];
  ASSERT_TRUE(spare.last);
  EXPECT_LT(*spare.last, at(120.0));
  EXPECT_EQ(spare.frames, 120U);
  EXPECT_EQ(player_->snapshot().sources[test::kPress].refused, 1U);
  EXPECT_EQ(player_->snapshot().sources[test::kPress].last_refusal, "checksum");
}

// --- sessions that are not as they should be
// ------------------------------------------------------------------

TEST(PlayerOf, ARunWithoutARowShowsItsSources) {
  MadeFolder folder;
  test::record(folder.file("s.leadline"), {});
  auto player = open_player(folder.file("s.leadline"));
  ASSERT_TRUE(player) << player.error().line();
  SessionPlayer& p = *player.value();
  EXPECT_TRUE(load_all(p));
  EXPECT_FALSE(p.snapshot().vehicle);
  EXPECT_EQ(p.snapshot().sources.size(), 7U);
  p.play();
  p.advance(std::chrono::seconds(1));
  p.seek(at(100.0));
  p.step_forward();
  p.step_back();
  EXPECT_FALSE(p.next_event());
  EXPECT_FALSE(p.failure()) << p.failure()->line();
}

TEST(PlayerOf, OneRowIsAtThatRow) {
  MadeFolder folder;
  Dive dive;
  dive.solution(0, 0.0, 0.0);
  test::record(folder.file("s.leadline"), dive.messages);
  auto player = open_player(folder.file("s.leadline"));
  ASSERT_TRUE(player) << player.error().line();
  SessionPlayer& p = *player.value();
  EXPECT_TRUE(load_all(p));
  EXPECT_EQ(p.snapshot().vehicle->solution, std::get<Solution>(dive.messages[0].message));
  EXPECT_EQ(p.run(), (TimeSpan{at(0.0), at(0.0)}));
  p.play();
  p.advance(std::chrono::seconds(1));
  p.step_back();
  p.step_forward();
  EXPECT_TRUE(p.snapshot().vehicle);
  EXPECT_EQ(p.history().tracks.at(0).points.size(), 1U);
}

TEST(PlayerOf, ASessionNobodyRecordedInIsRefusedInASentence) {
  MadeFolder folder;
  { ASSERT_TRUE(sessions::Session::create(folder.file("s.leadline"), {})); }
  const auto player = open_player(folder.file("s.leadline"));
  ASSERT_FALSE(player);
  EXPECT_THAT(player.error().line(), testing::HasSubstr("nothing was ever recorded in it"));
}

TEST(PlayerOf, AReplayIntoTheSameFileIsChosenOrARunByName) {
  MadeFolder folder;
  Dive dive, replayed;
  dive.sail(0.0, 30.0);
  replayed.sail(0.0, 30.0);
  replayed.solution(0, 5'000.0, 0.0);
  test::record(folder.file("s.leadline"), dive.messages);
  auto info = test::dive_run(sessions::RunKind::replay);
  info.store_frames = false;
  test::record(folder.file("s.leadline"), replayed.messages, info);
  auto empty = test::dive_run(sessions::RunKind::replay);
  test::record(folder.file("s.leadline"), {}, empty);
  auto newest = open_player(folder.file("s.leadline"));
  ASSERT_TRUE(newest) << newest.error().line();
  EXPECT_EQ(newest.value()->snapshot().vehicle->solution.position, test::near_busan(5'000.0, 0.0));
  EXPECT_NEAR(newest.value()->snapshot().sources[test::kDvl].rate_hz, 5.0, 0.3);
  newest.value()->seek(at(12.0));
  EXPECT_EQ(newest.value()->snapshot().vehicle->valid, at(11.85));
  auto first = open_player(folder.file("s.leadline"), 1);
  ASSERT_TRUE(first);
  EXPECT_NE(first.value()->snapshot().vehicle->solution.position, test::near_busan(5'000.0, 0.0));
  EXPECT_THAT(open_player(folder.file("s.leadline"), 9).error().line(), testing::HasSubstr("has no run 9"));
}

TEST(PlayerOf, ARecordingThatWasContinuedIsOneTimelineWithAGap) {
  MadeFolder folder;
  Dive first, second;
  first.sail(0.0, 100.0);
  first.say(kNoSource, ModeChange{0, Mode::E0, Mode::B, "a fix that agrees"});
  second.spare = false;
  second.sail(104.0, 200.0);
  test::record(folder.file("s.leadline"), first.messages);
  test::record(folder.file("s.leadline"), second.messages);
  auto opened = open_player(folder.file("s.leadline"));
  ASSERT_TRUE(opened) << opened.error().line();
  SessionPlayer& p = *opened.value();
  ASSERT_TRUE(load_all(p));
  EXPECT_EQ(p.run().from, at(0.0));
  ASSERT_EQ(p.history().events.size(), 1U);
  EXPECT_EQ(p.history().events[0].kind, EventMark::Kind::gap);
  EXPECT_NEAR(seconds(p.history().events[0].until - p.history().events[0].valid), 4.0, 0.1);
  EXPECT_EQ(p.history().tracks[0].points.size(), 980U);
  p.seek(at(50.0));
  EXPECT_EQ(p.snapshot().vehicle->solution.position, test::near_busan(49.9, 1.4 * 49.9));
  p.seek(at(106.0));
  ASSERT_TRUE(p.snapshot().sources[test::kSpareCompass].last) << "who spoke before the gap is remembered";
  EXPECT_EQ(p.snapshot().sources[test::kSpareCompass].frames, 100U);
  p.seek(at(95.0));
  p.set_speed(60.0);
  p.play();
  for (int i = 0; i < 10; ++i) p.advance(std::chrono::milliseconds(50));
  const Snapshot played = p.snapshot();
  p.seek(p.now());
  EXPECT_EQ(differences(played, p.snapshot()), "");
  p.seek(at(99.99));
  p.step_forward();
  EXPECT_GE(p.now(), at(104.0));
  p.step_back();
  EXPECT_LT(p.now(), at(100.0));
}

TEST(PlayerOf, ARecordingThatGoesOnIsFollowed) {
  MadeFolder folder;
  const std::string path = folder.file("s.leadline");
  Dive dive;
  dive.sail(0.0, 30.0);
  auto recorder = sessions::Recorder::start(sessions::Session::create(path, {}).value(), test::dive_run(),
                                            test::lossless());
  ASSERT_TRUE(recorder);
  std::size_t taken = 0;
  for (; taken < dive.messages.size() / 2; ++taken) recorder.value()->take(dive.messages[taken]);
  while (recorder.value()->status().waiting_bytes > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  auto opened = open_player(path);
  ASSERT_TRUE(opened) << opened.error().line();
  SessionPlayer& p = *opened.value();
  ASSERT_TRUE(load_all(p));
  const Time before = p.run().until;
  for (; taken < dive.messages.size(); ++taken) recorder.value()->take(dive.messages[taken]);
  for (int i = 0; i < 400 && p.run().until < dive.messages.back().arrival.host(); ++i) {
    p.take_loaded();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_GT(p.run().until, before);
  EXPECT_EQ(p.now(), before) << "the head stays where it was";
  p.play();
  p.set_speed(60.0);
  for (int i = 0; i < 20; ++i) p.advance(std::chrono::milliseconds(50));
  EXPECT_EQ(p.now(), dive.messages.back().arrival.host());
  EXPECT_TRUE(p.playing()) << "it waits for more";
  EXPECT_EQ(p.history().tracks[0].points.size(), 150U);
  ASSERT_TRUE(recorder.value()->finish());
}

TEST(PlayerOf, AJumpOfTheClockIsPlayedOver) {
  MadeFolder folder;
  Dive dive;
  dive.sail(0.0, 30.0);
  dive.sail(86'400.0, 86'430.0);  // the clock was set a day on
  const std::size_t count = dive.messages.size();
  for (int i = 0; i < 30'000; ++i) dive.heard(test::kPress, DepthMeasured{Depth{1.0 * i}});  // and then stood
  test::record(folder.file("s.leadline"), dive.messages);
  auto opened = open_player(folder.file("s.leadline"));
  ASSERT_TRUE(opened) << opened.error().line();
  SessionPlayer& p = *opened.value();
  ASSERT_TRUE(load_all(p));
  p.seek(at(25.0));
  EXPECT_EQ(p.snapshot().vehicle->solution.position, test::near_busan(24.9, 1.4 * 24.9));
  ASSERT_TRUE(p.next_event());
  EXPECT_NEAR(seconds(p.now() - at(0.0)), 86'400.0, 0.2);
  p.set_speed(60.0);
  p.play();
  for (int i = 0; i < 40 && p.playing(); ++i) p.advance(std::chrono::milliseconds(50));
  EXPECT_FALSE(p.playing()) << "a moment with 30,000 messages is passed, too";
  EXPECT_EQ(p.now(), dive.messages.back().arrival.host());
  EXPECT_GT(dive.messages.size(), count);
  EXPECT_FALSE(p.failure());
}

TEST(PlayerOf, AFileThatIsDamagedMeanwhileLeavesASentence) {
  MadeFolder folder;
  const std::string path = folder.file("s.leadline");
  test::record(path, long_dive().messages);
  auto opened = open_player(path);
  ASSERT_TRUE(opened);
  SessionPlayer& p = *opened.value();
  ASSERT_TRUE(load_all(p));
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    const std::string rubbish(400'000, '\x5A');
    file.seekp(60'000);
    file.write(rubbish.data(), static_cast<std::streamsize>(rubbish.size()));
    file.seekp(24);
    file.write("\xFF\xFF\xFF\xFF", 4);  // SQLite's change counter: what it keeps in memory is out of date
  }
  int failures = 0;
  for (double s = 0.0; s < 1'800.0; s += 60.0) {
    p.seek(at(s));
    p.play();
    p.advance(std::chrono::milliseconds(500));
    if (!p.failure()) continue;
    ++failures;
    EXPECT_FALSE(p.playing());
    EXPECT_THAT(p.failure()->line(), testing::HasSubstr("damaged"));
  }
  EXPECT_GT(failures, 0);
}

}  // namespace
}  // namespace leadline::ui
