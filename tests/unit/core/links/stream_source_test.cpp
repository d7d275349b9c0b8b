#include "core/links/stream_source.h"

#include "tests/unit/core/links/made_file.h"

namespace leadline::links {
namespace {

using test::all_chunks;
using test::MadeFile;

TEST(StreamSource, EachChunkRunsFromItsStampToTheNext) {
  const MadeFile file("junkAAAABBCCCC");
  StreamSource source(file.open(), 3, {{4, {10}}, {8, {20}}, {10, {30}}});
  const auto chunks = all_chunks(source);
  ASSERT_EQ(chunks.size(), 3u);
  EXPECT_EQ(chunks[0], (test::KeptChunk{3, 10, "junkAAAA", 0, {}, ""}))
      << "the first begins at the file's first byte";
  EXPECT_EQ(chunks[1], (test::KeptChunk{3, 20, "BB", 0, {}, ""}));
  EXPECT_EQ(chunks[2], (test::KeptChunk{3, 30, "CCCC", 0, {}, ""}));
}

TEST(StreamSource, LongStretchesComeInPiecesOfTheSameArrival) {
  const std::string content(200000, 'x');
  const MadeFile file(content);
  StreamSource source(file.open(), 0, {{0, {10}}, {150000, {20}}});
  std::string joined;
  for (const auto& c : all_chunks(source)) {
    EXPECT_LE(c.bytes.size(), 65536u);
    EXPECT_EQ(c.arrival_ns, joined.size() < 150000 ? 10 : 20);
    joined += c.bytes;
  }
  EXPECT_EQ(joined, content);
}

TEST(StreamSource, StampsBehindTheEndOfAShortenedFileAreLeftOut) {
  const MadeFile file("AAAA");
  StreamSource source(file.open(), 0, {{0, {10}}, {4, {20}}, {1000, {30}}});
  EXPECT_EQ(all_chunks(source).size(), 1u);
}

}  // namespace
}  // namespace leadline::links
