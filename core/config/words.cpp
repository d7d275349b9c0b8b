#include "core/config/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace leadline::config {
namespace {

template <class T>
bool is(const BoundKey& key) {
  return std::holds_alternative<T*>(key.target);
}
bool is_numeric(const BoundKey& key) {
  return is<double>(key) || is<std::optional<double>>(key) || is<std::int64_t>(key);
}

}  // namespace

std::string quoted(std::string_view text, std::size_t longest) {
  const bool cut = text.size() > longest;
  if (cut) {
    while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xC0) == 0x80)
      --longest;  // whole letters
    text = text.substr(0, longest);
  }
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (code < 0x20 || code == 0x7F)
      fmt::format_to(std::back_inserter(out), "\\u{:04X}", code);
    else
      out += c;
  }
  return out + (cut ? "...\"" : "\"");
}

std::string key_text(std::string_view key) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!key.empty() && key.size() <= 60 && std::all_of(key.begin(), key.end(), bare)) return std::string(key);
  return quoted(key, 60);
}

std::string bounds_text(const BoundKey& key) {
  if (!key.choices.empty()) return fmt::format("{}", fmt::join(key.choices, " | "));
  if (!is_numeric(key)) return {};
  if (std::isfinite(key.min) && std::isfinite(key.max)) return fmt::format("{} to {}", key.min, key.max);
  if (std::isfinite(key.min)) return fmt::format("at least {}", key.min);
  if (std::isfinite(key.max)) return fmt::format("at most {}", key.max);
  return {};
}

std::string legal_element_text(const BoundKey& key) {
  if (key.choices.empty()) return is_date_key(key) ? "a date YYYY-MM-DD" : "a text in quotes";
  std::string text = "one of ";
  for (const auto choice : key.choices) text += (text.size() > 7 ? ", " : "") + quoted(choice);
  return text;
}

std::string legal_text(const BoundKey& key) {
  if (is<bool>(key)) return "true or false";
  if (is<std::vector<std::string>>(key)) return "a list, each element " + legal_element_text(key);
  if (!is_numeric(key)) return legal_element_text(key);
  std::string text = is<std::int64_t>(key) ? "a whole number" : "a number";
  const std::string bounds = bounds_text(key);
  if (bounds.empty()) return text;
  return text + (std::isfinite(key.min) && std::isfinite(key.max) ? " from " : ", ") + bounds;
}

bool is_date_key(const BoundKey& key) { return is<std::string>(key) && key.name == "date"; }

}  // namespace leadline::config
