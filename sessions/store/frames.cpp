#include "sessions/store/frames.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "sessions/store/message_rows.h"
#include "sessions/store/run_rows.h"
#include "sessions/store/session_impl.h"

namespace leadline::sessions {
namespace {

constexpr std::size_t kMostRows = 512, kMostBytes = std::size_t{1} << 20;  // a page

/// The words with which a log refuses a line and a live run what it has no time to decode; they outlive every
/// reader.
constexpr std::array<std::string_view, 5> kLineWords = {"hex", "stamp", "truncated", "too long", "overload"};

}  // namespace

FrameReader::FrameReader(Session& session, RunId run, std::uint64_t from)
    : session_(session), run_(run), after_(id_of(run, from) - (from > 0 ? 1 : 0)) {}

/// A log's refusal is the message right behind the frame and speaks of all its bytes from the first. A
/// decoder's speaks so only of the first frame of its source, where `truncated` is told apart by nothing
/// else.
std::string_view FrameReader::settled_word(const std::string& reason, const StoredFrame& frame) {
  const auto* word = std::find(kLineWords.begin(), kLineWords.end(), std::string_view(reason));
  if (word == kLineWords.end()) return {};
  const bool first = frame.source < heard_.size() && !heard_[frame.source];
  return *word == "truncated" && first ? std::string_view() : *word;
}

Result<void> FrameReader::fill() {
  return guarded(session_.path(), [&]() -> Result<void> {
    SQLite::Database& database = session_.impl_->database();
    if (!started_) {
      started_ = true;
      places_ = places_in(database, run_);
      heard_.assign(places_.size(), false);
    }
    page_.clear();
    bytes_.clear();
    at_ = 0;
    SQLite::Statement query(
        database,
        "SELECT f.id, f.source, f.arrival_ns, f.wall_ns, f.bytes, r.reason, f.sender FROM raw_frame f "
        "LEFT JOIN rejected r ON r.id = f.id + 1 AND r.frame = f.id AND r.offset_bytes = 0 "
        "AND r.length_bytes = length(f.bytes) WHERE f.id > ? AND f.id < ? ORDER BY f.id LIMIT ?");
    query.bind(1, after_), query.bind(2, id_of(run_ + 1, 0)), query.bind(3, static_cast<int>(kMostRows));
    while (bytes_.size() < kMostBytes && query.executeStep()) {
      Row& row = page_.emplace_back();
      after_ = query.getColumn(0).getInt64();
      row.frame.run = run_;
      row.frame.seq = seq_of(after_);
      if (!query.getColumn(1).isNull()) {
        const auto place = places_.find(query.getColumn(1).getInt64());
        if (place == places_.end())
          return Error{"the session is damaged: a frame of a source that is not there", session_.path(), ""};
        row.frame.source = place->second;
      }
      row.frame.arrival.ns = query.getColumn(2).getInt64();
      row.frame.wall =
          query.getColumn(3).isNull() ? row.frame.arrival.host() : Time{query.getColumn(3).getInt64()};
      const SQLite::Column bytes = query.getColumn(4);
      const auto* data = static_cast<const std::uint8_t*>(bytes.getBlob());
      row.begin = bytes_.size();
      row.size = data == nullptr ? 0 : static_cast<std::size_t>(bytes.getBytes());
      bytes_.insert(bytes_.end(), data, data + row.size);
      if (const SQLite::Column reason = query.getColumn(5); !reason.isNull())
        row.frame.settled = settled_word(text_of(reason), row.frame);
      if (const SQLite::Column sender = query.getColumn(6); !sender.isNull())
        row.frame.sender = SenderName(text_of(sender));
      if (row.frame.source < heard_.size()) heard_[row.frame.source] = true;
    }
    ended_ = page_.empty();
    return {};
  });
}

Result<bool> FrameReader::next(StoredFrame& frame) {
  if (at_ == page_.size()) {
    if (ended_) return false;
    if (auto filled = fill(); !filled) return filled.error();
    if (page_.empty()) return false;
  }
  const Row& row = page_[at_++];
  frame = row.frame;
  frame.bytes = {bytes_.data() + row.begin, row.size};
  return true;
}

}  // namespace leadline::sessions
