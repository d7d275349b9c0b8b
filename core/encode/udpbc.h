#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/encode/telegrams.h"

namespace leadline::encode {

/// Wraps sentences in IEC 61162-450 datagrams: the header, and before each sentence a TAG block with source,
/// destination (where there is one) and line count 0 to 999; several sentences are one group. The mirror of
/// decode's iec61162-450.
class Udpbc {
 public:
  static constexpr std::size_t kLongestDatagram = 1472;

  /// source, destination: SFI, see good_sfi().
  explicit Udpbc(std::string source, std::string destination = {})
      : source_(std::move(source)), destination_(std::move(destination)) {}

  /// One datagram, or more where the lines do not fit: a telegram each. sentences: with CR LF, 512 bytes at
  /// most each.
  void wrap(const Telegrams& sentences, Telegrams& datagrams);

 private:
  std::string source_, destination_, line_;
  std::uint16_t count_ = 0, group_ = 0;
};

/// Two capital letters and four digits: the name of a source or destination.
[[nodiscard]] bool good_sfi(std::string_view text);

}  // namespace leadline::encode
