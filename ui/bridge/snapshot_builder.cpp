#include "ui/bridge/snapshot_builder.h"

#include <algorithm>
#include <span>

namespace leadline::ui {
namespace {

constexpr double kChangeShownS = 10.0;

std::size_t index(Body body) { return static_cast<std::size_t>(body); }

}  // namespace

SnapshotBuilder::SnapshotBuilder(ConsoleSetup setup)
    : setup_(std::move(setup)),
      books_(setup_.sources.size()),
      said_(setup_.engines.size() + 1),
      seen_(setup_.sources.size()) {
  alerts_.reserve(kMostAlerts + 1);
}

void SnapshotBuilder::set_counts(SourceId source, std::uint64_t frames, std::uint64_t refused) {
  if (source < books_.size()) books_[source].set_counts(frames, refused);
}

void SnapshotBuilder::take(const Envelope& envelope) {
  now_ = std::max(now_, envelope.arrival);
  if (const auto* s = std::get_if<Solution>(&envelope.message)) return solution(envelope, *s);
  if (const auto* v = std::get_if<FixVerdict>(&envelope.message)) return verdict(envelope, *v);
  if (const auto* a = std::get_if<Alarm>(&envelope.message)) return alarm(envelope, *a);
  if (const auto* change = std::get_if<ModeChange>(&envelope.message)) {
    if (change->engine != setup_.shown) return;
    availability_.mode = change->to;
    availability_.since = believable(envelope.valid, envelope.arrival);
    availability_.reason.assign(change->reason.view());
    return;
  }
  if (envelope.source >= books_.size()) return;
  books_[envelope.source].take(envelope, setup_.frames_kept);
  if (!std::holds_alternative<RawFrame>(envelope.message))
    review(setup_.sources[envelope.source].body, envelope.arrival);
}

void SnapshotBuilder::solution(const Envelope& envelope, const Solution& solution) {
  const std::size_t place = solution.engine == kShipTrack ? said_.size() - 1 : solution.engine;
  if (place >= said_.size() || (place == said_.size() - 1 && solution.engine != kShipTrack)) return;
  Said& said = said_[place] ? *said_[place] : said_[place].emplace();
  said.solution = solution;
  said.valid = believable(envelope.valid, envelope.arrival);
  said.pulse.beat(said.valid);
  said.recent.add(envelope.arrival);
  if (solution.engine != setup_.shown) return;
  // A change of mode rules; an engine that tells of none has its mode with no since.
  if (solution.mode && availability_.since == Time{}) availability_.mode = solution.mode;
  review_position(envelope.arrival);
}

void SnapshotBuilder::verdict(const Envelope& envelope, const FixVerdict& verdict) {
  if (verdict.engine != setup_.shown || envelope.source >= books_.size()) return;
  seen_[envelope.source] = {verdict, believable(envelope.valid, envelope.arrival)};
  if (books_[envelope.source].usbl() && setup_.sources[envelope.source].body == Body::vehicle)
    beam_ = envelope.source;
  if (!verdict.accepted) return;
  books_[envelope.source].judged(*verdict.accepted);
  if (*verdict.accepted) accepted_ = envelope.source;
}

void SnapshotBuilder::alarm(const Envelope& envelope, const Alarm& alarm) {
  // What is said again is one alert, not two.
  const auto same = std::find_if(alerts_.begin(), alerts_.end(), [&](const Alert& a) {
    return a.source == envelope.source && a.alarm.priority == alarm.priority &&
           a.alarm.reason == alarm.reason && a.alarm.text == alarm.text;
  });
  if (same != alerts_.end()) alerts_.erase(same);
  alerts_.push_back({alarm, believable(envelope.valid, envelope.arrival), envelope.source});
  if (alerts_.size() > kMostAlerts) alerts_.erase(alerts_.begin());
}

SnapshotBuilder::Feeding SnapshotBuilder::choose(Body body, Figure figure, Arrival now) const {
  static constexpr std::array<std::array<Quantity, 3>, kFigures> kQuantitiesOf{{
      {Quantity::heading, Quantity::heading, Quantity::heading},
      {Quantity::bottom_velocity, Quantity::water_velocity, Quantity::course},
      {Quantity::depth, Quantity::pressure, Quantity::pressure},
      {Quantity::attitude, Quantity::attitude, Quantity::attitude},
      {Quantity::altitude, Quantity::bottom_depth, Quantity::bottom_depth},
  }};
  Feeding newest;
  Arrival newest_heard{INT64_MIN};
  for (const Quantity quantity : kQuantitiesOf[static_cast<std::size_t>(figure)]) {
    for (std::size_t i = 0; i < books_.size(); ++i) {
      if (setup_.sources[i].body != body) continue;
      const auto* spoken = books_[i].spoken(quantity);
      if (spoken == nullptr) continue;
      const Feeding this_one{static_cast<SourceId>(i), kNoSource, quantity};
      if (books_[i].alive(quantity, now)) return this_one;
      if (spoken->heard > newest_heard) newest = this_one, newest_heard = spoken->heard;
    }
  }
  return newest;
}

void SnapshotBuilder::change(Fed& fed, const Feeding& by, Arrival now) {
  if (by.source == fed.by.source && by.second == fed.by.second) {
    fed.by = by;
    return;
  }
  if (fed.by.source != kNoSource) {
    fed.before = fed.by;
    fed.changed = now;
  }
  fed.by = by;
}

void SnapshotBuilder::review(Body body, Arrival now) {
  for (std::size_t f = 0; f < kFigures; ++f)
    change(fed_[index(body)][f], choose(body, static_cast<Figure>(f), now), now);
}

/// The engine does not say what it moved by: its mode does, and which fix it used last.
void SnapshotBuilder::review_position(Arrival now) {
  Feeding by;
  const Mode mode = availability_.mode.value_or(Mode::A);
  if (mode != Mode::E1) by.source = accepted_;
  const Feeding& velocity = fed_[index(setup_.navigated)][static_cast<std::size_t>(Figure::velocity)].by;
  const bool reckons = mode == Mode::A || mode == Mode::B || mode == Mode::E1;
  if (reckons && velocity.source != kNoSource && velocity.quantity != Quantity::course &&
      books_[velocity.source].alive(velocity.quantity, now))
    (by.source == kNoSource ? by.source : by.second) = velocity.source;
  if (by.second == by.source) by.second = kNoSource;
  change(position_, by, now);
}

std::string SnapshotBuilder::name_of(const Feeding& feeding) const {
  std::string name = setup_.source_name(feeding.source);
  if (feeding.second != kNoSource) name += " + " + setup_.source_name(feeding.second);
  return name;
}

std::optional<Feed> SnapshotBuilder::feed(const Fed& fed, Time now) const {
  if (fed.by.source == kNoSource) return std::nullopt;
  Feed feed;
  feed.source = name_of(fed.by);
  if (const auto* spoken = books_[fed.by.source].spoken(fed.by.quantity)) {
    feed.valid = *spoken->pulse.last();
    feed.period_s = spoken->pulse.period_s();
  }
  if (fed.changed && seconds(now - fed.changed->host()) < kChangeShownS) {
    feed.was = name_of(fed.before);
    feed.changed = fed.changed->host();
  }
  return feed;
}

void SnapshotBuilder::fill_feeds(BodyState& state, Body body, Time now) const {
  const auto of = [&](Figure figure) -> const Fed& {
    return fed_[index(body)][static_cast<std::size_t>(figure)];
  };
  state.heading = feed(of(Figure::heading), now);
  state.velocity = feed(of(Figure::velocity), now);
  state.depth = feed(of(Figure::depth), now);
  state.attitude = feed(of(Figure::attitude), now);
  const Fed& altitude = of(Figure::altitude);
  if (auto fed = feed(altitude, now))
    state.altitude = {books_[altitude.by.source].spoken(altitude.by.quantity)->value, std::move(*fed)};
}

std::optional<BodyState> SnapshotBuilder::body_state(EngineId engine, Time now) const {
  const auto& said = said_[engine == kShipTrack ? said_.size() - 1 : engine];
  if (!said) return std::nullopt;
  const Body body = setup_.body_of(engine);
  BodyState state;
  state.name = body == Body::ship ? setup_.ship : setup_.vehicle;
  state.engine = setup_.engine_name(engine);
  const Arrival at{now.ns};
  state.rate_hz = said->recent.rate_hz(at);
  const double period_s = said->pulse.period_s();
  if (said->recent.count(at) < 5 && period_s > 0.0)
    state.rate_hz = seconds(now - said->valid) <= 5.0 * period_s ? 1.0 / period_s : 0.0;
  state.valid = said->valid;
  state.solution = said->solution;
  fill_feeds(state, body, now);
  // The position is the engine's: as old as its solution, whoever helped.
  Feed position;
  if (engine == setup_.shown) {
    if (const auto fed = feed(position_, now)) position = *fed;
  } else {
    for (std::size_t i = 0; i < books_.size() && engine == kShipTrack && position.source.empty(); ++i)
      if (setup_.sources[i].body == Body::ship && books_[i].alive(Quantity::position, at))
        position.source = setup_.sources[i].name;
  }
  if (position.source.empty())
    position.source = state.solution.position_source == PositionSource::usbl   ? "usbl"
                      : state.solution.position_source == PositionSource::gnss ? "gnss"
                                                                               : state.engine;
  position.valid = said->valid;
  position.period_s = period_s;
  state.position = std::move(position);
  return state;
}

Snapshot SnapshotBuilder::snapshot(Time now) const {
  Snapshot s;
  s.now = now;
  s.replay = setup_.replay;
  s.dive = setup_.dive, s.file = setup_.file;
  (setup_.navigated == Body::ship ? s.ship : s.vehicle) =
      setup_.shown < setup_.engines.size() ? body_state(setup_.shown, now) : std::nullopt;
  for (std::size_t e = 0; e < setup_.engines.size(); ++e)
    if (e != setup_.shown)
      if (auto other = body_state(static_cast<EngineId>(e), now)) s.others.push_back(std::move(*other));
  if (auto track = body_state(kShipTrack, now)) {
    if (setup_.navigated == Body::ship)
      s.others.push_back(std::move(*track));
    else
      s.ship = std::move(track);
  }
  s.availability = availability_;
  for (std::size_t i = 0; i < books_.size(); ++i)
    s.sources.push_back(books_[i].state(setup_.sources[i], Arrival{now.ns}));
  for (auto alert = alerts_.rbegin(); alert != alerts_.rend(); ++alert)
    s.alerts.push_back({alert->alarm.priority, alert->raised, std::string(alert->alarm.text.view()),
                        setup_.source_name(alert->source)});
  const auto fix_feed = [&](std::size_t source) {
    Feed feed;
    feed.source = setup_.sources[source].name;
    feed.valid = seen_[source]->valid;
    if (const auto* spoken = books_[source].spoken(Quantity::position))
      feed.period_s = spoken->pulse.period_s();
    return feed;
  };
  if (beam_ != kNoSource && seen_[beam_]) s.beam = {seen_[beam_]->verdict.position, fix_feed(beam_)};
  for (std::size_t i = 0; i < books_.size(); ++i) {
    if (setup_.sources[i].body != Body::target || !seen_[i]) continue;
    TargetState target;
    target.name = setup_.sources[i].name;
    target.position = seen_[i]->verdict.position;
    target.depth = seen_[i]->verdict.depth;
    const SourceState state = books_[i].state(setup_.sources[i], Arrival{now.ns});
    // One sigma radius of the telegram, the same in every direction.
    if (state.sigma && state.sigma_unit == "m")
      target.var_north_m2 = target.var_east_m2 = 0.5 * *state.sigma * *state.sigma;
    target.feed = fix_feed(i);
    s.targets.push_back(std::move(target));
  }
  return s;
}

}  // namespace leadline::ui
