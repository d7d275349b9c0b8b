#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/decode/nmea0183_sentences.h"
#include "core/types/text.h"

namespace leadline::decode::nmea0183 {

/// A sentence that is known. Standard ones are named by their formatter, makers' by their address or its
/// beginning.
struct KnownSentence {
  std::string_view kind;
  SentenceReader read;  ///< nullptr: known and not used
};

/// The sentence of an address ("GPGGA", "PSIMSSB"); nullptr when it is not known.
/// encapsulated: it began with '!'; none of those is read.
[[nodiscard]] const KnownSentence* find_sentence(std::string_view address, bool encapsulated);

/// Names of unknown sentences, kept as long as the decoder lives: the first 64, later ones are "other".
class UnknownNames {
 public:
  [[nodiscard]] std::string_view intern(std::string_view address);

 private:
  std::array<Text<16>, 64> names_;
  std::size_t count_ = 0;
};

}  // namespace leadline::decode::nmea0183
