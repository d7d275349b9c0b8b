// Feeds every file of the folders on the command line to a fuzz target: the corpus as a normal test. With
// --seconds N it goes on with the corpus changed at random: bytes turned, cut out, doubled, two files joined.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes changed(const std::vector<Bytes>& corpus, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1));
  };
  Bytes bytes = corpus[below(corpus.size())];
  const std::size_t edits = 1 + below(1 + bytes.size() / 50);  // 2 % at most
  for (std::size_t i = 0; i < edits; ++i) {
    const auto at = static_cast<std::ptrdiff_t>(below(bytes.size())),
               end = static_cast<std::ptrdiff_t>(bytes.size());
    const auto length = static_cast<std::ptrdiff_t>(below(8));
    const std::size_t how = below(6);
    if (how < 2 && !bytes.empty())
      bytes[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(random());
    else if (how == 2 && !bytes.empty())
      bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1U << below(8));
    else if (how == 3)
      bytes.erase(bytes.begin() + at, bytes.begin() + std::min(end, at + length));
    else if (how == 4)
      bytes.insert(bytes.begin() + at, static_cast<std::size_t>(length), static_cast<std::uint8_t>(random()));
    else if (const Bytes& other = corpus[below(corpus.size())]; bytes.size() < 65536)
      bytes.insert(bytes.begin() + at, other.begin(),
                   other.begin() + static_cast<std::ptrdiff_t>(below(other.size())));
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Bytes> corpus;
  double seconds = 0.0;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--seconds") == 0 && i + 1 < argc) {
      seconds = std::atof(argv[++i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      std::ifstream in(entry.path(), std::ios::binary);
      corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
      LLVMFuzzerTestOneInput(corpus.back().data(), corpus.back().size());
    }
  }
  std::printf("%zu inputs\n", corpus.size());
  if (corpus.empty()) return 1;
  std::mt19937 random(1);
  std::uint64_t count = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    const Bytes bytes = changed(corpus, random);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    ++count;
  }
  if (seconds > 0.0) std::printf("%lu changed inputs in %.0f s\n", count, seconds);
  return 0;
}
