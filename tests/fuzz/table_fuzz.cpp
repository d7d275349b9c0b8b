#include <cstdint>
#include <cstdlib>

#include "core/decode/table.h"

namespace {

class ByteSum final : public leadline::DecoderOutput {
 public:
  void fact(std::optional<leadline::Time>, const leadline::Message&) override {}
  void frame(const leadline::FrameReport& report) override {
    if (report.offset != sum) std::abort();
    sum += report.length;
  }
  std::uint64_t sum = 0;
};

}  // namespace

/// The first byte chooses the separator and where the stream is cut; every byte must be accounted for in
/// order.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  leadline::decode::TableOptions options;
  options.separator = (data[0] & 1) != 0 ? "," : " ";
  options.skip_lines = (data[0] >> 1) & 1;
  options.comment = "#";
  options.columns = {"date",  "time", "lat_deg",   "lon_deg",  "heading_deg",
                     "valid", "-",    "vel_x_mps", "vel_y_mps"};
  if ((data[0] & 4) != 0) options.columns = {"unix_s", "depth_m"};
  auto decoder = leadline::decode::make_table({}, options);
  if (!decoder) std::abort();
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  const std::size_t cut = bytes.size() * (data[0] >> 3) / 32;
  ByteSum out;
  decoder.value()->feed(bytes.first(cut), std::nullopt, out);
  decoder.value()->feed(bytes.subspan(cut), std::nullopt, out);
  decoder.value()->finish(out);
  if (out.sum != bytes.size()) std::abort();
  return 0;
}
