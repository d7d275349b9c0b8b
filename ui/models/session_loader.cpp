#include "ui/models/session_loader.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "ui/bridge/pulse.h"

namespace leadline::ui {
namespace {

constexpr std::size_t kBatch = 32'768;                         // messages
constexpr auto kFollowEvery = std::chrono::milliseconds(500);  // a recording that goes on

EventMark mark_of(const sessions::Event& event) {
  EventMark mark;
  mark.valid = mark.until = event.arrival ? event.arrival->host() : event.at;
  mark.kind = event.severity == sessions::Severity::alarm     ? EventMark::Kind::alarm
              : event.severity == sessions::Severity::warning ? EventMark::Kind::warning
                                                              : EventMark::Kind::event;
  mark.text = event.text;
  return mark;
}

}  // namespace

SessionLoader::SessionLoader(std::string path, std::vector<ShownRun> runs, ConsoleSetup setup)
    : path_(std::move(path)),
      setup_(std::move(setup)),
      runs_(std::move(runs)),
      next_seq_(runs_.size(), 1),
      history_(setup_),
      indices_(runs_.size()) {
  said_.reserve(kBatch);
  thread_ = std::thread([this] { run(); });
}

SessionLoader::~SessionLoader() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

bool SessionLoader::stopping() const {
  const std::lock_guard lock(mutex_);
  return stop_;
}

std::optional<SessionLoader::Loaded> SessionLoader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(loaded_, std::nullopt);
}

std::optional<std::vector<SpeakerIndex::Last>> SessionLoader::before(std::size_t run,
                                                                     std::uint64_t seq) const {
  const std::lock_guard lock(mutex_);
  if (indices_[run].reaches() < seq) return std::nullopt;
  return indices_[run].before(seq);
}

void SessionLoader::take_events_until(Time t) {
  while (!events_.empty() && events_.back().valid <= t) {
    stops_.push_back(events_.back().valid);
    history_.take(events_.back());
    events_.pop_back();
  }
}

void SessionLoader::take_envelope(std::size_t place, const Envelope& envelope) {
  take_events_until(envelope.arrival.host());
  history_.take(envelope);
  said_.push_back({speaker_of(envelope), envelope.seq});
  next_seq_[place] = envelope.seq + 1;
  ShownRun& run = runs_[place];
  if (run.empty()) run.first = envelope.arrival;
  run.end_seq = std::max(run.end_seq, envelope.seq + 1);
  run.last = std::max(run.last, envelope.arrival);
  const auto* change = std::get_if<ModeChange>(&envelope.message);
  const auto* health = std::get_if<Health>(&envelope.message);
  if ((change != nullptr && change->engine == setup_.shown) ||
      std::holds_alternative<Alarm>(envelope.message) ||
      (health != nullptr && health->level == Health::Level::warning))
    stops_.push_back(envelope.arrival.host());
}

void SessionLoader::hand_over(std::size_t place, bool run_done) {
  const bool last = place + 1 == runs_.size(), complete = run_done && last;
  History more = history_.take_new();
  more.complete = complete;
  for (const EventMark& mark : more.events)
    if (mark.kind == EventMark::Kind::gap) stops_.push_back(mark.until);
  std::sort(stops_.begin(), stops_.end());
  const std::lock_guard lock(mutex_);
  for (const Said& said : said_) indices_[place].add(said.speaker, said.seq);
  indices_[place].reached(run_done && !last ? UINT64_MAX : next_seq_[place]);
  said_.clear();
  if (!loaded_) loaded_.emplace();
  append(loaded_->history, std::move(more));
  loaded_->stops.insert(loaded_->stops.end(), stops_.begin(), stops_.end());
  loaded_->newest = runs_.back();
  loaded_->complete = complete;
  stops_.clear();
}

Result<void> SessionLoader::load_run(sessions::Session& session, std::size_t place) {
  sessions::Reading reading;
  reading.first_seq = next_seq_[place];
  reading.whole = sessions::kinds_of<Solution, FixVerdict, ModeChange, Alarm, Health>();
  reading.heads.set();
  bool stopped = false;
  const auto read = session.read_between(runs_[place].run.id, reading, [&](const Envelope& envelope) {
    take_envelope(place, envelope);
    if (said_.size() < kBatch) return true;
    hand_over(place, false);
    stopped = stopping();
    return !stopped;
  });
  if (!read) return read;
  if (!stopped) hand_over(place, true);
  return {};
}

Result<void> SessionLoader::load(sessions::Session& session) {
  for (std::size_t place = 0; place < runs_.size() && !stopping(); ++place) {
    if (place > 0) history_.recording_goes_on(runs_[place].first.host());
    if (auto loaded = load_run(session, place); !loaded) return loaded;
  }
  while (runs_.back().run.end == sessions::RunEnd::open) {
    {
      std::unique_lock lock(mutex_);
      if (wake_.wait_for(lock, kFollowEvery, [&] { return stop_; })) return {};
    }
    const auto before = next_seq_.back();
    sessions::Reading reading;
    reading.first_seq = before;
    reading.whole = sessions::kinds_of<Solution, FixVerdict, ModeChange, Alarm, Health>();
    reading.heads.set();
    const auto read = session.read_between(runs_.back().run.id, reading, [&](const Envelope& envelope) {
      take_envelope(runs_.size() - 1, envelope);
      return true;
    });
    if (!read) return read;
    if (next_seq_.back() != before) hand_over(runs_.size() - 1, true);
  }
  return {};
}

void SessionLoader::run() {
  auto session = sessions::Session::open(path_, sessions::Access::read);
  std::optional<Error> failure;
  if (!session) {
    failure = session.error();
  } else {
    const auto events = session.value().events();
    if (events)
      for (const auto& event : events.value()) {
        // Gaps between recordings are marked from one to the other.
        const EventMark mark = mark_of(event);
        if (event.kind != "gap" && mark.valid >= runs_.front().first.host()) events_.push_back(mark);
      }
    std::stable_sort(events_.begin(), events_.end(),
                     [](const EventMark& a, const EventMark& b) { return a.valid > b.valid; });
    if (const auto loaded = load(session.value()); !loaded) failure = loaded.error();
  }
  if (!failure) return;
  const std::lock_guard lock(mutex_);
  if (!loaded_) loaded_.emplace();
  loaded_->newest = runs_.back();
  loaded_->failure = std::move(failure);
}

}  // namespace leadline::ui
