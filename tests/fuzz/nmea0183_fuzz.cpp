#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"

// However a stream is cut, the same facts and reports come out, and the reports cover every byte once.
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
  }
  if (covered != bytes.size()) std::abort();
  return 0;
}
