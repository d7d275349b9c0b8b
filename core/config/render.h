#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/types/option_key.h"

namespace leadline::config {

/// The keys of one table as TOML with their present values, what they mean and what is legal: a line a key,
/// `name = value  # help (0 to 3600)`. What is not given (an optional number without value, an empty text or
/// list) is commented out. header: "[navigation.aiding]", "[[source]]", or empty for keys of the root.
/// The text parses back to the same values.
[[nodiscard]] std::string render(std::string_view header, const std::vector<BoundKey>& keys);

}  // namespace leadline::config
