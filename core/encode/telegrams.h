#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace leadline::encode {

/// Telegrams that are sent together, one behind the other.
class Telegrams {
 public:
  /// Where the next one is written; closed by end().
  std::string bytes;

  void end() { ends_.push_back(bytes.size()); }
  void clear() { bytes.clear(), ends_.clear(); }
  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] std::string_view operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(bytes).substr(begin, ends_[i] - begin);
  }

 private:
  std::vector<std::size_t> ends_;
};

}  // namespace leadline::encode
