#include "core/flow/source_watch.h"

#include <algorithm>
#include <cstdio>

namespace leadline {
namespace {

constexpr std::int64_t kLeastSilenceNs = 2'000'000'000;
constexpr std::int64_t kFirstPatienceNs = 10'000'000'000;  // while nobody knows how often it speaks

Text<200> words(const char* before, Duration silence, const char* behind) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%s%.1f s%s", before, seconds(silence), behind);
  return std::string_view(text.data());
}

}  // namespace

SourceWatch::SourceWatch(const std::vector<SourceInfo>& sources) {
  for (const auto& source : sources) watched_.push_back({.id = source.id});
}

void SourceWatch::take(const Envelope& envelope, EngineOutput& out) {
  if (std::holds_alternative<RawFrame>(envelope.message)) {
    if (envelope.source < watched_.size()) hear(watched_[envelope.source], envelope.arrival, out);
  } else if (const auto* tick = std::get_if<Tick>(&envelope.message)) {
    for (Watched& watched : watched_) {
      if (!began_) watched.last = std::max(watched.last, tick->at);
      look(watched, tick->at, out);
    }
    began_ = true;
  }
}

void SourceWatch::hear(Watched& w, Arrival at, EngineOutput& out) {
  if (w.silent)
    out.publish(at.host(), Health{Health::Level::note, words("is heard again after ", at - w.last, "")},
                w.id);
  // A long silence says nothing about how often it speaks.
  if (const std::int64_t interval_ns = (at - w.last).count(); w.heard && interval_ns <= kFirstPatienceNs) {
    w.intervals_ns[w.next] = interval_ns;
    w.next = (w.next + 1) % kIntervals;
    w.paced = true;
  }
  w.heard = true, w.silent = false;
  w.last = at;
}

void SourceWatch::look(Watched& w, Arrival now, EngineOutput& out) {
  if (w.silent) return;
  const std::int64_t longest_ns = *std::max_element(w.intervals_ns.begin(), w.intervals_ns.end());
  const std::int64_t patience_ns = w.paced ? std::max(kLeastSilenceNs, 3 * longest_ns) : kFirstPatienceNs;
  const Duration silence = now - w.last;
  if (silence.count() < patience_ns) return;
  w.silent = true;
  out.publish(
      now.host(),
      Health{Health::Level::warning, w.heard ? words("silent for ", silence, "")
                                             : words("nothing heard since the start, ", silence, " ago")},
      w.id);
}

}  // namespace leadline
