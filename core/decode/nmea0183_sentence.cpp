#include "core/decode/nmea0183_sentence.h"

#include "core/decode/nmea0183_words.h"
#include "core/decode/number.h"

namespace leadline::decode::nmea0183 {
namespace {

std::uint8_t folded(std::uint64_t words) {
  words ^= words >> 32;
  words ^= words >> 16;
  return static_cast<std::uint8_t>(words ^ words >> 8);
}

/// The exclusive or of all bytes; not_printable becomes true where one is none.
std::uint8_t exclusive_or(std::string_view text, bool& not_printable) {
  const char* p = text.data();
  const char* const end = p + text.size();
  std::uint64_t words = 0, faults = 0;
  for (; end - p >= 8; p += 8) {
    const std::uint64_t w = load_word(p);
    words ^= w;
    faults |= bytes_below(w, 0x20) | bytes_equal(w, 0x7F) | (w & kHighBits);
  }
  const auto left = static_cast<int>(end - p);
  if (left > 0 && text.size() >= 8) {
    const std::uint64_t w = load_word(end - 8);  // the last ones again, whose tail is new
    words ^= w >> (64 - 8 * left);
    faults |= bytes_below(w, 0x20) | bytes_equal(w, 0x7F) | (w & kHighBits);
    p = end;
  }
  std::uint8_t sum = folded(words);
  for (; p != end; ++p) {
    sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(*p));
    faults |= static_cast<std::uint64_t>(*p < 0x20 || *p > 0x7E);
  }
  not_printable = faults != 0;
  return sum;
}

/// What is before the first comma.
std::string_view address_of(std::string_view body) {
  if (body.size() >= 8)
    if (const std::uint64_t commas = each_equal(load_word(body.data()), ','); commas != 0)
      return body.substr(0, static_cast<std::size_t>(first_byte(commas)));
  return body.substr(0, body.find(','));
}

constexpr std::size_t kChecksumSize = 3;  // *hh

Body split_checksum(std::string_view text, std::uint8_t sum) {
  const std::size_t size = text.size();
  if (size >= kChecksumSize && text[size - kChecksumSize] == '*') {
    const std::string_view tail = text.substr(size - kChecksumSize);
    for (const char c : tail) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    const auto given = parse_hex_byte(tail.substr(1));
    return {text.substr(0, size - kChecksumSize), given == sum ? ChecksumState::ok : ChecksumState::bad,
            !given};
  }
  if (const std::size_t star = text.find('*'); star != std::string_view::npos)
    return {text.substr(0, star), ChecksumState::bad, true};
  return {text, ChecksumState::absent, false};
}

}  // namespace

bool is_printable(std::string_view text) {
  bool not_printable = false;
  (void)exclusive_or(text, not_printable);
  return !not_printable;
}

Body split_checksum(std::string_view text) {
  bool not_printable = false;
  return split_checksum(text, exclusive_or(text, not_printable));
}

bool ends_in_checksum(std::string_view text) {
  return text.size() >= 3 && text[text.size() - 3] == '*' && parse_hex_byte(text.substr(text.size() - 2));
}

FrameReport report_of(ByteClass byte_class, std::string_view kind, std::string_view reason) {
  FrameReport report;
  report.byte_class = byte_class;
  report.kind = kind;
  report.reason = reason;
  return report;
}

// Why a sentence may not be read at all; empty when it may.
std::string_view SentenceDecoder::framing_fault(Line::End end, bool printable, const Body& body) const {
  if (!printable) return kReasonNotPrintable;
  if (end == Line::End::too_long) return kReasonTooLong;
  if (end == Line::End::next_sentence) return kReasonTorn;
  if (end == Line::End::stream && (body.checksum == ChecksumState::absent || body.cut_checksum))
    return kReasonTruncated;
  if (body.checksum == ChecksumState::bad) return kReasonChecksum;
  if (body.checksum == ChecksumState::absent && settings_.checksum_required) return kReasonChecksumAbsent;
  return {};
}

struct SentenceDecoder::Seen {
  Body body;
  std::string_view address;
  const KnownSentence* known = nullptr;
  FrameReport report;
  [[nodiscard]] bool to_be_read() const { return report.reason.empty() && known && known->read; }
};

SentenceDecoder::Seen SentenceDecoder::see(std::string_view text, Line::End end) {
  Seen seen;
  bool not_printable = false;
  const std::string_view after_start = text.substr(1);
  seen.body = split_checksum(after_start, exclusive_or(after_start, not_printable));
  const std::string_view body = seen.body.text;
  seen.address = address_of(body);
  seen.known = find_sentence(seen.address, text[0] == '!');

  FrameReport& report = seen.report;
  report = report_of(ByteClass::refused, seen.known ? seen.known->kind : kSentence,
                     framing_fault(end, !not_printable, seen.body));
  if (report.reason.empty() || report.reason == kReasonChecksum || report.reason == kReasonChecksumAbsent)
    report.checksum = seen.body.checksum;
  if (!report.reason.empty()) return seen;

  report.byte_class = !seen.known        ? ByteClass::unknown
                      : seen.known->read ? ByteClass::decoded
                                         : ByteClass::unused;
  if (!seen.known) report.kind = names_.intern(seen.address);
  return seen;
}

FrameReport SentenceDecoder::inspect(std::string_view text, Line::End end) { return see(text, end).report; }

FrameReport SentenceDecoder::read(std::string_view text, Line::End end, std::optional<Arrival> arrival,
                                  DecoderOutput& out) {
  Seen seen = see(text, end);
  if (!seen.to_be_read()) return seen.report;
  const std::string_view after_address = seen.body.text.substr(seen.address.size());
  Fields fields = after_address.empty() ? Fields() : Fields(after_address.substr(1));
  Reading reading{settings_, profile_, memory_, arrival, out};
  const Verdict verdict = seen.known->read(fields, reading);
  seen.report.byte_class = verdict.byte_class;
  seen.report.reason = verdict.reason;
  if (!verdict.kind.empty()) seen.report.kind = verdict.kind;
  return seen.report;
}

}  // namespace leadline::decode::nmea0183
