#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"

namespace {

/// The exclusive or of a sentence's characters, written apart from the decoder, against its two digits.
bool sum_holds(std::string_view frame) {
  const auto end = frame.rfind('*');
  if (end == std::string_view::npos || end + 3 > frame.size()) return false;
  const auto start = frame.substr(0, end).find_last_of("$!");
  unsigned sum = 0;
  for (auto i = start + 1; i < end; ++i) sum ^= static_cast<std::uint8_t>(frame[i]);
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const auto digit = [&](char c) {
    return kDigits.find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  };
  return digit(frame[end + 1]) == sum / 16 && digit(frame[end + 2]) == sum % 16;
}

}  // namespace

// What was decoded has the checksum it claims; however a stream is cut, the same facts and reports come out,
// and the reports cover every byte once.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leadline;
  if (size < 2) return 0;
  const std::uint8_t options = data[0];
  const std::size_t chunk = 1 + data[1];
  const std::span<const std::uint8_t> bytes(data + 2, size - 2);

  DecoderSettings settings;
  settings.checksum_required = (options & 1) != 0;
  settings.heading_magnetic = (options & 2) != 0;
  if ((options & 4) != 0) settings.date = Time{1'795'350'919'000'000'000};
  std::optional<Arrival> arrival;
  if ((options & 8) != 0) arrival = Arrival{1'795'350'919'000'000'000};

  const auto whole_decoder = decode::make_nmea0183(settings), cut_decoder = decode::make_nmea0183(settings);
  const test::Decoded whole = test::decode_all(*whole_decoder, bytes, arrival);
  const test::Decoded cut = test::decode_all(*cut_decoder, bytes, arrival, chunk);
  if (!test::same(whole, cut)) std::abort();

  std::uint64_t covered = 0;
  for (const FrameReport& report : whole.frames) {
    if (report.offset != covered || report.length == 0) std::abort();
    covered += report.length;
    const std::string_view frame(reinterpret_cast<const char*>(bytes.data()) + report.offset, report.length);
    if (report.byte_class == ByteClass::decoded && report.checksum == ChecksumState::ok && !sum_holds(frame))
      std::abort();
  }
  if (covered != bytes.size()) std::abort();
  return 0;
}
