#include "ui/bridge/raw_tail.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <string_view>
#include <thread>

#include "core/flow/bus.h"

namespace leadline::ui {
namespace {

using std::chrono::milliseconds;

/// Plays the Bus by hand: numbers, arrivals, frames and refusals.
struct Heard {
  explicit Heard(std::size_t sources = 2) : tail(sources) {}

  void frame(std::string_view bytes, int at_ms, SourceId source = 0, const char* sender = "") {
    const std::span<const std::uint8_t> view(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                             bytes.size());
    say(RawFrame{view, SenderName(sender)}, at_ms, source);
    raw = seq;
  }
  void refuse(const char* reason, std::uint64_t offset, std::size_t length, SourceId source = 0) {
    say(Rejected{reason, offset, static_cast<std::uint32_t>(length)}, last_ms, source);
  }
  void say(const Message& message, int at_ms, SourceId source) {
    Envelope e;
    e.seq = ++seq;
    e.raw = std::holds_alternative<RawFrame>(message) ? 0 : raw;
    e.arrival = Arrival{} + milliseconds(last_ms = at_ms);
    e.source = source;
    e.message = message;
    tail.take(e);
  }
  [[nodiscard]] std::vector<std::string> texts(SourceId source = 0, bool refused_only = false) const {
    std::vector<std::string> found;
    for (const RawLine& line : tail.lines(source, refused_only)) found.push_back(line.text);
    return found;
  }

  RawTail tail;
  std::uint64_t seq = 0, raw = 0;
  int last_ms = 0;
};

using Texts = std::vector<std::string>;

TEST(RawTail, ATelegramIsALineWithItsArrivalAndSender) {
  Heard heard;
  heard.frame("$HEHDT,071.9,T*2C\r\n", 1'234, 0, "10.0.0.7:4001");
  heard.frame("$OTHER*00\r\n", 1'300, 1);
  const auto lines = heard.tail.lines(0, false);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], (RawLine{Arrival{1'234'000'000}, "$HEHDT,071.9,T*2C", "", "10.0.0.7:4001", 19, false}));
  EXPECT_EQ(heard.texts(1), Texts{"$OTHER*00"});
  EXPECT_TRUE(heard.tail.lines(7, false).empty());
  EXPECT_TRUE(heard.tail.lines(kNoSource, false).empty());
}

TEST(RawTail, PiecesOfAStreamAreALineAndALineEndsWhereItsSenderEndsIt) {
  Heard heard;
  heard.frame("$GPZ", 0);
  heard.frame("DA,1", 20);
  heard.frame("\r", 40);
  heard.frame("\n$GPGGA\r\n$GPV", 45);
  heard.frame("TG\r\n", 60);
  heard.frame("$LATE", 1'000);
  heard.frame("R", 1'300);
  EXPECT_EQ(heard.texts(), (Texts{"$GPZDA,1", "$GPGGA", "$GPVTG", "$LATE", "R"}));
  EXPECT_EQ(heard.tail.lines(0, false)[0].arrival.ns, 0);
}

TEST(RawTail, DatagramsAreNeverJoined) {
  Heard heard;
  heard.frame("abc", 0, 0, "10.0.0.7:1");
  heard.frame("def", 1, 0, "10.0.0.7:1");
  EXPECT_EQ(heard.texts(), (Texts{"abc", "def"}));
}

TEST(RawTail, NothingThatIsShownIsAControlCharacterOrBeyondAscii) {
  std::mt19937 random(7);
  Heard heard;
  for (int i = 0; i < 300; ++i) {
    std::string bytes;
    const auto wild = random() % 100;
    for (std::size_t n = random() % 300; n-- > 0;)
      bytes +=
          random() % 100 < wild ? static_cast<char>(random() % 256) : static_cast<char>('0' + random() % 10);
    heard.frame(bytes, 200 * i, 0, i % 2 == 0 ? "" : "h:1");
  }
  int text = 0, hex = 0;
  for (const RawLine& line : heard.tail.lines(0, false)) {
    (line.binary ? hex : text) += 1;
    std::string rest = line.text;
    for (const char* const bracket : {"‹", "›"})
      for (auto at = rest.find(bracket); at != std::string::npos; at = rest.find(bracket))
        rest.erase(at, std::string_view(bracket).size());
    for (const char c : rest) ASSERT_TRUE(c >= 0x20 && c <= 0x7E) << line.text;
  }
  EXPECT_GT(text, 20);
  EXPECT_GT(hex, 20);
}

TEST(RawTail, BinaryIsHexAndATornSentenceStaysReadable) {
  Heard heard;
  heard.frame({"\x7F\x7F\x06\x00\x0D\x0A", 6}, 0);
  heard.frame("$GPG\x1BG\xC3,1\t2\r\n", 1'000);
  const auto lines = heard.tail.lines(0, false);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].binary);
  EXPECT_EQ(lines[0].text, "7F 7F 06 00 0D 0A");
  EXPECT_EQ(lines[1].text, "$GPG‹1B›G‹C3›,1‹09›2");
}

TEST(RawTail, OnlyTheLineThatWasRefusedIsMarked) {
  Heard heard;
  heard.frame("$ONE\r\n$TWO\r\n$THREE\r\n", 0);
  heard.refuse("checksum", 6, 6);
  const auto lines = heard.tail.lines(0, false);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].refusal, "");
  EXPECT_EQ(lines[1].refusal, "checksum");
  EXPECT_EQ(lines[2].refusal, "");
  EXPECT_EQ(heard.texts(0, true), Texts{"$TWO"});
}

TEST(RawTail, ARefusalReachesBackOverThePiecesOfItsLine) {
  Heard heard;
  heard.frame("$GOOD\r\n", 0);
  heard.frame("$BROKEN", 500);
  heard.frame(",TAIL\r\n", 520);
  heard.refuse("checksum", 7, 14);
  EXPECT_EQ(heard.texts(0, true), Texts{"$BROKEN,TAIL"});
}

TEST(RawTail, AFrameRefusedBeforeAnyDecoderSawItMovesNoLaterMark) {
  Heard heard;
  heard.frame("$ONE\r\n", 0);
  heard.frame("$OVERLOAD\r\n", 200);
  heard.refuse("overload", 0, 11);
  heard.frame("$TWO\r\n", 400);
  heard.frame("$BAD\r\n", 600);
  heard.refuse("checksum", 12, 6);  // the decoder was fed 18 bytes
  EXPECT_EQ(heard.texts(0, true), (Texts{"$OVERLOAD", "$BAD"}));
}

TEST(RawTail, AStretchThatCannotBeMarksTheFrameItWasSaidOf) {
  Heard heard;
  heard.frame("$A1\r\n", 0, 0, "10.0.0.1:5");
  heard.frame("$B1\r\n", 10, 0, "10.0.0.2:5");
  heard.refuse("checksum", 0, 5);  // the first bytes of this sender
  heard.frame("$A2\r\n", 20, 0, "10.0.0.1:5");
  heard.refuse("range", 4'000'000'000'000, 5);
  EXPECT_EQ(heard.texts(0, true), (Texts{"$B1", "$A2"}));
  heard.raw = 9'999;
  heard.refuse("checksum", 0, 5);  // of a frame that was never heard here
  EXPECT_EQ(heard.texts(0, true), (Texts{"$B1", "$A2"}));
}

TEST(RawTail, KeepsTheNewestTwoHundredAndNoMoreThan64KiB) {
  Heard heard;
  for (int i = 0; i < 500; ++i) heard.frame("$" + std::to_string(i) + "\r\n", i);
  Texts texts = heard.texts();
  ASSERT_EQ(texts.size(), 200U);
  EXPECT_EQ(texts.front(), "$300");
  EXPECT_EQ(texts.back(), "$499");
  for (int i = 0; i < 100; ++i)
    heard.frame(std::string(1'500, static_cast<char>('a' + i % 26)) + "\r\n", 1'000 + i, 0, "h:1");
  texts = heard.texts();
  EXPECT_EQ(texts.size(), RawTail::kBytes / 1'502);
  for (const std::string& text : texts) EXPECT_EQ(text, std::string(1'500, text[0])) << "torn by a newer one";
  heard.frame(std::string(100'000, 'x') + "end", 2'000, 0, "h:1");
  ASSERT_EQ(heard.texts().size(), 1U);
  EXPECT_EQ(heard.texts()[0].size(), RawTail::kBytes);
  EXPECT_EQ(heard.texts()[0].substr(RawTail::kBytes - 4), "xend");
}

TEST(RawTail, ClearedIsNotShownAgainAndWhatComesIs) {
  Heard heard;
  heard.frame("$ONE\r\n", 0);
  heard.frame("$HALF", 10);
  heard.tail.clear(0);
  heard.tail.clear(9);
  EXPECT_TRUE(heard.texts().empty());
  heard.frame("REST\r\n", 20);
  EXPECT_EQ(heard.texts(), Texts{"REST"});
}

TEST(RawTail, TwoSourcesOfOneLinkShowItsTelegramsOnceInOrder) {
  Heard heard(3);
  for (int i = 0; i < 3; ++i) {
    const std::string text = "$" + std::to_string(i) + "\r\n";
    heard.frame(text, 1'000 * i, 0, "h:1");
    heard.frame(text, 1'000 * i, 1, "h:1");
    if (i == 1) heard.refuse("checksum", 0, 4, 1);
  }
  heard.frame("$X\r\n", 1'500, 2);
  const std::vector<SourceId> all{0, 1, 2};
  Texts texts;
  for (const RawLine& line : heard.tail.lines(all, false)) texts.push_back(line.text);
  EXPECT_EQ(texts, (Texts{"$0", "$1", "$X", "$2"}));
  ASSERT_EQ(heard.tail.lines(all, true).size(), 1U);
  EXPECT_EQ(heard.tail.lines(all, true)[0].text, "$1");
}

/// Refuses each line that contains an exclamation mark.
class Lines final : public Decoder {
 public:
  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    for (const std::uint8_t byte : bytes) {
      ++length_;
      bad_ |= byte == '!';
      if (byte != '\n') continue;
      FrameReport report;
      report.byte_class = bad_ ? ByteClass::refused : ByteClass::unused;
      report.reason = bad_ ? "checksum" : "";
      report.offset = offset_, report.length = length_;
      out.frame(report);
      offset_ += length_, length_ = 0, bad_ = false;
    }
  }
  void finish(DecoderOutput&) override {}

 private:
  std::uint64_t offset_ = 0;
  std::uint32_t length_ = 0;
  bool bad_ = false;
};

TEST(RawTail, OnABusMarksTheSameLinesHoweverTheStreamWasCut) {
  std::string stream;
  for (int i = 0; i < 60; ++i) stream += "$LINE" + std::to_string(i) + (i % 7 == 3 ? "!" : "") + "\r\n";
  for (const std::size_t piece : {1U, 3U, 10U, 64U, 1'000U}) {
    SourceInfo info;
    info.name = "nmea";
    Bus bus({info});
    bus.attach(0, std::make_unique<Lines>());
    RawTail tail(1);
    bus.attach(tail);
    std::int64_t at_us = 0;
    for (std::size_t from = 0; from < stream.size(); from += piece) {
      Chunk chunk;
      chunk.source = 0;
      chunk.arrival = Arrival{} + std::chrono::microseconds(at_us += 1'000);
      chunk.bytes = {reinterpret_cast<const std::uint8_t*>(stream.data()) + from,
                     std::min(piece, stream.size() - from)};
      bus.take(chunk);
    }
    const auto lines = tail.lines(0, false);
    ASSERT_EQ(lines.size(), 60U) << piece;
    for (const RawLine& line : lines)
      EXPECT_EQ(!line.refusal.empty(), line.text.find('!') != std::string::npos) << piece << " " << line.text;
    EXPECT_EQ(tail.lines(0, true).size(), 9U);
  }
}

TEST(RawTail, IsReadWhileItIsWritten) {
  Heard heard(1);
  std::atomic<bool> done = false;
  std::thread core([&] {
    for (int i = 0; i < 20'000; ++i) heard.frame(std::string(200, static_cast<char>('A' + i % 26)) + "\n", i);
    done = true;
  });
  int looked = 0;
  while (!done || looked == 0) {
    for (const RawLine& line : heard.tail.lines(0, false))
      ASSERT_EQ(line.text, std::string(200, line.text.at(0)));
    ++looked;
  }
  core.join();
  EXPECT_EQ(heard.texts().size(), 200U);
}

}  // namespace
}  // namespace leadline::ui
