#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadline::config {

/// How many letters must be changed, added, left out or swapped with their neighbour to make one word of the
/// other (optimal string alignment distance); capitals and small letters, '-' and '_' are the same.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The known key that a mistyped one most probably means: at most a third of its letters wrong, or only the
/// unit at its end left out. The first of equals; empty when none is near.
[[nodiscard]] std::optional<std::string> nearest(std::string_view wrong,
                                                 const std::vector<std::string>& known);

}  // namespace leadline::config
