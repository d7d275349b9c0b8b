#include "ui/models/session_player.h"

#include <algorithm>
#include <map>
#include <utility>

namespace leadline::ui {
namespace {

constexpr Duration kWindow = std::chrono::seconds(20);
constexpr int kMostAtOnce = 20'000;           // messages an advance; the next one goes on
constexpr int kTail = 64;                     // of a kind, to find out who speaks
constexpr int kRemembered = Pulse::kBeats;    // of a speaker: a period, and more than eight fixes
constexpr std::uint64_t kLookBack = 131'072;  // how far a speaker is searched for without the index

template <class M>
std::size_t kind_of() {
  static const std::size_t kind = Message(M{}).index();
  return kind;
}

const sessions::Kinds& shown_kinds() {
  static const sessions::Kinds kinds =
      sessions::Kinds().set() & ~sessions::kinds_of<Health, Tick, ClockReading>();
  return kinds;
}

bool by_seq(const Envelope& a, const Envelope& b) { return a.seq < b.seq; }

}  // namespace

SessionPlayer::SessionPlayer(sessions::Session session, std::vector<ShownRun> runs, const ConsoleSetup& setup)
    : session_(std::move(session)), runs_(std::move(runs)), builder_(setup), met_(runs_.size()) {
  history_.first = runs_.front().first.host();
  history_.last = runs_.back().last.host();
}

Result<std::unique_ptr<SessionPlayer>> SessionPlayer::open(const std::string& path,
                                                           std::vector<ShownRun> runs, ConsoleSetup setup) {
  LL_EXPECT(!runs.empty());
  auto session = sessions::Session::open(path, sessions::Access::read);
  if (!session) return session.error();
  std::unique_ptr<SessionPlayer> player(
      new SessionPlayer(std::move(session).value(), std::move(runs), setup));
  const ShownRun& newest = player->runs_.back();
  auto built = player->rebuild({player->runs_.size() - 1, newest.end_seq}, newest.last.host());
  if (!built) return built.error();
  player->loader_ = std::make_unique<SessionLoader>(path, player->runs_, std::move(setup));
  return player;
}

TimeSpan SessionPlayer::run() const { return {runs_.front().first.host(), runs_.back().last.host()}; }

void SessionPlayer::look() { snapshot_ = builder_.snapshot(head_); }

void SessionPlayer::fail(const Error& error) {
  failure_ = error;
  playing_ = false;
}

bool SessionPlayer::go(const Result<void>& result) {
  if (!result) fail(result.error());
  return result.ok();
}

// --- the state at a place
// -----------------------------------------------------------------------------------

Result<SessionPlayer::Position> SessionPlayer::position_at(Time time) {
  std::size_t run = runs_.size() - 1;
  while (run > 0 && runs_[run].first.host() > time) --run;
  const auto seq = session_.seek_after(runs_[run].run.id, Arrival{time.ns});
  if (!seq) return seq.error();
  return Position{run, seq.value()};
}

/// Where the index is asked: of a run that is over, behind its last block.
std::uint64_t SessionPlayer::index_place(std::size_t run, std::uint64_t seq) const {
  const bool over = run + 1 < runs_.size() && seq >= runs_[run].end_seq;
  return over ? SpeakerIndex::block_begin(seq) + 2 * SpeakerIndex::kBlock : seq;
}

Result<void> SessionPlayer::gather(std::size_t run, std::uint64_t seq, std::vector<Envelope>& seeds) {
  const sessions::RunId id = runs_[run].run.id;
  std::map<KindSpeaker, std::vector<Envelope>> last;
  std::set<KindSpeaker>& met = met_[run];
  std::map<KindSpeaker, std::uint64_t> silent;  // where the index knows them
  if (loader_)
    if (const auto known = loader_->before(run, index_place(run, seq)))
      for (const auto& speaker : *known) met.insert(speaker.speaker), silent[speaker.speaker] = speaker.seq;
  sessions::Kinds whole_tables;  // of which the tail is everything
  for (std::size_t kind = 0; kind < shown_kinds().size(); ++kind) {
    if (!shown_kinds().test(kind)) continue;
    auto tail = session_.read_last(id, kind, seq, kTail);
    if (!tail) return tail.error();
    whole_tables.set(kind, tail.value().size() < kTail);
    for (Envelope& envelope : tail.value()) {
      const KindSpeaker speaker = speaker_of(envelope);
      met.insert(speaker);
      last[speaker].push_back(std::move(envelope));
    }
  }
  for (const KindSpeaker& speaker : met) {
    auto& its = last[speaker];
    if (its.size() >= static_cast<std::size_t>(kRemembered) || whole_tables.test(speaker.kind) ||
        !shown_kinds().test(speaker.kind))
      continue;
    sessions::Speaker who;
    if (speaker.source != kNoSource) who.source = speaker.source;
    who.engine = speaker.engine;
    // From its last word on, where that is known: what others said since is not read.
    const auto place = silent.find(speaker);
    const std::uint64_t end = place == silent.end() ? seq : place->second + 1;
    const std::uint64_t floor = end > kLookBack ? end - kLookBack : 0;
    auto more = session_.read_last(id, speaker.kind, end, kRemembered, who, floor);
    if (!more) return more.error();
    if (more.value().size() > its.size()) its = std::move(more).value();
  }
  for (auto& [speaker, its] : last) {
    const bool alarms = speaker.kind == kind_of<Alarm>();
    const std::size_t most = alarms ? its.size() : static_cast<std::size_t>(kRemembered);
    const auto from = its.size() > most ? its.end() - static_cast<std::ptrdiff_t>(most) : its.begin();
    std::move(from, its.end(), std::back_inserter(seeds));
  }
  std::sort(seeds.begin(), seeds.end(), by_seq);
  return {};
}

/// Frames and refusals of each source before `seq` of a run, as far as the index reaches.
void SessionPlayer::count_until(std::size_t run, std::uint64_t seq, SnapshotBuilder& builder) const {
  const std::size_t sources = builder.setup().sources.size();
  std::vector<std::uint64_t> frames(sources), refused(sources);
  for (std::size_t r = 0; r <= run && loader_; ++r) {
    const auto known = loader_->before(r, index_place(r, r < run ? runs_[r].end_seq : seq));
    if (!known) break;
    for (const auto& last : *known) {
      if (last.speaker.source >= sources) continue;
      if (last.speaker.kind == kind_of<RawFrame>()) frames[last.speaker.source] += last.count;
      if (last.speaker.kind == kind_of<Rejected>()) refused[last.speaker.source] += last.count;
    }
  }
  for (std::size_t i = 0; i < sources; ++i)
    builder.set_counts(static_cast<SourceId>(i), frames[i], refused[i]);
}

Result<void> SessionPlayer::rebuild(Position position, Time head) {
  const sessions::RunId id = runs_[position.run].run.id;
  const auto window = session_.seek_after(id, Arrival{(head - kWindow).ns});
  if (!window) return window.error();
  const std::uint64_t from = SpeakerIndex::block_begin(std::min(window.value(), position.seq));
  SnapshotBuilder builder(builder_.setup());
  for (std::size_t run = position.run == 0 ? 0 : position.run - 1; run <= position.run; ++run) {
    std::vector<Envelope> seeds;
    const std::uint64_t until = run == position.run ? from : runs_[run].end_seq;
    if (auto gathered = gather(run, until, seeds); !gathered) return gathered;
    for (const Envelope& seed : seeds) builder.take(seed);
  }
  count_until(position.run, from, builder);
  sessions::Reading reading;
  reading.first_seq = from, reading.end_seq = position.seq, reading.whole = shown_kinds();
  auto read = session_.read_between(id, reading, [&](const Envelope& envelope) {
    builder.take(envelope);
    return true;
  });
  if (!read) return read;
  builder_ = std::move(builder);
  position_ = position;
  head_ = head;
  look();
  return {};
}

// --- moving
// -------------------------------------------------------------------------------------------------

void SessionPlayer::set_speed(std::optional<double> factor) {
  speed_ = factor ? std::optional(std::clamp(*factor, kSlowest, kFastest)) : std::nullopt;
}

void SessionPlayer::play() {
  if (failure_) return;
  if (head_ >= run().until && !grows_) seek(loop_ ? loop_->from : run().from);
  playing_ = !failure_;
}

void SessionPlayer::seek(Time time) {
  const TimeSpan all = run();
  time = std::clamp(time, all.from, all.until);
  failure_.reset();
  const auto position = position_at(time);
  if (!position) return fail(position.error());
  (void)go(rebuild(position.value(), time));
}

void SessionPlayer::set_loop(std::optional<TimeSpan> loop) {
  loop_ = loop;
  if (!loop_) return;
  loop_->from = std::max(loop_->from, run().from);
  loop_->until = std::min(loop_->until, run().until);
  if (loop_->until <= loop_->from) loop_.reset();
}

Result<bool> SessionPlayer::play_until(Time target, int most) {
  for (int taken = 0;;) {
    bool later = false;
    sessions::Reading reading;
    reading.first_seq = position_.seq, reading.whole = shown_kinds();
    const auto read =
        session_.read_between(runs_[position_.run].run.id, reading, [&](const Envelope& envelope) {
          later = envelope.arrival.host() > target;
          if (later || taken >= most) return false;
          builder_.take(envelope);
          met_[position_.run].insert(speaker_of(envelope));
          position_.seq = envelope.seq + 1;
          head_ = std::max(head_, envelope.arrival.host());
          ++taken;
          return true;
        });
    if (!read) return read.error();
    if (!later && taken >= most) return false;
    if (later || position_.run + 1 == runs_.size() || runs_[position_.run + 1].first.host() > target) break;
    position_ = {position_.run + 1, 1};
  }
  head_ = std::max(head_, std::min(target, run().until));
  return true;
}

Result<void> SessionPlayer::play_with(std::size_t run, std::uint64_t seq) {
  sessions::Reading reading;
  reading.first_seq = position_.seq, reading.end_seq = seq + 1, reading.whole = shown_kinds();
  auto read = session_.read_between(runs_[run].run.id, reading, [&](const Envelope& envelope) {
    builder_.take(envelope);
    met_[run].insert(speaker_of(envelope));
    head_ = std::max(head_, envelope.arrival.host());
    return true;
  });
  if (!read) return read;
  position_ = {run, seq + 1};
  return {};
}

bool SessionPlayer::advance(Duration wall) {
  if (!playing_ || wall.count() <= 0) return false;
  const Time until = loop_ ? loop_->until : run().until;
  if (loop_ && (head_ >= loop_->until || head_ < loop_->from)) {
    seek(loop_->from);
    return true;
  }
  const double room_ns = static_cast<double>((until - head_).count());
  const double step_ns = speed_ ? static_cast<double>(wall.count()) * *speed_ : room_ns;
  const Time target = step_ns >= room_ns ? until : head_ + Duration(static_cast<std::int64_t>(step_ns));
  const auto there = play_until(target, kMostAtOnce);
  if (!there) {
    fail(there.error());
  } else if (!loop_ && there.value() && head_ >= run().until && !grows_) {
    playing_ = false;
  }
  look();
  return true;
}

void SessionPlayer::step_forward() {
  playing_ = false;
  for (std::size_t run = position_.run; run < runs_.size() && !failure_; ++run) {
    sessions::Reading reading;
    reading.first_seq = run == position_.run ? position_.seq : 1;
    reading.whole = sessions::kinds_of<Solution>();
    std::optional<std::uint64_t> next;
    const auto read = session_.read_between(runs_[run].run.id, reading, [&](const Envelope& envelope) {
      if (std::get<Solution>(envelope.message).engine == setup().shown) next = envelope.seq;
      return !next;
    });
    if (!go(read)) return;
    if (!next) continue;
    for (; position_.run < run; position_ = {position_.run + 1, 1})
      if (!go(play_with(position_.run, runs_[position_.run].end_seq))) return;
    if (go(play_with(run, *next))) look();
    return;
  }
}

void SessionPlayer::step_back() {
  playing_ = false;
  const sessions::Speaker shown{{}, setup().shown};
  for (std::size_t run = position_.run + 1; run-- > 0;) {
    const bool here = run == position_.run;
    const auto last = session_.read_last(runs_[run].run.id, kind_of<Solution>(),
                                         here ? position_.seq : UINT64_MAX, 2, shown);
    if (!last) return fail(last.error());
    auto found = last.value();
    if (here && !found.empty() && found.back().seq + 1 == position_.seq) found.pop_back();
    if (found.empty()) continue;
    (void)go(rebuild({run, found.back().seq + 1}, found.back().arrival.host()));
    return;
  }
}

bool SessionPlayer::next_event() {
  const auto next = std::upper_bound(stops_.begin(), stops_.end(), head_);
  if (next == stops_.end() || *next > run().until) return false;
  seek(*next);
  return true;
}

bool SessionPlayer::previous_event() {
  const auto next = std::lower_bound(stops_.begin(), stops_.end(), head_);
  if (next == stops_.begin() || *std::prev(next) < run().from) return false;
  seek(*std::prev(next));
  return true;
}

bool SessionPlayer::take_loaded() {
  auto loaded = loader_->take();
  if (!loaded) return false;
  const bool was_complete = history_.complete;
  append(history_, std::move(loaded->history));
  history_.complete = loaded->complete;
  if (loaded->newest.end_seq > runs_.back().end_seq) {
    runs_.back() = loaded->newest;
    grows_ = true;
  }
  history_.first = runs_.front().first.host();
  history_.last = std::max(history_.last, runs_.back().last.host());
  const auto old = static_cast<std::ptrdiff_t>(stops_.size());
  stops_.insert(stops_.end(), loaded->stops.begin(), loaded->stops.end());
  std::sort(stops_.begin() + old, stops_.end());
  std::inplace_merge(stops_.begin(), stops_.begin() + old, stops_.end());
  if (loaded->failure) fail(*loaded->failure);
  // Who has been silent for long is known now.
  if (history_.complete && !was_complete && !failure_) (void)go(rebuild(position_, head_));
  return true;
}

}  // namespace leadline::ui
