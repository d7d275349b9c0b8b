#pragma once

// How texts, keys and legal values are written, in problems and in examples.

#include <string>
#include <string_view>

#include "core/types/option_key.h"

namespace leadline::config {

/// A TOML basic string: in quotes, on one line whatever is inside. More than `longest` bytes are cut short.
[[nodiscard]] std::string quoted(std::string_view text, std::size_t longest = std::string_view::npos);

/// A key as it may stand in a dotted path: bare where TOML allows that, else quoted.
[[nodiscard]] std::string key_text(std::string_view key);

/// "0 to 3600", "at least 0", "utc | gps"; empty when everything of its type is legal.
[[nodiscard]] std::string bounds_text(const BoundKey& key);

/// What the key may be, as the end of a sentence: "a number from 0 to 3600", "one of \"utc\", \"gps\"".
[[nodiscard]] std::string legal_text(const BoundKey& key);
/// The same of one element of a list of texts.
[[nodiscard]] std::string legal_element_text(const BoundKey& key);

/// Its text must be a calendar date YYYY-MM-DD.
[[nodiscard]] bool is_date_key(const BoundKey& key);

}  // namespace leadline::config
