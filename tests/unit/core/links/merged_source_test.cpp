#include "core/links/merged_source.h"

#include <algorithm>
#include <map>

#include "core/links/stamped_text_source.h"
#include "tests/support/files.h"
#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

/// Chunks with given arrivals; their bytes are overwritten by the next call, as a file's window is.
class Listed final : public Source {
 public:
  Listed(SourceId id, std::vector<std::int64_t> arrivals) : id_(id), arrivals_(std::move(arrivals)) {}
  bool next(Chunk& chunk) override {
    if (at_ == arrivals_.size()) return false;
    buffer_ = std::to_string(id_) + ":" + std::to_string(at_);
    chunk = Chunk{};
    chunk.source = id_;
    chunk.arrival = {arrivals_[at_++]};
    chunk.bytes = {reinterpret_cast<const std::uint8_t*>(buffer_.data()), buffer_.size()};
    return true;
  }

 private:
  SourceId id_;
  std::vector<std::int64_t> arrivals_;
  std::size_t at_ = 0;
  std::string buffer_;
};

std::vector<test::KeptChunk> merged(const std::vector<std::vector<std::int64_t>>& lists) {
  std::vector<std::unique_ptr<Source>> sources;
  for (std::size_t i = 0; i < lists.size(); ++i)
    sources.push_back(std::make_unique<Listed>(static_cast<SourceId>(i), lists[i]));
  MergedSource source(std::move(sources));
  return test::all_chunks(source);
}

std::vector<std::string> order(const std::vector<test::KeptChunk>& chunks) {
  std::vector<std::string> names;
  for (const auto& c : chunks) names.push_back(c.bytes);
  return names;
}

using Names = std::vector<std::string>;

TEST(MergedSource, TheEarliestComesFirstAndEqualStampsKeepTheListsThenTheFilesOrder) {
  EXPECT_EQ(order(merged({{5, 5, 7}, {1, 5, 6}, {5}})),
            (Names{"1:0", "0:0", "0:1", "1:1", "2:0", "1:2", "0:2"}));
}

TEST(MergedSource, AStampThatGoesBackKeepsItsPlaceBehindTheOneBefore) {
  const auto chunks = merged({{10, 3, 12}, {4, 11}});
  EXPECT_EQ(order(chunks), (Names{"1:0", "0:0", "0:1", "1:1", "0:2"}));
  EXPECT_EQ(chunks[2].arrival_ns, 3) << "the stamp itself is not touched";
}

TEST(MergedSource, EmptySourcesAndNoSourcesEnd) {
  EXPECT_TRUE(merged({}).empty());
  EXPECT_EQ(merged({{}, {1}, {}}).size(), 1u);
}

TEST(MergedSource, AnyListsMergeToTheStableSortByRunningMaximum) {
  std::mt19937 random(11);
  for (int round = 0; round < 500; ++round) {
    std::vector<std::vector<std::int64_t>> lists(1 + random() % 5);
    struct Item {
      std::int64_t place;
      std::string name;
    };
    std::vector<Item> expected;
    for (std::size_t i = 0; i < lists.size(); ++i) {
      std::int64_t now = 0, place = 0;
      for (std::size_t k = 0, n = random() % 20; k < n; ++k) {
        now += static_cast<std::int64_t>(random() % 5) - 1;
        place = k == 0 ? now : std::max(place, now);
        lists[i].push_back(now);
        expected.push_back({place, std::to_string(i) + ":" + std::to_string(k)});
      }
    }
    std::stable_sort(expected.begin(), expected.end(),
                     [](const Item& a, const Item& b) { return a.place < b.place; });
    Names names;
    for (const auto& e : expected) names.push_back(e.name);
    const auto once = merged(lists);
    ASSERT_EQ(order(once), names);
    ASSERT_EQ(merged(lists), once);
  }
}

TEST(MergedSource, AShipsInstrumentsBecomeOneTimeline) {
  std::vector<std::unique_ptr<Source>> sources;
  std::uint64_t size = 0;
  for (const char* name : {"s330", "gyr1", "gp02", "adcp"}) {
    auto file = FileReader::open(
        test::data_path(std::string("nmea_openrvdas_nbp1406/NBP1406_") + name + "-2014-08-01"));
    ASSERT_TRUE(file) << file.error().line();
    size += file.value().size();
    sources.push_back(
        std::make_unique<StampedTextSource>(std::move(file).value(), static_cast<SourceId>(sources.size())));
  }
  MergedSource source(std::move(sources));
  std::map<SourceId, int> count;
  std::uint64_t bytes = 0;
  Arrival latest;
  for (Chunk chunk; source.next(chunk);) {
    ASSERT_GE(chunk.arrival, latest);
    ASSERT_EQ(source.input(), chunk.source);
    latest = chunk.arrival;
    bytes += chunk.bytes.size() + chunk.stamp_bytes;
    ++count[chunk.source];
  }
  EXPECT_EQ(bytes, size);
  for (SourceId id = 0; id < 4; ++id) EXPECT_EQ(count[id], 5000) << id;
}

}  // namespace
}  // namespace leadline::links
