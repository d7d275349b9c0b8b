#include "core/links/stream_source.h"

#include <algorithm>

#include "core/types/expect.h"

namespace leadline::links {

StreamSource::StreamSource(FileReader file, SourceId source, std::vector<Stamp> stamps)
    : file_(std::move(file)), source_(source), stamps_(std::move(stamps)) {
  for (std::size_t i = 1; i < stamps_.size(); ++i) LL_EXPECT(stamps_[i - 1].offset < stamps_[i].offset);
  file_.rewind();
}

bool StreamSource::next(Chunk& chunk) {
  constexpr std::uint64_t kPiece = std::uint64_t{64} << 10;
  while (current_ + 1 < stamps_.size() && stamps_[current_ + 1].offset <= file_.offset()) ++current_;
  std::uint64_t wanted = kPiece;
  if (current_ + 1 < stamps_.size()) wanted = std::min(wanted, stamps_[current_ + 1].offset - file_.offset());
  chunk = Chunk{};
  chunk.source = source_;
  if (!stamps_.empty()) chunk.arrival = stamps_[current_].arrival;
  chunk.bytes = file_.take(static_cast<std::size_t>(wanted));
  return !chunk.bytes.empty();
}

}  // namespace leadline::links
