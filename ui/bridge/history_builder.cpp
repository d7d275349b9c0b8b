#include "ui/bridge/history_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "ui/bridge/pulse.h"

namespace leadline::ui {
namespace {

template <class T>
void move_behind(std::vector<T>& to, std::vector<T>&& more) {
  if (to.empty())
    to = std::move(more);
  else
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

template <class T>
void keep_newest(std::vector<T>& all, std::size_t most) {
  if (most > 0 && all.size() > 2 * most)
    all.erase(all.begin(), all.end() - static_cast<std::ptrdiff_t>(most));
}

EventMark::Kind kind_of(Alarm::Priority priority) {
  return priority == Alarm::Priority::caution   ? EventMark::Kind::caution
         : priority == Alarm::Priority::warning ? EventMark::Kind::warning
                                                : EventMark::Kind::alarm;
}

}  // namespace

void append(History& to, History&& more) {
  for (Track& track : more.tracks) {
    const auto known = std::find_if(to.tracks.begin(), to.tracks.end(),
                                    [&](const Track& t) { return t.engine == track.engine; });
    if (known == to.tracks.end())
      to.tracks.push_back(std::move(track));
    else
      move_behind(known->points, std::move(track.points));
  }
  move_behind(to.fixes, std::move(more.fixes));
  move_behind(to.modes, std::move(more.modes));
  move_behind(to.events, std::move(more.events));
  const Time none{};
  if (to.first == none) to.first = more.first;
  to.last = std::max(to.last, more.last);
  to.complete = more.complete;
}

HistoryBuilder::HistoryBuilder(ConsoleSetup setup, std::size_t most_points)
    : setup_(std::move(setup)),
      most_points_(most_points),
      engines_(setup_.engines.size() + 1),
      unused_(setup_.sources.size(), Time{INT64_MIN / 2}) {
  fresh_.complete = true;
}

HistoryBuilder::Engine& HistoryBuilder::engine(EngineId id) {
  return engines_[std::min<std::size_t>(id, engines_.size() - 1)];
}

Track& HistoryBuilder::track(EngineId id) {
  const auto known = std::find_if(fresh_.tracks.begin(), fresh_.tracks.end(),
                                  [&](const Track& t) { return t.engine == id; });
  if (known != fresh_.tracks.end()) return *known;
  return fresh_.tracks.emplace_back(Track{id, setup_.engine_name(id), setup_.body_of(id), {}});
}

void HistoryBuilder::event(EventMark mark) {
  fresh_.events.push_back(std::move(mark));
  keep_newest(fresh_.events, most_points_);
}

void HistoryBuilder::gap(Arrival arrival) {
  if (last_) {
    const double silent_s = seconds(arrival - *last_);
    const double usual_s = heard_ > 1 ? seconds(*last_ - *first_) / static_cast<double>(heard_ - 1) : 0.0;
    if (silent_s > kGapS && silent_s > 5.0 * usual_s) {
      char words[48];
      std::snprintf(words, sizeof words, "nothing heard for %.0f s", silent_s);
      event({last_->host(), arrival.host(), EventMark::Kind::gap, words});
    }
  }
  if (!first_) {
    first_ = arrival;
    fresh_.first = arrival.host();
  }
  last_ = std::max(last_.value_or(arrival), arrival);
  fresh_.last = last_->host();
  ++heard_;
}

void HistoryBuilder::recording_goes_on(Time first) {
  if (last_ && first > last_->host())
    event({last_->host(), first, EventMark::Kind::gap, "the recording ended and went on"});
  last_ = Arrival{std::max(first.ns, last_ ? last_->ns : first.ns)};
}

void HistoryBuilder::solution(const Envelope& envelope, const Solution& solution) {
  if (solution.engine != kShipTrack && solution.engine >= setup_.engines.size()) return;
  if (!std::isfinite(solution.position.lat.rad()) || !std::isfinite(solution.position.lon.rad())) return;
  Engine& of = engine(solution.engine);
  const double var_m2 = solution.var_north_m2 + solution.var_east_m2;
  const TrackPoint point{believable(envelope.valid, envelope.arrival), solution.position,
                         var_m2 > 0.0 ? static_cast<float>(std::sqrt(var_m2)) : 0.0F};
  if (of.last && point.valid < of.last->valid) return;
  of.last = point;
  if (++of.skipped < of.stride) return;
  of.skipped = 0;
  auto& points = track(solution.engine).points;
  points.push_back(point);
  if (most_points_ == 0 || points.size() < most_points_) return;
  of.stride *= 2;
  for (std::size_t i = 1; 2 * i < points.size(); ++i) points[i] = points[2 * i];
  points.resize((points.size() + 1) / 2);
}

void HistoryBuilder::take(const Envelope& envelope) {
  if (std::holds_alternative<Tick>(envelope.message)) return;
  gap(envelope.arrival);
  const Time valid = believable(envelope.valid, envelope.arrival);
  if (const auto* s = std::get_if<Solution>(&envelope.message)) {
    solution(envelope, *s);
  } else if (const auto* v = std::get_if<FixVerdict>(&envelope.message)) {
    if (v->engine != setup_.shown) return;
    if (!v->accepted && envelope.source < unused_.size()) {
      Time& before = unused_[envelope.source];
      if (valid >= before && valid - before < std::chrono::seconds(1)) return;
      before = valid;
    }
    const auto& here = engine(setup_.shown).last;
    fresh_.fixes.push_back({valid, v->position, here ? here->position : v->position, v->accepted,
                            v->residual_m, v->gate_m, envelope.source});
    keep_newest(fresh_.fixes, most_points_);
  } else if (const auto* change = std::get_if<ModeChange>(&envelope.message)) {
    if (change->engine != setup_.shown) return;
    fresh_.modes.push_back({valid, change->to, std::string(change->reason.view())});
    keep_newest(fresh_.modes, most_points_);
  } else if (const auto* alarm = std::get_if<Alarm>(&envelope.message)) {
    event({valid, valid, kind_of(alarm->priority), std::string(alarm->text.view())});
  } else if (const auto* health = std::get_if<Health>(&envelope.message)) {
    if (health->level == Health::Level::warning)
      event({valid, valid, EventMark::Kind::event, std::string(health->text.view())});
  }
}

History HistoryBuilder::take_new() {
  History taken = std::move(fresh_);
  fresh_ = History{};
  fresh_.complete = taken.complete;
  fresh_.last = taken.last;
  for (Engine& engine : engines_) engine.stride = 1, engine.skipped = 0;
  return taken;
}

}  // namespace leadline::ui
