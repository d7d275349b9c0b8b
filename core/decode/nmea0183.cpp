#include "core/decode/nmea0183.h"

#include "core/decode/nmea0183_framing.h"
#include "core/decode/nmea0183_sentences.h"
#include "core/decode/nmea0183_table.h"
#include "core/decode/nmea0183_words.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace nmea0183 {
namespace {

/// The kind of what is no known sentence, or too damaged to tell.
constexpr std::string_view kSentence = "sentence";

bool is_printable(std::string_view text) {
  const char* p = text.data();
  const char* const end = p + text.size();
  for (; end - p >= 8; p += 8) {
    const std::uint64_t w = load_word(p);
    if ((bytes_below(w, 0x20) | bytes_equal(w, 0x7F) | (w & kHighBits)) != 0) return false;
  }
  for (; p != end; ++p)
    if (*p < 0x20 || *p > 0x7E) return false;
  return true;
}

std::uint8_t exclusive_or(std::string_view text) {
  const char* p = text.data();
  const char* const end = p + text.size();
  std::uint64_t words = 0;
  for (; end - p >= 8; p += 8) words ^= load_word(p);
  words ^= words >> 32;
  words ^= words >> 16;
  words ^= words >> 8;
  auto sum = static_cast<std::uint8_t>(words);
  for (; p != end; ++p) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(*p));
  return sum;
}

/// A sentence without its $ and checksum, and what the checksum said.
struct Body {
  std::string_view text;
  ChecksumState checksum = ChecksumState::absent;
  bool cut_checksum = false;  ///< a '*' without two hex digits at the end
};

Body split_checksum(std::string_view text) {
  const std::size_t size = text.size();
  if (size >= 3 && text[size - 3] == '*') {
    const auto given = parse_hex_byte(text.substr(size - 2));
    const std::string_view body = text.substr(0, size - 3);
    return {body, given == exclusive_or(body) ? ChecksumState::ok : ChecksumState::bad, !given};
  }
  if (const std::size_t star = text.find('*'); star != std::string_view::npos)
    return {text.substr(0, star), ChecksumState::bad, true};
  return {text, ChecksumState::absent, false};
}

/// A line without $ that ends like a sentence: the rest of a torn one.
bool ends_in_checksum(std::string_view text) {
  return text.size() >= 3 && text[text.size() - 3] == '*' && parse_hex_byte(text.substr(text.size() - 2));
}

/// TAG blocks before a sentence, \...*hh\ each (IEC 61162-450): all of them sound?
bool tag_blocks_hold(std::string_view text) {
  while (!text.empty()) {
    const std::size_t close = text.find('\\', 1);
    if (text[0] != '\\' || close == std::string_view::npos) return false;
    if (split_checksum(text.substr(1, close - 1)).checksum != ChecksumState::ok) return false;
    text.remove_prefix(close + 1);
  }
  return true;
}

FrameReport report_of(ByteClass byte_class, std::string_view kind = {}, std::string_view reason = {}) {
  FrameReport report;
  report.byte_class = byte_class;
  report.kind = kind;
  report.reason = reason;
  return report;
}

class Nmea0183 final : public Decoder, private LineReader {
 public:
  explicit Nmea0183(const DecoderSettings& settings)
      : settings_(settings), memory_(settings.date), framing_(*this) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    arrival_ = arrival;
    framing_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { framing_.finish(out); }

 private:
  FrameReport read(const Line& line, DecoderOutput& out) override {
    switch (line.shape) {
      case Line::Shape::sentence:
        return read_sentence(line, out);
      case Line::Shape::text:
        return read_text(line);
      case Line::Shape::comment:
        return report_of(ByteClass::comment);
      case Line::Shape::rubbish:
        break;
    }
    return report_of(ByteClass::skipped);
  }

  FrameReport read_text(const Line& line) const {
    const std::string_view text = line.text;
    if (line.end == Line::End::next_sentence) {
      if (text.size() < 2 || text.front() != '\\' || text.back() != '\\' || !is_printable(text))
        return report_of(ByteClass::skipped);
      FrameReport tag = tag_blocks_hold(text) ? report_of(ByteClass::unused, "TAG")
                                              : report_of(ByteClass::refused, "TAG", kReasonChecksum);
      tag.block = true;
      return tag;
    }
    if (text.find_first_not_of(' ') == std::string_view::npos) return report_of(ByteClass::comment);
    if (!is_printable(text)) return report_of(ByteClass::skipped);
    if (ends_in_checksum(text)) return report_of(ByteClass::refused, kSentence, kReasonTorn);
    return report_of(ByteClass::unknown, "text");
  }

  FrameReport read_sentence(const Line& line, DecoderOutput& out) {
    const bool printable = is_printable(line.text);
    const Body body = split_checksum(line.text.substr(1));
    const std::string_view address = body.text.substr(0, body.text.find(','));
    const KnownSentence* const known = find_sentence(address, line.text[0] == '!');

    FrameReport report = report_of(ByteClass::refused, known ? known->kind : kSentence,
                                   framing_fault(line.end, printable, body));
    if (report.reason.empty() || report.reason == kReasonChecksum || report.reason == kReasonChecksumAbsent)
      report.checksum = body.checksum;
    if (!report.reason.empty()) return report;

    if (!known) {
      report.byte_class = ByteClass::unknown;
      report.kind = names_.intern(address);
    } else if (!known->read) {
      report.byte_class = ByteClass::unused;
    } else {
      judge(*known, body.text.substr(address.size()), out, report);
    }
    return report;
  }

  /// Why a sentence may not be read at all; empty when it may.
  std::string_view framing_fault(Line::End end, bool printable, const Body& body) const {
    if (!printable) return kReasonNotPrintable;
    if (end == Line::End::too_long) return kReasonTooLong;
    if (end == Line::End::next_sentence) return kReasonTorn;
    if (end == Line::End::stream && (body.checksum == ChecksumState::absent || body.cut_checksum))
      return kReasonTruncated;
    if (body.checksum == ChecksumState::bad) return kReasonChecksum;
    if (body.checksum == ChecksumState::absent && settings_.checksum_required) return kReasonChecksumAbsent;
    return {};
  }

  void judge(const KnownSentence& known, std::string_view after_address, DecoderOutput& out,
             FrameReport& report) {
    Fields fields = after_address.empty() ? Fields() : Fields(after_address.substr(1));
    Reading reading{settings_, memory_, arrival_, out};
    const Verdict verdict = known.read(fields, reading);
    report.byte_class = verdict.byte_class;
    report.reason = verdict.reason;
    if (!verdict.kind.empty()) report.kind = verdict.kind;
  }

  DecoderSettings settings_;
  Memory memory_;
  UnknownNames names_;
  Framing framing_;
  std::optional<Arrival> arrival_;
};

}  // namespace
}  // namespace nmea0183

std::unique_ptr<Decoder> make_nmea0183(const DecoderSettings& settings) {
  return std::make_unique<nmea0183::Nmea0183>(settings);
}

}  // namespace leadline::decode
