#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/links/sniff.h"
#include "core/links/stamped_text_source.h"
#include "core/links/tlog_source.h"

namespace {

using namespace leadline;

std::uint64_t byte_sum(Source& source) {
  std::uint64_t sum = 0;
  for (Chunk chunk; source.next(chunk);) sum += chunk.bytes.size() + chunk.stamp_bytes;
  return sum;
}

}  // namespace

/// Both stamped logs account for every byte of any file, and any bytes have a kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int memory = ::memfd_create("tlog", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(memory);
  if (::ftruncate(memory, 0) != 0 || ::pwrite(memory, data, size, 0) != static_cast<ssize_t>(size))
    std::abort();
  (void)links::sniff({data, std::min(size, links::kSniffBytes)}, size);
  links::TlogSource tlog(links::FileReader::open(path).value(), {{"gps", 0}, {"dvl", 1}});
  if (byte_sum(tlog) != size) std::abort();
  links::StampedTextSource text(links::FileReader::open(path).value(), 0);
  if (byte_sum(text) != size) std::abort();
  return 0;
}
