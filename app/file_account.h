#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/decoder.h"
#include "core/types/position.h"
#include "core/types/result.h"

namespace leadline::app {

/// What one file holds. Every byte of it is in one class.
struct FileAccount {
  struct Kind {
    std::string name, decoder, kind;
    std::uint64_t count = 0;
    std::optional<double> rate_hz;
    std::optional<Time> first, last;
  };
  struct Box {
    Angle west, south, east, north;
  };

  std::string path, kind;
  std::uint64_t bytes = 0;
  std::array<std::uint64_t, kByteClasses> byte_classes{};
  std::uint64_t lines = 0, frames = 0, unknown = 0, unused = 0, gaps = 0;
  std::uint64_t checksum_ok = 0, checksum_bad = 0, checksum_absent = 0;
  std::map<std::string, std::uint64_t> refused;
  std::vector<Kind> sources;
  std::optional<Box> box;
  bool damaged = false;
};

/// Reads the whole file once or twice: its decoder is chosen by content (by each source's first payload in a
/// tlog), checksums may be absent. Error: it cannot be read.
[[nodiscard]] Result<FileAccount> account_of(const std::string& path);

}  // namespace leadline::app
