#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/messages/message.h"

namespace leadline {

/// Where a byte of an input went. Each byte is in exactly one class.
enum class ByteClass : std::uint8_t {
  decoded,  ///< a telegram whose facts were taken
  unused,   ///< known and not used
  unknown,  ///< well framed, not known
  refused,  ///< damaged, torn or out of range
  stamp,    ///< the arrival stamp a log writes before each line
  comment,  ///< comments and blank lines
  skipped,  ///< bytes between telegrams that belong to none
};
inline constexpr int kByteClasses = 7;

enum class ChecksumState : std::uint8_t { none, ok, bad, absent };  ///< none: the format has no checksum

/// What became of one telegram (or one run of bytes that is none).
struct FrameReport {
  ByteClass byte_class = ByteClass::decoded;
  ChecksumState checksum = ChecksumState::none;
  /// Its kind ("GGA", "ensemble"): text that lives as long as the decoder. Empty for bytes that are no
  /// telegram.
  std::string_view kind;
  /// Why it was refused, one of a few fixed words; empty when it was not.
  std::string_view reason;
  std::uint64_t offset = 0;  ///< of its first byte in the source's stream
  std::uint32_t length = 0;  ///< bytes of this class; blocks reported apart are not in it
  std::uint32_t lost = 0;    ///< telegrams that the sender's own count says were lost just before this one
  bool block = false;        ///< a part of a telegram that is reported apart: its bytes count, it is no frame
};

/// Where a Decoder puts what it found.
class DecoderOutput {
 public:
  virtual ~DecoderOutput() = default;
  /// A fact of the telegram being decoded. device_time: UTC on the device's own clock, uncorrected;
  /// empty where the telegram gives none.
  virtual void fact(std::optional<Time> device_time, const Message& message) = 0;
  /// Closes a telegram: after its facts, once for each, in the order of the bytes. Together the reports
  /// cover every byte fed exactly once.
  virtual void frame(const FrameReport& report) = 0;
};

/// Bytes of one source to facts. A pure function of the bytes and arrivals fed so far: no I/O, no clock;
/// however a stream is cut into chunks, the same facts and reports come out.
class Decoder {
 public:
  virtual ~Decoder() = default;
  /// Who sent the bytes of the feeds that follow (SenderName); empty where the link does not tell. Said
  /// before each chunk of a Bus; a format that names no senders need not listen.
  virtual void sender(std::string_view /*name*/) {}
  /// arrival: when the chunk was heard; empty while a plain byte stream is being searched for its own times.
  virtual void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
                    DecoderOutput& out) = 0;
  /// The stream has ended: what is still pending is decoded if it is whole, else refused as truncated.
  virtual void finish(DecoderOutput& out) = 0;
};

/// What every decoder is told of its source.
struct DecoderSettings {
  bool checksum_required = true;
  bool heading_magnetic = false;  ///< mark headings that do not say themselves as magnetic
  std::optional<Time> date;  ///< host time to date times of day with, while no arrival and no date is known
  /// Only this transponder's positions (iec61162-450: this source's sentences) are facts; empty: any.
  /// Outlives the decoder.
  std::string_view address;
};

}  // namespace leadline
