#include "ui/models/speaker_index.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace leadline::ui {
namespace {

TEST(SpeakerIndex, KnowsEachSpeakersLastAndCountBeforeAnyBlock) {
  std::mt19937 random(3);
  SpeakerIndex index;
  std::vector<std::pair<KindSpeaker, std::uint64_t>> said;
  for (std::uint64_t seq = 1; seq < 50'000; seq += 1 + random() % 5) {
    KindSpeaker speaker{0, 0, static_cast<SourceId>(random() % 3)};
    if (seq > 10'000 && seq < 30'000 && speaker.source == 1) continue;  // silent for twenty blocks
    if (random() % 5'000 == 0) speaker = {3, 1, 9};
    index.add(speaker, seq);
    said.push_back({speaker, seq});
  }
  for (std::uint64_t block = 0; block < 60; ++block) {
    const std::uint64_t seq = block * SpeakerIndex::kBlock;
    std::map<KindSpeaker, std::pair<std::uint64_t, std::uint64_t>> expected;
    for (const auto& [speaker, at] : said)
      if (at < seq) expected[speaker] = {at, expected[speaker].second + 1};
    const auto found = index.before(seq);
    ASSERT_EQ(found.size(), expected.size()) << block;
    for (const auto& last : found) {
      EXPECT_EQ(last.seq, expected[last.speaker].first);
      EXPECT_EQ(last.count, expected[last.speaker].second);
    }
  }
}

TEST(SpeakerIndex, BlocksBeginAtOne) {
  EXPECT_EQ(SpeakerIndex::block_begin(0), 1U);
  EXPECT_EQ(SpeakerIndex::block_begin(1023), 1U);
  EXPECT_EQ(SpeakerIndex::block_begin(1024), 1024U);
  EXPECT_EQ(SpeakerIndex::block_begin(5000), 4096U);
}

}  // namespace
}  // namespace leadline::ui
