#include "core/links/capture_packet.h"

#include <pcap/dlt.h>

#include <cstdlib>

/// Any frame of any link type: a packet whose payload lies inside the frame, or none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leadline::links;
  for (const int link : {DLT_EN10MB, DLT_LINUX_SLL, DLT_LINUX_SLL2, DLT_NULL, DLT_RAW, -1}) {
    const auto packet = captured_packet(link, {data, size});
    if (!packet) continue;
    if (packet->sender().empty()) std::abort();
    const auto bytes = packet->payload;
    if (!bytes.empty() && (bytes.data() < data || bytes.data() + bytes.size() > data + size)) std::abort();
  }
  return 0;
}
