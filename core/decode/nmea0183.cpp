#include "core/decode/nmea0183.h"

#include "core/decode/nmea0183_framing.h"
#include "core/decode/nmea0183_sentence.h"

namespace leadline::decode {
namespace nmea0183 {
namespace {

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

class Nmea0183 final : public Decoder, private LineReader {
 public:
  Nmea0183(const DecoderSettings& settings, const ProfileOptions& profile)
      : sentences_(settings, profile), framing_(*this) {}

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
        return sentences_.read(line.text, line.end, arrival_, out);
      case Line::Shape::text:
        return read_text(line);
      case Line::Shape::comment:
        return report_of(ByteClass::comment);
      case Line::Shape::rubbish:
        break;
    }
    return report_of(ByteClass::skipped);
  }

  static FrameReport read_text(const Line& line) {
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

  SentenceDecoder sentences_;
  Framing framing_;
  std::optional<Arrival> arrival_;
};

}  // namespace
}  // namespace nmea0183

std::unique_ptr<Decoder> make_nmea0183(const DecoderSettings& settings, const ProfileOptions& profile) {
  return std::make_unique<nmea0183::Nmea0183>(settings, profile);
}

}  // namespace leadline::decode
