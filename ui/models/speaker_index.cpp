#include "ui/models/speaker_index.h"

#include <algorithm>

namespace leadline::ui {

KindSpeaker speaker_of(const Envelope& envelope) {
  KindSpeaker speaker{static_cast<std::uint8_t>(envelope.message.index()), 0, envelope.source};
  if (const auto* s = std::get_if<Solution>(&envelope.message)) speaker.engine = s->engine;
  if (const auto* v = std::get_if<FixVerdict>(&envelope.message)) speaker.engine = v->engine;
  if (const auto* m = std::get_if<ModeChange>(&envelope.message)) speaker.engine = m->engine;
  return speaker;
}

void SpeakerIndex::add(const KindSpeaker& speaker, std::uint64_t seq) {
  Line& line = lines_[speaker];
  const std::uint64_t block = seq / kBlock;
  if (line.last.empty()) line.first_block = block;
  // Blocks in which it was silent end as the one before them.
  const std::size_t place = block - line.first_block;
  const std::uint64_t before = line.last.empty() ? 0 : line.last.back();
  const std::uint32_t count = line.count.empty() ? 0 : line.count.back();
  if (line.last.size() <= place) {
    line.last.resize(place + 1, before);
    line.count.resize(place + 1, count);
  }
  line.last[place] = seq;
  ++line.count[place];
}

std::vector<SpeakerIndex::Last> SpeakerIndex::before(std::uint64_t seq) const {
  std::vector<Last> all;
  const std::uint64_t block = seq / kBlock;
  for (const auto& [speaker, line] : lines_) {
    if (line.first_block >= block) continue;
    const std::size_t place = std::min<std::size_t>(block - 1 - line.first_block, line.last.size() - 1);
    all.push_back({speaker, line.last[place], line.count[place]});
  }
  return all;
}

}  // namespace leadline::ui
