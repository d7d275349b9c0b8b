#include "sessions/recorder/recorder.h"

#include <algorithm>
#include <utility>

namespace leadline::sessions {
namespace {

using namespace std::chrono_literals;

constexpr auto kPace = 100ms;          // between commits; with the commit itself well below 250 ms
constexpr auto kLongestBatch = 100ms;  // of inserting, then it is committed
constexpr auto kFullEvery = 900ms;     // so that with one pace it is below 1 s
constexpr auto kRetry = 500ms;

Time wall_now() {
  return {std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::start(Session session, const RunInfo& info,
                                                  const Options& options) {
  const auto run = session.begin_run(info);
  if (!run) return run.error();
  return std::unique_ptr<Recorder>(new Recorder(std::move(session), run.value(), options));
}

Recorder::Recorder(Session session, RunId run, const Options& options)
    : session_(std::move(session)),
      run_(run),
      options_(options),
      queue_(options.memory_bytes),
      last_full_(Steady::now()) {
  writer_ = std::thread([this] { write_until_finished(); });
}

Recorder::~Recorder() { (void)finish(); }

void Recorder::take(const Envelope& envelope) {
  const bool frame = std::holds_alternative<RawFrame>(envelope.message);
  std::unique_lock lock(mutex_);
  latest_ = envelope.arrival;
  if (std::holds_alternative<Tick>(envelope.message)) return;
  // Facts can be decoded again from their frames: the last quarter of the memory is the frames'.
  const bool squeezed = !options_.lossless && !frame && queue_.bytes() > queue_.most_bytes() / 4 * 3;
  bool kept = !gave_up_ && !squeezed && queue_.push(envelope);
  if (!kept && options_.lossless && !gave_up_) {
    work_.notify_one();
    kept = room_.wait_for(lock, options_.patience, [&] { return queue_.push(envelope); });
    gave_up_ = !kept;
  }
  if (!kept) ++(frame ? frames_left_out_ : facts_left_out_);
  if (std::holds_alternative<Alarm>(envelope.message)) urgent_ = true;
  most_waiting_ = std::max(most_waiting_, queue_.bytes());
  const bool pressing = urgent_ || queue_.bytes() > queue_.most_bytes() / 8;
  lock.unlock();
  if (pressing) work_.notify_one();
}

void Recorder::event(Severity severity, std::string kind, std::string text) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back({wall_now(), latest_, severity, std::move(kind), std::move(text)});
  }
  work_.notify_one();
}

Recorder::Status Recorder::status() const {
  const std::lock_guard lock(mutex_);
  return {acknowledged_.load(), durable_.load(),  queue_.bytes(), most_waiting_,
          facts_left_out_,      frames_left_out_, failure_};
}

bool Recorder::due_full() const { return Steady::now() - last_full_ >= kFullEvery; }

/// Blocks before `blocks` are written; the next one up to `read_to`.
void Recorder::release(std::size_t blocks, std::size_t read_to) {
  {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < blocks; ++i) {
      queue_.give_back(std::move(batch_.front()));
      batch_.pop_front();
    }
  }
  if (!batch_.empty()) batch_.front().read = read_to;
  room_.notify_all();
}

void Recorder::rewind(std::size_t read_from) {
  for (auto& block : batch_) block.read = 0;
  if (!batch_.empty()) batch_.front().read = read_from;
}

/// One transaction of as much as kLongestBatch allows. After an Error everything is as before.
Result<void> Recorder::write_batch(Sync sync, const std::vector<Event>& events) {
  const auto begun = Steady::now();
  const std::size_t read_from = batch_.empty() ? 0 : batch_.front().read;
  std::optional<Arrival> first = first_, last = last_;
  std::uint64_t frames = frames_, count = 0;
  std::size_t blocks = 0;
  Envelope space;
  auto done = session_.begin(sync);
  for (const Event& event : events)
    if (done) done = session_.put(event);
  bool stop = !done;
  while (!stop && blocks < batch_.size()) {
    const Envelope* envelope = MessageQueue::next(batch_[blocks], space);
    if (envelope == nullptr) {
      ++blocks;
      continue;
    }
    done = session_.put(*envelope);
    if (!first) first = envelope->arrival;
    last = envelope->arrival;
    if (std::holds_alternative<RawFrame>(envelope->message)) ++frames;
    // Looking at the clock costs as much as a small row.
    stop = !done || (++count % 64 == 0 && Steady::now() - begun > kLongestBatch);
  }
  if (done && sync == Sync::full) done = session_.put_progress(first, last);
  if (done) done = session_.commit();
  if (!done) {
    session_.rollback();
    rewind(read_from);
    return done;
  }
  first_ = first, last_ = last, frames_ = frames;
  release(blocks, blocks < batch_.size() ? batch_[blocks].read : 0);
  acknowledged_.store(frames_, std::memory_order_release);
  if (sync == Sync::full) {
    durable_.store(frames_, std::memory_order_release);
    last_full_ = Steady::now();
  }
  return {};
}

void Recorder::write_until_finished() {
  std::vector<Event> events;
  bool failing = false, alarmed = false;
  for (;;) {
    bool finishing = false;
    {
      std::unique_lock lock(mutex_);
      const auto pressing = [&] {
        return finishing_ ||
               (!failing && (urgent_ || !events_.empty() || queue_.bytes() > queue_.most_bytes() / 8));
      };
      if (failing || (batch_.empty() && !pressing()))
        work_.wait_for(lock, failing ? kRetry : kPace, pressing);
      finishing = finishing_;
      alarmed = std::exchange(urgent_, false) || (alarmed && failing);
      queue_.take_all(batch_);
      events.insert(events.end(), std::make_move_iterator(events_.begin()),
                    std::make_move_iterator(events_.end()));
      events_.clear();
      if (frames_left_out_ != left_out_told_ && !failing) {
        events.push_back({wall_now(), latest_, Severity::alarm, "gap",
                          "gap: " + std::to_string(frames_left_out_ - left_out_told_) +
                              " frames were not kept: the disk refused for too long"});
        left_out_told_ = frames_left_out_;
      }
    }
    const bool urgent = alarmed || !events.empty();
    const bool unsynced = durable_.load() != acknowledged_.load();
    const bool anything = !batch_.empty() || urgent;
    if (anything || (unsynced && due_full())) {
      const auto done = write_batch(urgent || finishing || due_full() ? Sync::full : Sync::normal, events);
      if (done) events.clear();
      if (done && failing)
        events.push_back({wall_now(), last_, Severity::warning, "disk",
                          "the disk takes data again; what waited was written"});
      failing = !done;
      const std::lock_guard lock(mutex_);
      failure_ = done ? std::nullopt : std::optional(done.error());
      if (failing && finishing) return;
    } else if (finishing) {
      return;
    }
  }
}

Result<void> Recorder::finish() {
  if (finished_) return {};
  finished_ = true;
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
  }
  work_.notify_all();
  room_.notify_all();
  writer_.join();
  if (failure_) return *failure_;
  if (gave_up_ || frames_left_out_ > 0)
    return Error{std::to_string(frames_left_out_) + " frames were not kept: the disk refused for too long",
                 session_.path(), "free some space, then do it again"};
  auto ended = session_.end_run(wall_now(), first_, latest_ ? latest_ : last_);
  if (ended) ended = session_.fold();
  return ended;
}

}  // namespace leadline::sessions
