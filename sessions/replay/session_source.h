#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/flow/source.h"
#include "sessions/store/frames.h"

namespace leadline::sessions {

/// A configured source by name, for the frames of a session.
struct NamedSource {
  std::string name;
  SourceId id = kNoSource;
};

/// A session as a Source: its raw frames with the arrivals they were heard at, so that a replay is the run
/// again. Plays every run that stores frames and is of the kind of the first such (a recording that was
/// continued is one timeline), or one run alone. Reads a page at a time.
class SessionSource final : public Source {
 public:
  /// names: the configured sources; a frame of any other name is settled as unknown. Error: no such run, or
  /// no run that stores frames.
  [[nodiscard]] static Result<SessionSource> open(Session session, std::vector<NamedSource> names,
                                                  std::optional<RunId> run = {});

  bool next(Chunk& chunk) override;
  /// Why it ended before its end: the file is damaged there.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
  [[nodiscard]] const std::vector<RunId>& runs() const { return runs_; }

 private:
  explicit SessionSource(Session session) : session_(std::make_unique<Session>(std::move(session))) {}
  [[nodiscard]] Result<void> enter_next_run();

  std::unique_ptr<Session> session_;  // the reader keeps its address
  std::vector<NamedSource> names_;
  std::vector<RunId> runs_;
  std::vector<std::optional<Arrival>> ends_;  // of these, until they were told
  std::size_t run_ = 0;
  std::optional<FrameReader> frames_;
  std::vector<SourceId> ids_;  // of this run's sources, by place
  SenderName sender_;          // of the latest chunk
  std::optional<Error> failure_;
};

}  // namespace leadline::sessions
