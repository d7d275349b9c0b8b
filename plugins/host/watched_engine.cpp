#include "plugins/host/watched_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <vector>

#include "plugins/host/message_faults.h"

namespace leadline {
namespace {

constexpr std::size_t kMostAtOnce = 1000;

struct Said {
  Time valid;
  SourceId source = kNoSource;
  Message message;
};

/// Keeps what the engine says; beyond the limit only that there was more.
class Notebook final : public EngineOutput {
 public:
  Notebook() { said.reserve(16); }
  void publish(Time valid, const Message& message, SourceId source) override {
    if (said.size() < kMostAtOnce)
      said.push_back({valid, source, message});
    else
      overflowed = true;
  }
  std::vector<Said> said;
  bool overflowed = false;
};

/// What an exception says, fit for one line.
std::string words_of(const char* what) {
  std::string text(what, std::find(what, what + 120, '\0'));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < 0x20 || c == 0x7F; }, '?');
  return text;
}

}  // namespace

/// What the two threads share. Whoever has the turn owns everything below `turn_`; when the core's patience
/// is at an end the desk belongs to the engine's thread alone.
class WatchedEngine::Desk {
 public:
  explicit Desk(EngineMaker maker) : maker_(std::move(maker)) {}

  Envelope envelope;
  Notebook notebook;
  std::optional<std::string> exception;
  std::optional<Error> refusal;

  /// The engine's thread.
  void work() {
    std::unique_ptr<Engine> engine;
    watch_for_exceptions([&] {
      auto made = maker_();
      if (made)
        engine = std::move(made).value();
      else
        refusal = made.error();
      if (made && !engine) refusal = Error{"made no engine", "", ""};
    });
    while (hand_over(Turn::engines, Turn::cores) && wait_while(Turn::cores) == Turn::engines)
      watch_for_exceptions([&] { engine->take(envelope, notebook); });
    watch_for_exceptions([&] { engine.reset(); });
    hand_over(Turn::leave, Turn::left);
  }

  /// The core's thread: true when the engine has answered; false: it was left alone with the desk.
  bool answered(std::chrono::milliseconds patience) { return wait_while(Turn::engines, patience); }
  bool ask(std::chrono::milliseconds patience) {
    notebook.said.clear();
    hand_over(Turn::cores, Turn::engines);
    return answered(patience);
  }
  /// Only while the core has the turn; true when the thread has ended and can be joined.
  bool dismiss(std::chrono::milliseconds patience) {
    hand_over(Turn::cores, Turn::leave);
    return wait_while(Turn::leave, patience);
  }

 private:
  enum class Turn { engines, cores, leave, left, abandoned };

  template <class Work>
  void watch_for_exceptions(Work work) {
    try {
      work();
    } catch (const std::exception& e) {
      exception = words_of(e.what());
    } catch (...) {
      exception = "something that is no std::exception";
    }
  }

  /// False when the turn is not `from` any more: the desk was abandoned.
  bool hand_over(Turn from, Turn to) {
    {
      const std::lock_guard lock(mutex_);
      if (turn_ != from) return false;
      turn_ = to;
    }
    changed_.notify_all();
    return true;
  }

  /// A short look without sleeping: in a replay the answer is there within microseconds.
  bool seen_soon(Turn turn) const {
    static const int looks = std::thread::hardware_concurrency() > 1 ? 2000 : 0;
    for (int i = 0; i < looks; ++i) {
      if (turn_.load(std::memory_order_acquire) != turn) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
    return false;
  }
  Turn wait_while(Turn turn) {
    if (!seen_soon(turn)) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return turn_ != turn; });
    }
    return turn_;
  }
  bool wait_while(Turn turn, std::chrono::milliseconds patience) {
    if (seen_soon(turn)) return true;
    const auto until = std::chrono::steady_clock::now() + patience;
    std::unique_lock lock(mutex_);
    if (changed_.wait_until(lock, until, [&] { return turn_ != turn; })) return true;
    turn_ = Turn::abandoned;
    return false;
  }

  EngineMaker maker_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<Turn> turn_{Turn::engines};
};

Result<std::unique_ptr<Engine>> WatchedEngine::start(Watch watch, EngineMaker maker) {
  const auto failed = [&](const std::string& what) {
    return Error{
        fmt::format("engine \"{}\" of plugin \"{}\" could not be made: {}", watch.engine, watch.plugin, what),
        "", "choose another engine, or ask the plugin's maker"};
  };
  auto desk = std::make_shared<Desk>(std::move(maker));
  std::thread thread([desk] { desk->work(); });
  if (!desk->answered(watch.patience)) {
    thread.detach();
    return failed(
        fmt::format("it did not answer for {} s", static_cast<double>(watch.patience.count()) / 1e3));
  }
  const auto exception = desk->exception;
  const auto refusal = desk->refusal;
  auto engine = std::unique_ptr<WatchedEngine>(new WatchedEngine(watch, std::move(desk), std::move(thread)));
  if (exception) return failed("it threw " + *exception);
  if (refusal) return failed(refusal->line());
  return std::unique_ptr<Engine>(std::move(engine));
}

WatchedEngine::WatchedEngine(Watch watch, std::shared_ptr<Desk> desk, std::thread thread)
    : watch_(std::move(watch)), desk_(std::move(desk)), thread_(std::move(thread)) {}

WatchedEngine::~WatchedEngine() {
  if (!thread_.joinable()) return;
  if (desk_->dismiss(watch_.patience))
    thread_.join();
  else
    thread_.detach();
}

void WatchedEngine::take(const Envelope& envelope, EngineOutput& out) {
  if (!in_service_ || std::holds_alternative<RawFrame>(envelope.message)) return;
  desk_->envelope = envelope;
  if (!desk_->ask(watch_.patience)) {
    thread_.detach();
    return take_out(
        "blocked",
        fmt::format("it did not answer for {} s", static_cast<double>(watch_.patience.count()) / 1e3),
        envelope, out);
  }
  if (desk_->exception) return take_out("exception", "it threw " + *desk_->exception, envelope, out);
  if (desk_->notebook.overflowed)
    return take_out("flood", fmt::format("it said more than {} messages at once", kMostAtOnce), envelope,
                    out);
  for (const auto& said : desk_->notebook.said)
    if (const auto fault = fault_of_engine(said.message, said.valid, watch_.id); !fault.empty())
      return take_out(fault, fmt::format("it gave a result that cannot be ({})", fault), envelope, out);
  for (const auto& said : desk_->notebook.said) out.publish(said.valid, said.message, said.source);
}

void WatchedEngine::take_out(std::string_view reason, const std::string& what, const Envelope& envelope,
                             EngineOutput& out) {
  in_service_ = false;
  out.publish(envelope.arrival.host(),
              Alarm{Alarm::Priority::alarm, reason,
                    fmt::format("engine \"{}\" of plugin \"{}\" is out of service: {}", watch_.engine,
                                watch_.plugin, what)});
}

}  // namespace leadline
