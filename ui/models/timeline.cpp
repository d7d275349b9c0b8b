#include "ui/models/timeline.h"

#include <algorithm>

namespace leadline::ui {
namespace {

constexpr std::size_t kMostBins = 4096;
constexpr std::size_t kShortBytes = 24;

template <class T, class Key>
void insert_in_order(std::vector<T>& all, T one, Key key) {
  const auto place =
      std::upper_bound(all.begin(), all.end(), key(one), [&](Time t, const T& x) { return t < key(x); });
  all.insert(place, std::move(one));
}

/// The greatest of each stretch of bin_ns since the epoch; `all` is in order.
void bin(std::vector<TimelineData::Sigma>& all, const TimelineData::Sigma& one, std::int64_t bin_ns) {
  if (!all.empty() && all.back().at.ns / bin_ns == one.at.ns / bin_ns) {
    if (one.drms_m > all.back().drms_m) all.back() = one;
    return;
  }
  all.push_back(one);
}

}  // namespace

std::string short_words(const std::string& text) {
  std::string words = text.substr(0, text.find_first_of(":;,."));
  if (words.size() <= kShortBytes) return words;
  std::size_t cut = words.rfind(' ', kShortBytes);
  if (cut == std::string::npos || cut == 0) {
    cut = kShortBytes;
    while (cut > 0 && (static_cast<unsigned char>(words[cut]) & 0xC0) == 0x80) --cut;  // a letter stays whole
  }
  return words.substr(0, cut) + "…";
}

void TimelineModel::take_modes(const History& history) {
  for (; modes_ < history.modes.size(); ++modes_) {
    const ModeMark& mark = history.modes[modes_];
    auto& all = data_.availability;
    const Time from = all.empty() ? mark.valid : std::max(mark.valid, all.back().span.from);
    if (!all.empty()) all.back().span.until = from;
    all.push_back({{from, from}, mark.mode});
  }
  if (!data_.availability.empty()) {
    auto& last = data_.availability.back().span;
    last.until = std::max(last.from, data_.run.until);
  }
}

void TimelineModel::take_events(const History& history) {
  for (; events_ < history.events.size(); ++events_) {
    const EventMark& mark = history.events[events_];
    switch (mark.kind) {
      case EventMark::Kind::event:
        insert_in_order(data_.events, TimelineData::Event{mark.valid, short_words(mark.text)},
                        [](const auto& e) { return e.at; });
        break;
      case EventMark::Kind::gap:
        insert_in_order(data_.gaps, TimelineData::Gap{{mark.valid, mark.until}, mark.text},
                        [](const auto& g) { return g.span.from; });
        break;
      default:
        insert_in_order(data_.alerts,
                        TimelineData::Alert{mark.valid,
                                            mark.kind == EventMark::Kind::caution   ? Alarm::Priority::caution
                                            : mark.kind == EventMark::Kind::warning ? Alarm::Priority::warning
                                                                                    : Alarm::Priority::alarm,
                                            mark.text},
                        [](const auto& a) { return a.at; });
    }
  }
}

void TimelineModel::take_points(const Track& track) {
  for (; points_ < track.points.size(); ++points_) {
    const TrackPoint& point = track.points[points_];
    bin(data_.sigma, {point.valid, static_cast<double>(point.drms_m)}, bin_ns_);
    if (data_.sigma.size() <= kMostBins) continue;
    bin_ns_ *= 2;
    std::vector<TimelineData::Sigma> wider;
    wider.reserve(kMostBins);
    for (const auto& one : data_.sigma) bin(wider, one, bin_ns_);
    data_.sigma = std::move(wider);
  }
}

void TimelineModel::update(const History& history, EngineId engine) {
  const auto track = std::find_if(history.tracks.begin(), history.tracks.end(),
                                  [&](const Track& t) { return t.engine == engine; });
  const std::size_t points = track == history.tracks.end() ? 0 : track->points.size();
  if (modes_ > history.modes.size() || events_ > history.events.size() || points_ > points ||
      (data_.run.from != Time{} && data_.run.from != history.first))
    *this = TimelineModel();
  data_.run = {history.first, history.last};
  data_.complete = history.complete;
  take_modes(history);
  take_events(history);
  if (track != history.tracks.end()) take_points(*track);
}

std::vector<TimelineData::Sigma> TimelineModel::sigma(TimeSpan view, int columns) const {
  std::vector<TimelineData::Sigma> shown;
  if (columns < 1 || view.until <= view.from) return shown;
  const double per_column_ns = static_cast<double>((view.until - view.from).count()) / columns;
  int column = -1;
  const auto begin = std::lower_bound(data_.sigma.begin(), data_.sigma.end(), view.from,
                                      [](const TimelineData::Sigma& s, Time t) { return s.at < t; });
  for (auto one = begin; one != data_.sigma.end() && one->at < view.until; ++one) {
    const int its = static_cast<int>(static_cast<double>((one->at - view.from).count()) / per_column_ns);
    if (its != column)
      shown.push_back(*one);
    else if (one->drms_m > shown.back().drms_m)
      shown.back() = *one;
    column = its;
  }
  return shown;
}

}  // namespace leadline::ui
