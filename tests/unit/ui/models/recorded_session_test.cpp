// The player on sessions of real recordings, made by the shipped decoders and engines.

#include <gtest/gtest.h>

#include <random>

#include "tests/support/files.h"
#include "tests/support/recording.h"
#include "tests/unit/ui/models/made_dive.h"

namespace leadline::ui {
namespace {

using test::data_path;
using test::MadeFolder;

/// Real facts with a frame before those that came of one.
std::vector<Envelope> with_frames(const std::vector<Envelope>& facts) {
  std::vector<Envelope> all;
  std::uint64_t raw = 0;
  for (const Envelope& e : facts) {
    if (e.raw != 0 && e.raw != raw) {
      Envelope frame = e;
      frame.seq = raw = e.raw, frame.raw = 0;
      frame.valid = frame.arrival.host();
      frame.message = RawFrame{};
      if (all.empty() || frame.seq > all.back().seq) all.push_back(frame);
    }
    all.push_back(e);
  }
  return all;
}

class RecordedSession : public testing::Test {
 protected:
  void make(const std::vector<test::Instrument>& instruments) {
    replayed_ = test::replay(instruments, {}, leadline::Body::ship, {"fusion", "dead-reckoning"});
    sessions::RunInfo info;
    info.started = {test::kDiveNs};
    info.engines = {"fusion", "dead-reckoning"};
    for (std::size_t i = 0; i < instruments.size(); ++i) {
      auto& source = info.sources.emplace_back();
      source.info.id = static_cast<SourceId>(i);
      source.info.name = instruments[i].name, source.decoder = instruments[i].decoder;
      source.info.body = leadline::Body::ship;
    }
    ASSERT_NO_FATAL_FAILURE(test::record(folder_.file("s.leadline"), with_frames(replayed_.envelopes), info));
    auto opened =
        test::open_player(folder_.file("s.leadline"), {}, {.navigated = Body::ship, .engine = "fusion"});
    ASSERT_TRUE(opened) << opened.error().line();
    player_ = std::move(opened).value();
  }
  /// The stored row of the engine shown that was heard last at a time.
  [[nodiscard]] const Envelope* row_at(Time t) const {
    const Envelope* found = nullptr;
    for (const Envelope& e : replayed_.envelopes) {
      if (e.arrival.host() > t) break;
      if (const auto* s = std::get_if<Solution>(&e.message); s != nullptr && s->engine == 0) found = &e;
    }
    return found;
  }
  void scrub(int times) {
    std::mt19937_64 random(17);
    const TimeSpan run = player_->run();
    for (int i = 0; i < times; ++i) {
      const Time t =
          run.from + Duration(static_cast<std::int64_t>(
                         random() % static_cast<std::uint64_t>((run.until - run.from).count() + 1)));
      player_->seek(t);
      ASSERT_FALSE(player_->failure()) << player_->failure()->line();
      const Envelope* row = row_at(t);
      ASSERT_EQ(player_->snapshot().ship.has_value(), row != nullptr);
      ASSERT_FALSE(player_->snapshot().vehicle);
      if (row != nullptr) {
        ASSERT_EQ(player_->snapshot().ship->solution, std::get<Solution>(row->message));
      }
    }
  }
  void play_and_compare() {
    ASSERT_TRUE(test::load_all(*player_));
    const TimeSpan run = player_->run();
    auto other =
        test::open_player(folder_.file("s.leadline"), {}, {.navigated = Body::ship, .engine = "fusion"})
            .value();
    ASSERT_TRUE(test::load_all(*other));
    player_->seek(run.from + (run.until - run.from) / 3);
    player_->set_speed(20.0);
    player_->play();
    for (int i = 0; i < 30 && player_->playing(); ++i) {
      player_->advance(std::chrono::milliseconds(97));
      if (i % 5 != 0) continue;
      other->seek(player_->now());
      EXPECT_EQ(test::differences(player_->snapshot(), other->snapshot()), "") << i;
    }
  }

  MadeFolder folder_;
  test::Replayed replayed_;
  std::unique_ptr<SessionPlayer> player_;
};

TEST_F(RecordedSession, OfTheResearchShipScrubsToTheStoredRows) {
  const auto file = [](const char* name) {
    return data_path("nmea_openrvdas_nbp1406/NBP1406_" + std::string(name) + "-2014-08-01");
  };
  DecoderSettings optional;
  optional.checksum_required = false;
  ASSERT_NO_FATAL_FAILURE(make({{"s330", "nmea0183", file("s330")},
                                {"gyr1", "nmea0183", file("gyr1")},
                                {"gp02", "nmea0183", file("gp02"), true, optional},
                                {"adcp", "nmea0183", file("adcp"), true, optional}}));
  scrub(200);
  play_and_compare();
  const Snapshot s = player_->snapshot();
  EXPECT_TRUE(s.ship->position && s.ship->heading && s.ship->velocity);
  EXPECT_FALSE(s.availability.reason.empty());
}

TEST_F(RecordedSession, OfASurveyBoatScrubsToTheStoredRows) {
  ASSERT_NO_FATAL_FAILURE(make({{"adcp", "trdi-pd0", data_path("dvl_pd0_adcp/RiverPro_test01.PD0"), false}}));
  scrub(200);
  play_and_compare();
  EXPECT_EQ(player_->snapshot().ship->heading->source, "adcp");
}

}  // namespace
}  // namespace leadline::ui
