#pragma once

#include <optional>
#include <string_view>

#include "core/decode/nmea0183_framing.h"
#include "core/decode/nmea0183_sentences.h"
#include "core/decode/nmea0183_table.h"
#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode::nmea0183 {

/// The kind of what is no known sentence, or too damaged to tell.
inline constexpr std::string_view kSentence = "sentence";

[[nodiscard]] bool is_printable(std::string_view text);

/// A sentence or TAG block without its first byte and checksum, and what the checksum said.
struct Body {
  std::string_view text;
  ChecksumState checksum = ChecksumState::absent;
  bool cut_checksum = false;  ///< a '*' without two hex digits at the end
};
[[nodiscard]] Body split_checksum(std::string_view text);

/// A line without $ that ends like a sentence: the rest of a torn one.
[[nodiscard]] bool ends_in_checksum(std::string_view text);

/// A report without offset and length.
[[nodiscard]] FrameReport report_of(ByteClass byte_class, std::string_view kind = {},
                                    std::string_view reason = {});

/// Reads the sentences of one stream, whatever carries them: checksum, kind, facts, and what earlier ones
/// leave for later ones.
class SentenceDecoder {
 public:
  SentenceDecoder(const DecoderSettings& settings, const ProfileOptions& profile)
      : settings_(settings), profile_(profile), memory_(settings.date) {}

  /// text: from its $ or ! on, without its terminator; end: how it ended.
  FrameReport read(std::string_view text, Line::End end, std::optional<Arrival> arrival, DecoderOutput& out);
  /// What it would be if it were read: its kind, and why it may not be read. No facts.
  FrameReport inspect(std::string_view text, Line::End end);

 private:
  struct Seen;
  Seen see(std::string_view text, Line::End end);
  std::string_view framing_fault(Line::End end, bool printable, const Body& body) const;

  DecoderSettings settings_;
  ProfileOptions profile_;
  Memory memory_;
  UnknownNames names_;
};

}  // namespace leadline::decode::nmea0183
