#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/flow/source.h"
#include "core/links/file_reader.h"

namespace leadline::test {

/// A file with a given content for the length of a test.
class MadeFile {
 public:
  explicit MadeFile(std::string_view content) {
    static int count = 0;
    path_ =
        ::testing::TempDir() + "leadline_links_" + std::to_string(::getpid()) + "_" + std::to_string(++count);
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~MadeFile() { std::remove(path_.c_str()); }
  MadeFile(const MadeFile&) = delete;
  MadeFile& operator=(const MadeFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] links::FileReader open() const { return links::FileReader::open(path_).value(); }

 private:
  std::string path_;
};

/// A chunk that outlives the next call.
struct KeptChunk {
  SourceId source;
  std::int64_t arrival_ns;
  std::string bytes;
  std::uint32_t stamp_bytes;
  std::optional<ByteClass> settled;
  std::string reason;
  bool operator==(const KeptChunk&) const = default;
};

inline KeptChunk kept(const Chunk& c) {
  return {c.source,      c.arrival.ns, std::string(c.bytes.begin(), c.bytes.end()),
          c.stamp_bytes, c.settled,    std::string(c.reason)};
}

inline std::vector<KeptChunk> all_chunks(Source& source) {
  std::vector<KeptChunk> chunks;
  for (Chunk chunk; source.next(chunk);) chunks.push_back(kept(chunk));
  return chunks;
}

inline std::uint64_t byte_sum(const std::vector<KeptChunk>& chunks) {
  std::uint64_t sum = 0;
  for (const auto& c : chunks) sum += c.bytes.size() + c.stamp_bytes;
  return sum;
}

/// `content` with about `percent` of its bytes changed, and cut at a random place every other time.
inline std::string damaged(std::string content, std::mt19937& random, double percent) {
  std::bernoulli_distribution hit(percent / 100.0);
  std::uniform_int_distribution<int> byte(0, 255);
  for (char& c : content)
    if (hit(random)) c = static_cast<char>(byte(random));
  if (random() % 2 == 0) content.resize(random() % (content.size() + 1));
  return content;
}

}  // namespace leadline::test
