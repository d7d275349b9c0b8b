#include "sessions/replay/session_source.h"

#include <algorithm>
#include <utility>

namespace leadline::sessions {

Result<SessionSource> SessionSource::open(Session session, std::vector<NamedSource> names,
                                          std::optional<RunId> run) {
  SessionSource source(std::move(session));
  source.names_ = std::move(names);
  const auto runs = source.session_->runs();
  if (!runs) return runs.error();
  std::optional<RunKind> kind;
  for (const Run& found : runs.value()) {
    if (!found.stores_frames || (run && found.id != *run) || (kind && found.kind != *kind)) continue;
    kind = found.kind;
    source.runs_.push_back(found.id);
    source.ends_.push_back(found.last);
  }
  if (source.runs_.empty())
    return Error{run ? "has no run " + std::to_string(*run) + " with frames" : "holds no recorded frames",
                 source.session_->path(), "name a session that something was recorded in"};
  if (auto entered = source.enter_next_run(); !entered) return entered.error();
  return source;
}

Result<void> SessionSource::enter_next_run() {
  const auto sources = session_->sources(runs_[run_]);
  if (!sources) return sources.error();
  ids_.clear();
  for (const auto& recorded : sources.value()) {
    const auto known = std::find_if(names_.begin(), names_.end(),
                                    [&](const NamedSource& n) { return n.name == recorded.info.name; });
    ids_.push_back(known == names_.end() ? kNoSource : known->id);
  }
  frames_.emplace(*session_, runs_[run_]);
  return {};
}

bool SessionSource::next(Chunk& chunk) {
  StoredFrame frame;
  for (;;) {
    if (failure_) return false;
    auto more = frames_->next(frame);
    if (!more) {
      failure_ = more.error();
    } else if (more.value()) {
      break;
    } else if (ends_[run_]) {  // it went on in silence until then
      chunk = Chunk{};
      chunk.arrival = *std::exchange(ends_[run_], std::nullopt);
      return true;
    } else if (++run_ == runs_.size()) {
      --run_;
      return false;
    } else if (auto entered = enter_next_run(); !entered) {
      failure_ = entered.error();
    }
  }
  chunk = Chunk{};
  chunk.source = frame.source < ids_.size() ? ids_[frame.source] : kNoSource;
  chunk.arrival = frame.arrival;
  if (frame.wall != frame.arrival.host()) chunk.wall = frame.wall;
  chunk.bytes = frame.bytes;
  sender_ = frame.sender;
  chunk.sender = sender_.view();
  if (!frame.settled.empty()) {
    chunk.settled = ByteClass::refused;
    chunk.reason = frame.settled;
  } else if (chunk.source == kNoSource) {
    chunk.settled = ByteClass::unknown;
  }
  return true;
}

}  // namespace leadline::sessions
