#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sessions/recorder/recorder.h"

namespace leadline::sessions {

/// A recording that goes on for weeks: a session a day or each 2 GiB, the next one named NAME-2, NAME-3 ...
/// and naming its predecessor. Begins or continues: a session that is there already gets one more run with a
/// gap mark, in the last file of its chain; a damaged one is moved away and a new one begun.
class SessionChain final : public Sink {
 public:
  struct Limits {
    Duration span{24 * 3'600'000'000'000};
    std::uint64_t bytes = std::uint64_t{2} << 30;
  };
  struct Begun {
    std::unique_ptr<SessionChain> chain;
    std::vector<std::string> notes;  ///< what was found, kept and lost: sentences for the operator
  };
  /// Error: the folder takes no file, another program records into it, a newer schema.
  [[nodiscard]] static Result<Begun> begin(const std::string& path, const RunInfo& info,
                                           const Recorder::Options& options, const Limits& limits);
  static Result<Begun> begin(const std::string& path, const RunInfo& info, const Recorder::Options& options) {
    return begin(path, info, options, Limits{});
  }
  ~SessionChain() override;

  void take(const Envelope& envelope) override;
  /// Once a second, on the thread of take(): begins the next session when this one is full. The name of the
  /// next, where one was begun.
  [[nodiscard]] Result<std::optional<std::string>> look();
  void event(Severity severity, std::string kind, std::string text);

  [[nodiscard]] const std::string& path() const { return path_; }  ///< of the session that is written
  [[nodiscard]] Recorder::Status status()
      const;  ///< of all of them together; waiting and failure of this one
  [[nodiscard]] Result<void> finish();

 private:
  SessionChain(std::string name, std::string path, RunInfo info, const Recorder::Options& options,
               const Limits& limits, std::unique_ptr<Recorder> recorder);
  void end_old();

  std::string name_, path_;  // the first of the chain, and this one
  RunInfo info_;
  Recorder::Options options_;
  Limits limits_;
  std::unique_ptr<Recorder> recorder_, old_;
  std::thread ending_;  // writes what the old one still holds
  std::optional<Error> old_failure_;
  Recorder::Status before_;  // of sessions that are closed
  std::optional<Arrival> first_, last_;
};

}  // namespace leadline::sessions
