#include "sessions/recorder/session_chain.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace leadline::sessions {
namespace {

namespace fs = std::filesystem;

/// dive.leadline, dive-2.leadline, dive-3.leadline ...
std::string name_in_chain(const std::string& first, int place) {
  if (place == 1) return first;
  const fs::path path(first);
  return (path.parent_path() /
          (path.stem().string() + "-" + std::to_string(place) + path.extension().string()))
      .string();
}

int next_free_place(const std::string& first) {
  int place = 1;
  while (fs::exists(name_in_chain(first, place))) ++place;
  return place;
}

std::uint64_t size_of(const std::string& path) {
  std::uint64_t all = 0;
  for (const char* suffix : {"", "-wal"}) {
    std::error_code missing;
    const auto size = fs::file_size(path + suffix, missing);
    if (!missing) all += size;
  }
  return all;
}

struct Opened {
  Session session;
  std::vector<std::string> notes;
};

Result<Opened> create(const std::string& path, const std::string& build, const std::string& predecessor,
                      std::vector<std::string> notes) {
  auto session = Session::create(path, {.force = false, .build = build, .predecessor = predecessor});
  if (!session) return session.error();
  return Opened{std::move(session).value(), std::move(notes)};
}

/// What the last run of a session came to, in words.
Result<std::string> kept_words(Session& session) {
  const auto runs = session.runs();
  if (!runs) return runs.error();
  if (runs.value().empty()) return session.path() + ": holds no run yet";
  const Run& last = runs.value().back();
  const auto frames = session.frame_count(last.id);
  if (!frames) return frames.error();
  std::string words =
      session.path() + ": goes on; its last run kept " + std::to_string(frames.value()) + " frames";
  if (last.last) words += " until " + iso8601(last.last->host(), 3);
  if (last.end != RunEnd::clean)
    words += "; it was not ended: what came less than 250 ms before is lost, and all after";
  return words;
}

Result<Opened> create_or_continue(const std::string& first, const std::string& build) {
  const int free = next_free_place(first);
  if (free == 1) return create(first, build, {}, {});
  const std::string path = name_in_chain(first, free - 1);
  auto session = Session::open(path, Access::append);
  if (session) {
    auto kept = kept_words(session.value());
    if (!kept) return kept.error();
    return Opened{std::move(session).value(), {std::move(kept).value()}};
  }
  // Only what is damaged is moved away: a name that is taken by something else is the operator's to judge.
  if (session.error().what.find("damaged") == std::string::npos) return session.error();
  const auto moved = Session::set_aside(path);
  if (!moved) return moved.error();
  return create(
      path, build, {},
      {session.error().line(), path + ": a new session is begun; the damaged one is " + moved.value()});
}

}  // namespace

Result<SessionChain::Begun> SessionChain::begin(const std::string& path, const RunInfo& info,
                                                const Recorder::Options& options, const Limits& limits) {
  auto opened = create_or_continue(path, info.build);
  if (!opened) return opened.error();
  const std::string name = opened.value().session.path();
  auto recorder = Recorder::start(std::move(opened.value().session), info, options);
  if (!recorder) return recorder.error();
  Begun begun;
  begun.notes = std::move(opened.value().notes);
  begun.chain.reset(new SessionChain(path, name, info, options, limits, std::move(recorder).value()));
  return begun;
}

SessionChain::SessionChain(std::string name, std::string path, RunInfo info, const Recorder::Options& options,
                           const Limits& limits, std::unique_ptr<Recorder> recorder)
    : name_(std::move(name)),
      path_(std::move(path)),
      info_(std::move(info)),
      options_(options),
      limits_(limits),
      recorder_(std::move(recorder)) {}

SessionChain::~SessionChain() { (void)finish(); }

void SessionChain::take(const Envelope& envelope) {
  if (!first_) first_ = envelope.arrival;
  last_ = envelope.arrival;
  recorder_->take(envelope);
}

void SessionChain::event(Severity severity, std::string kind, std::string text) {
  recorder_->event(severity, std::move(kind), std::move(text));
}

Result<std::optional<std::string>> SessionChain::look() {
  const bool full = first_ && *last_ - *first_ >= limits_.span;
  if (!full && size_of(path_) < limits_.bytes) return std::optional<std::string>();
  end_old();  // of the change before this one, long since done
  const std::string next = name_in_chain(name_, next_free_place(name_));
  auto session = Session::create(
      next, {.force = false, .build = info_.build, .predecessor = fs::path(path_).filename().string()});
  if (!session) return session.error();
  auto recorder = Recorder::start(std::move(session).value(), info_, options_);
  if (!recorder) return recorder.error();
  recorder_->event(Severity::note, "continued", "goes on in " + fs::path(next).filename().string());
  old_ = std::exchange(recorder_, std::move(recorder).value());
  path_ = next;
  first_.reset();
  ending_ = std::thread([this] {
    if (const auto done = old_->finish(); !done) old_failure_ = done.error();
  });
  return std::optional(next);
}

void SessionChain::end_old() {
  if (!ending_.joinable()) return;
  ending_.join();
  const auto status = old_->status();
  before_.acknowledged += status.acknowledged;
  before_.durable += status.durable;
  before_.facts_left_out += status.facts_left_out;
  before_.frames_left_out += status.frames_left_out;
  before_.most_waiting_bytes = std::max(before_.most_waiting_bytes, status.most_waiting_bytes);
  old_.reset();
}

Recorder::Status SessionChain::status() const {
  Recorder::Status all = recorder_->status();
  const auto add = [&](const Recorder::Status& other) {
    all.acknowledged += other.acknowledged;
    all.durable += other.durable;
    all.facts_left_out += other.facts_left_out;
    all.frames_left_out += other.frames_left_out;
    all.most_waiting_bytes = std::max(all.most_waiting_bytes, other.most_waiting_bytes);
  };
  add(before_);
  if (old_) add(old_->status());
  return all;
}

Result<void> SessionChain::finish() {
  end_old();
  const auto done = recorder_->finish();
  if (!done) return done;
  if (old_failure_) return *old_failure_;
  return {};
}

}  // namespace leadline::sessions
