#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "core/flow/engine.h"
#include "core/types/result.h"

namespace leadline {

/// Makes the engine, on the thread it will run on. Owns (by value or shared_ptr) all that the engine points
/// to: it lives as long as that thread.
using EngineMaker = std::function<Result<std::unique_ptr<Engine>>()>;

/// A third party's engine on a thread of its own. Each message but RawFrame is copied and handed over, and
/// its facts are waited for, so that their order is that of an engine on the core thread. One that throws,
/// keeps a message longer than `patience`, or says what it must not (fault_of_engine, more than 1000 messages
/// at once) is taken out of service for good: nothing of that answer is passed on, an Alarm is, and its
/// thread is left to itself. No allocation a message.
class WatchedEngine final : public Engine {
 public:
  struct Watch {
    std::string engine, plugin;  ///< names for the operator
    EngineId id = 0;
    std::chrono::milliseconds patience{2000};
  };
  /// Error: the maker refused, threw or kept us waiting.
  [[nodiscard]] static Result<std::unique_ptr<Engine>> start(Watch watch, EngineMaker maker);
  /// Waits at most `patience` for the engine's thread to end.
  ~WatchedEngine() override;

  void take(const Envelope& envelope, EngineOutput& out) override;
  [[nodiscard]] bool in_service() const { return in_service_; }

 private:
  class Desk;
  WatchedEngine(Watch watch, std::shared_ptr<Desk> desk, std::thread thread);
  void take_out(std::string_view reason, const std::string& what, const Envelope& envelope,
                EngineOutput& out);

  Watch watch_;
  std::shared_ptr<Desk> desk_;
  std::thread thread_;
  bool in_service_ = true;
};

}  // namespace leadline
