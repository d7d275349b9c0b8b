#pragma once

// A session small enough to know by heart, and messages of every kind.

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "sessions/recorder/recorder.h"
#include "sessions/store/session.h"

namespace leadline::test {

/// A folder for the length of a test.
class MadeFolder {
 public:
  MadeFolder() {
    static int count = 0;
    path_ = ::testing::TempDir() + "leadline_sessions_" + std::to_string(::getpid()) + "_" +
            std::to_string(++count);
    std::filesystem::create_directories(path_);
  }
  ~MadeFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

inline constexpr std::int64_t kStartNs = 1'700'000'000'000'000'000;

inline sessions::RunInfo two_source_run(sessions::RunKind kind = sessions::RunKind::record) {
  sessions::RunInfo info;
  info.kind = kind;
  info.started = {kStartNs};
  info.engines = {"fusion", "dead-reckoning"};
  info.configuration_file = "boat.toml";
  info.configuration_text = "version = 1\n[vehicle]\nname = \"boat\"\n";
  info.build = "0.1.0-test";
  info.sources.resize(2);
  info.sources[0].info.id = 0, info.sources[0].info.name = "dvl";
  info.sources[0].decoder = "trdi-pd0", info.sources[0].link = "udp://0.0.0.0:4001";
  info.sources[0].info.mount.heading = Angle::deg(45.0);
  info.sources[0].info.lever = {0.2, 0.0, 0.5};
  info.sources[0].info.declination = Angle::deg(-7.8);
  info.sources[0].info.latency_ns = 120'000'000;
  info.sources[1].info.id = 1, info.sources[1].info.name = "gps", info.sources[1].info.body = Body::ship;
  info.sources[1].decoder = "nmea0183";
  info.plugins = {{"navigation", "/opt/navigation.so", "00ff"}};
  return info;
}

inline sessions::Recorder::Options lossless() {
  sessions::Recorder::Options options;
  options.lossless = true;
  return options;
}

/// Messages of every kind with values that no rounding keeps, each optional empty as often as not.
class MessageMaker {
 public:
  Message any() {
    switch (random_() % 22) {
      case 0:
        return Rejected{"checksum", random_() % 1000000, static_cast<std::uint32_t>(random_() % 9999)};
      case 1:
        return Health{Health::Level::warning, "gp02 is not used: it lies 35 m off, dead astern"};
      case 2:
        return ClockReading{"ZDA", kStartNs + 7, maybe(std::int64_t{kStartNs - 5})};
      case 3:
        return GnssFix{place(),
                       maybe(EllipsoidHeight{number()}),
                       GnssQuality::rtk_float,
                       maybe(std::uint8_t{11}),
                       maybe(number()),
                       maybe(number()),
                       maybe(number()),
                       maybe(number())};
      case 4:
        return Course{number(), maybe(angle()), maybe(number()), maybe(number())};
      case 5:
        return Heading{angle(), HeadingReference::magnetic_north, maybe(angle()), maybe(angle())};
      case 6:
        return Attitude{angle(), angle(), maybe(number()), maybe(angle()), maybe(angle())};
      case 7:
        return Rates{number()};
      case 8:
        return ImuSample{true, {number(), number(), number()}, {number(), number(), number()}};
      case 9: {
        DvlVelocity dvl{DvlReference::water, DvlFrame::earth, true, number(), number(), number(), true,
                        maybe(number()),     maybe(number()), {}};
        if (random_() % 2) dvl.applied = {angle(), angle(), angle(), HeadingReference::magnetic_north};
        return dvl;
      }
      case 10:
        return BeamRanges{{number(), number(), 0.0, number()}, angle()};
      case 11:
        return AltitudeAboveBottom{number()};
      case 12:
        return DepthMeasured{Depth{number()}, maybe(number())};
      case 13:
        return BottomDepth{number(), BottomDepth::Below::keel};
      case 14:
        return Pressure{number()};
      case 15:
        return SoundSpeed{number()};
      case 16:
        return UsblRelative{"B07", UsblAxes::north_up, number(), number(), maybe(number()), maybe(number())};
      case 17:
        return UsblGeographic{"", place(), maybe(Depth{number()}), maybe(number())};
      case 18:
        return UsblGrid{"X", number(), number(), maybe(Depth{number()}), maybe(number())};
      case 19:
        return solution();
      case 20:
        return FixVerdict{1,
                          place(),
                          maybe(Depth{number()}),
                          maybe(number()),
                          maybe(number()),
                          maybe(number()),
                          maybe(random_() % 2 == 0)};
      default:
        return ModeChange{0, Mode::E1, Mode::A, "a fix that agrees"};
    }
  }
  Solution solution() {
    Solution s;
    s.engine = random_() % 8 == 0 ? kShipTrack : static_cast<EngineId>(random_() % 2);
    s.position = place();
    s.depth = maybe(Depth{number()});
    s.roll = maybe(angle()), s.pitch = maybe(angle()), s.heading = maybe(angle());
    s.vel_north_mps = maybe(number()), s.vel_east_mps = maybe(number()), s.vel_down_mps = maybe(number());
    s.var_north_m2 = std::abs(number()), s.cov_north_east_m2 = number(), s.var_east_m2 = std::abs(number());
    s.sd_down_m = maybe(number()), s.sd_heading = maybe(angle()), s.heading_bias = maybe(angle());
    s.mode = maybe(Mode::E0), s.position_source = static_cast<PositionSource>(random_() % 3);
    return s;
  }
  std::vector<std::uint8_t> bytes(std::size_t most) {
    std::vector<std::uint8_t> all(random_() % (most + 1));
    for (auto& b : all) b = static_cast<std::uint8_t>(random_());
    return all;
  }
  std::uint32_t random() { return static_cast<std::uint32_t>(random_()); }

 private:
  double number() { return normal_(random_); }
  Angle angle() { return Angle::rad(std::fmod(std::abs(number()), 6.28)); }
  Geodetic place() { return {Angle::rad(number() / 20), Angle::rad(number() / 20)}; }
  template <class T>
  std::optional<T> maybe(T value) {
    return random_() % 2 ? std::optional<T>(value) : std::nullopt;
  }
  std::mt19937 random_{20261122};
  std::normal_distribution<double> normal_{1.0, 7.0};
};

/// A message with its raw bytes kept.
struct KeptEnvelope {
  Envelope envelope;
  std::vector<std::uint8_t> bytes;
  [[nodiscard]] Envelope shown() const {
    Envelope e = envelope;
    if (std::holds_alternative<RawFrame>(e.message)) e.message = RawFrame{bytes};
    return e;
  }
};

/// `count` messages as a Bus would number them: frames, each followed by facts, and what engines say.
inline std::vector<KeptEnvelope> mixed_messages(std::size_t count, MessageMaker& maker) {
  std::vector<KeptEnvelope> all;
  std::uint64_t raw = 0;
  SourceId source = 0;
  std::int64_t now = kStartNs;
  for (std::uint64_t seq = 1; all.size() < count; ++seq) {
    KeptEnvelope& kept = all.emplace_back();
    Envelope& e = kept.envelope;
    e.seq = seq;
    if (seq == 1 || maker.random() % 3 == 0) {
      now += static_cast<std::int64_t>(maker.random() % 50'000) * 1000;
      raw = seq;
      source = static_cast<SourceId>(maker.random() % 2);
      kept.bytes = maker.bytes(200);
      e.message = RawFrame{};
      e.valid = {now};
    } else {
      e.message = maker.any();
      e.raw = raw;
      e.valid = {now - static_cast<std::int64_t>(maker.random() % 1'000'000'007)};
    }
    e.arrival = {now};
    e.wall_utc = {now};
    e.source = source;
  }
  return all;
}

inline std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write_content(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

/// A closed session of `count` mixed messages.
inline void make_session(const std::string& path, const std::vector<KeptEnvelope>& messages,
                         const sessions::RunInfo& info = two_source_run()) {
  auto session = sessions::Session::create(path, {});
  ASSERT_TRUE(session) << session.error().line();
  auto recorder = sessions::Recorder::start(std::move(session).value(), info, lossless());
  ASSERT_TRUE(recorder) << recorder.error().line();
  for (const auto& message : messages) recorder.value()->take(message.shown());
  const auto finished = recorder.value()->finish();
  ASSERT_TRUE(finished) << finished.error().line();
}

}  // namespace leadline::test
