#include "core/config/nearest.h"

#include <algorithm>
#include <array>

namespace leadline::config {
namespace {

constexpr std::size_t kLongestKey = 64;  // longer ones are near to nothing

char folded(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '-' ? '_' : c; }

bool only_unit_missing(std::string_view wrong, std::string_view known) {
  return wrong.size() >= 3 && known.size() > wrong.size() && known[wrong.size()] == '_' &&
         edit_distance(wrong, known.substr(0, wrong.size())) == 0;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  if (a.size() > kLongestKey || b.size() > kLongestKey) return static_cast<int>(std::max(a.size(), b.size()));
  using Row = std::array<int, kLongestKey + 1>;
  Row before{}, above{}, row{};
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = folded(a[i - 1]), y = folded(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (x == y ? 0 : 1)});
      if (i > 1 && j > 1 && x == folded(b[j - 2]) && folded(a[i - 2]) == y)
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

std::optional<std::string> nearest(std::string_view wrong, const std::vector<std::string>& known) {
  const std::string* best = nullptr;
  int least = 0;
  for (const std::string& key : known) {
    int distance = edit_distance(wrong, key);
    if (only_unit_missing(wrong, key)) distance = std::min(distance, 1);
    if (distance > std::max(1, static_cast<int>(std::max(wrong.size(), key.size()) / 3))) continue;
    if (!best || distance < least) best = &key, least = distance;
  }
  return best ? std::optional(*best) : std::nullopt;
}

}  // namespace leadline::config
