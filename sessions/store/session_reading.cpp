// Parts of a run: in bus order, from behind, by time.

#include <algorithm>
#include <chrono>

#include "sessions/store/session_impl.h"

namespace leadline::sessions {
namespace {

constexpr int kHeldRows = 4096;                  // then the file is let go
constexpr std::uint64_t kLookBack = 1ULL << 20;  // messages that one question may pass over

Error damaged(const std::string& path) {
  return {"the session is damaged: a row that no Leadline wrote", path, ""};
}

}  // namespace

MessageReader& Session::reader(RunId run) {
  SQLite::Database& database = impl_->database();
  if (!impl_->reader || impl_->reader->run() != run) impl_->reader.emplace(database, run);
  return *impl_->reader;
}

Result<void> Session::read_between(RunId run, const Reading& reading,
                                   const std::function<bool(const Envelope&)>& take) {
  return guarded(path(), [&]() -> Result<void> {
    MessageReader& messages = reader(run);
    Reading rest = reading;
    for (;;) {
      const auto next = messages.read(rest, kHeldRows, take);
      if (messages.failed()) {
        impl_->reader.reset();
        return damaged(path());
      }
      if (!next) return {};
      rest.first_seq = *next;
      impl_->connection->restart_clock();
    }
  });
}

Result<std::vector<Envelope>> Session::read_last(RunId run, std::size_t kind, std::uint64_t end_seq, int most,
                                                 const Speaker& speaker, std::uint64_t floor_seq) {
  return guarded(path(), [&]() -> Result<std::vector<Envelope>> {
    MessageReader& messages = reader(run);
    std::vector<Envelope> found;
    const auto wanted = static_cast<std::size_t>(std::max(most, 0));
    for (auto end = end_seq; end > floor_seq && found.size() < wanted;) {
      // Nobody asked for is in the way of the newest row: jump to it.
      const auto newest = messages.newest_before(kind, end);
      if (!newest || *newest < floor_seq) break;
      end = *newest + 1;
      const auto floor = std::max(floor_seq, end > kLookBack ? end - kLookBack : 0);
      messages.read_last(kind, floor, end, wanted, speaker, found);
      end = floor;
      impl_->connection->restart_clock();
    }
    if (messages.failed()) {
      impl_->reader.reset();
      return damaged(path());
    }
    std::reverse(found.begin(), found.end());
    return found;
  });
}

Result<std::uint64_t> Session::seek_after(RunId run, Arrival arrival) {
  return guarded(path(), [&]() -> Result<std::uint64_t> {
    MessageReader& messages = reader(run);
    std::uint64_t low = 1, high = 1;  // the answer is in [low, high]
    for (std::size_t kind = 0; kind < MessageReader::kKinds; ++kind)
      if (const auto newest = messages.newest_before(kind, UINT64_MAX)) high = std::max(high, *newest + 1);
    // Where frames are kept they are the most: by them alone first, then by all between two of them.
    for (const auto kind : {std::optional<std::size_t>(0), std::optional<std::size_t>()}) {
      std::uint64_t frames_low = low, frames_high = high;
      while (frames_low < frames_high) {
        const auto middle = frames_low + (frames_high - frames_low) / 2;
        const auto found = messages.first_from(middle, kind);
        if (messages.failed()) break;
        if (!found || found->seq >= frames_high) {
          frames_high = middle;
        } else if (found->arrival <= arrival) {
          low = frames_low = found->seq + 1;
        } else {
          high = std::min(high, found->seq);
          frames_high = middle;
        }
      }
    }
    if (messages.failed()) {
      impl_->reader.reset();
      return damaged(path());
    }
    return high;
  });
}

}  // namespace leadline::sessions
