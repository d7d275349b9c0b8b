#include "core/links/stream_times.h"

#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

using test::MadeFile;

/// A made format, one line a telegram. "C<s>": a clock reading at <s> unix seconds. "T<s>": time of day,
/// dated by the day of the decoder's date. "F<s>": a fact with a device time but no clock reading, dated
/// likewise. "D": a telegram without time. "B<s>": a block with a clock reading, inside the telegram that
/// follows. "U": unknown.
class Letters final : public Decoder {
 public:
  explicit Letters(std::optional<Time> date) : date_(date) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    EXPECT_FALSE(arrival) << "the pre-pass knows no arrivals";
    for (const std::uint8_t b : bytes) {
      line_ += static_cast<char>(b);
      if (b == '\n') telegram(out);
    }
  }
  void finish(DecoderOutput& out) override {
    if (!line_.empty()) telegram(out);
  }

 private:
  void telegram(DecoderOutput& out) {
    const char letter = line_[0];
    const std::int64_t value = std::strtoll(line_.c_str() + 1, nullptr, 10) * 1'000'000'000;
    constexpr std::int64_t kDay = 86'400'000'000'000;
    const auto dated = date_ ? std::optional(Time{date_->ns / kDay * kDay + value}) : std::nullopt;
    if (letter == 'C' || letter == 'B') out.fact(Time{value}, ClockReading{"made", value, {}});
    if (letter == 'T' && dated) out.fact(dated, ClockReading{"made", dated->ns, {}});
    if (letter == 'F') out.fact(dated, SoundSpeed{1500.0});
    FrameReport report;
    report.kind = "letter";
    report.byte_class = letter == 'U' ? ByteClass::unknown : ByteClass::decoded;
    report.block = letter == 'B';
    report.offset = offset_;
    report.length = static_cast<std::uint32_t>(line_.size());
    offset_ += line_.size();
    out.frame(report);
    line_.clear();
  }

  std::optional<Time> date_;
  std::string line_;
  std::uint64_t offset_ = 0;
};

std::unique_ptr<Decoder> letters(std::optional<Time> date) { return std::make_unique<Letters>(date); }

Result<std::vector<Stamp>> times(const std::string& content, const StreamTimeOptions& options = {}) {
  const MadeFile file(content);
  FileReader reader = file.open();
  return stream_times(reader, letters, options);
}

/// Offset and whole seconds of each stamp.
using Pairs = std::vector<std::pair<std::uint64_t, std::int64_t>>;
Pairs pairs(const Result<std::vector<Stamp>>& result) {
  EXPECT_TRUE(result) << result.error().line();
  Pairs found;
  if (!result) return found;
  for (const Stamp& s : result.value()) found.emplace_back(s.offset, s.arrival.ns / 1'000'000'000);
  return found;
}

StreamTimeOptions on(const char* date, double rate_hz = 0.0) {
  StreamTimeOptions options;
  options.date = parse_date(date);
  options.rate_hz = rate_hz;
  return options;
}

const std::int64_t kFirstOfAugust = parse_date("2014-08-01")->ns / 1'000'000'000;

TEST(StreamTimes, AReadingStampsTheTelegramThatCarriesIt) {
  EXPECT_EQ(pairs(times("D\nC100\nD\nC101\n")), (Pairs{{2, 100}, {9, 101}}));
}

TEST(StreamTimes, AnUnchangedTimeMakesNoNewStamp) {
  EXPECT_EQ(pairs(times("C100\nC100\nD\nC102\n")), (Pairs{{0, 100}, {12, 102}}));
}

TEST(StreamTimes, AReadingInABlockBelongsToItsTelegram) {
  EXPECT_EQ(pairs(times("C100\nB101\nD\nC102\n")), (Pairs{{0, 100}, {5, 101}, {12, 102}}));
}

TEST(StreamTimes, TimesOfDayBeforeTheFirstDateAreDatedByIt) {
  const std::string date = "C" + std::to_string(kFirstOfAugust + 10) + "\n";
  EXPECT_EQ(pairs(times("T8\nT9\n" + date + "T11\n")), (Pairs{{0, kFirstOfAugust + 8},
                                                              {3, kFirstOfAugust + 9},
                                                              {6, kFirstOfAugust + 10},
                                                              {18, kFirstOfAugust + 11}}));
}

TEST(StreamTimes, WithoutADateInsideTheConfiguredOneIsTaken) {
  EXPECT_EQ(pairs(times("T8\nT9\n", on("2014-08-01"))),
            (Pairs{{0, kFirstOfAugust + 8}, {3, kFirstOfAugust + 9}}));
}

TEST(StreamTimes, ADateInsideWinsOverTheConfiguredOne) {
  const std::string date = "C" + std::to_string(kFirstOfAugust + 10) + "\n";
  EXPECT_EQ(pairs(times(date + "T11\n", on("1999-01-01"))),
            (Pairs{{0, kFirstOfAugust + 10}, {12, kFirstOfAugust + 11}}));
}

TEST(StreamTimes, WithoutAnyDateTheOperatorIsTold) {
  StreamTimeOptions options;
  options.source = "gps", options.file = "a.log";
  const auto result = times("T8\nT9\n", options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().line(), "a.log: holds no date; set `date = \"YYYY-MM-DD\"` for source gps");
}

TEST(StreamTimes, WhereNoTelegramReadsTheClockDeviceTimesOfFactsServe) {
  EXPECT_EQ(pairs(times("F8\nF8\nF9\n", on("2014-08-01", 5.0))),
            (Pairs{{0, kFirstOfAugust + 8}, {6, kFirstOfAugust + 9}}));
}

TEST(StreamTimes, WithoutAnyTimeTelegramsFollowTheRate) {
  EXPECT_EQ(
      pairs(times("D\nD\nU\nD\nD\n", on("2014-08-01", 0.5))),
      (Pairs{{0, kFirstOfAugust}, {2, kFirstOfAugust + 2}, {6, kFirstOfAugust + 4}, {8, kFirstOfAugust + 6}}))
      << "unknown telegrams do not count";
  const auto missing = times("D\nD\n", on("2014-08-01"));
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().line(), ::testing::HasSubstr("set `rate_hz`"));
}

TEST(StreamTimes, OneBadReadingDoesNotBreakTheLine) {
  EXPECT_EQ(pairs(times("C100\nC9000000\nC102\nC103\n")), (Pairs{{0, 100}, {14, 102}, {19, 103}}))
      << "in the middle";
  EXPECT_EQ(pairs(times("C9000000\nC101\nC102\n")), (Pairs{{9, 101}, {14, 102}})) << "at the start";
  EXPECT_EQ(pairs(times("C100\nC101\nC9000000\n")), (Pairs{{0, 100}, {5, 101}})) << "at the end";
  EXPECT_EQ(pairs(times("C900000\nC9000000\nC101\nC102\n")), (Pairs{{17, 101}, {22, 102}}))
      << "two different ones";
}

TEST(StreamTimes, AJumpThatIsConfirmedIsTaken) {
  EXPECT_EQ(pairs(times("C100\nC101\nC90000\nC90001\n")),
            (Pairs{{0, 100}, {5, 101}, {10, 90000}, {17, 90001}}));
}

TEST(StreamTimes, TimesNeverGoBack) {
  EXPECT_EQ(pairs(times("C100\nC105\nC103\nC104\nC106\n")), (Pairs{{0, 100}, {5, 105}, {20, 106}}));
  EXPECT_EQ(pairs(times("C90000\nC90001\nC100\nC101\nC90002\nC90003\n")),
            (Pairs{{0, 90000}, {7, 90001}, {24, 90002}, {31, 90003}}));
}

TEST(StreamTimes, AnInstrumentThatPingsEveryFewHoursConfirmsItselfByItsStride) {
  EXPECT_EQ(pairs(times("C10000\nC20000\nC30000\nC40000\n")),
            (Pairs{{0, 10000}, {7, 20000}, {14, 30000}, {21, 40000}}));
}

TEST(StreamTimes, AFewReadingsThatNothingConfirmsAreBetterThanNone) {
  EXPECT_EQ(pairs(times("C10000\n")), (Pairs{{0, 10000}}));
  EXPECT_EQ(pairs(times("C10000\nC90000\n")), (Pairs{{0, 10000}, {7, 90000}}));
}

TEST(StreamTimes, TheDevicesClockIsCorrectedAsItsFactsAre) {
  StreamTimeOptions options;
  options.time_offset_ns = -5'000'000'000;
  EXPECT_EQ(pairs(times("C100\nC101\n", options)), (Pairs{{0, 95}, {5, 96}}));
  options = {};
  options.gps_time = true;
  const std::string gps = "C" + std::to_string(kFirstOfAugust) + "\n";
  EXPECT_EQ(pairs(times(gps + gps, options)), (Pairs{{0, kFirstOfAugust - 16}})) << "16 leap seconds in 2014";
}

TEST(StreamTimes, AnEmptyFileHasNoStampsAndNeedsNoDate) { EXPECT_TRUE(pairs(times("")).empty()); }

TEST(StreamTimes, NoiseWithADateIsHeardAtIt) {
  EXPECT_EQ(pairs(times("U\nU\n", on("2014-08-01"))), (Pairs{{0, kFirstOfAugust}}));
}

}  // namespace
}  // namespace leadline::links
