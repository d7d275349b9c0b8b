#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadline::config {

/// Tables and lists may be inside each other this deep.
inline constexpr int kDeepest = 32;

/// One value of a TOML text with its line: plain data, so that only tree.cpp sees toml++.
struct Node {
  enum class Kind : std::uint8_t { table, list, text, integer, number, boolean, date, time };
  Kind kind = Kind::table;
  bool boolean = false;
  bool asked = false;  ///< a table that a reader has asked for
  int line = 1;        ///< of its key; of the element itself in a list
  std::int64_t integer = 0;
  double number = 0.0;  ///< of an integer too
  std::string key;      ///< empty in a list
  std::string text;     ///< of a text; of a date as YYYY-MM-DD
  std::vector<Node> children;
  std::vector<std::string> known;  ///< keys that readers of this table asked for, present or not

  [[nodiscard]] Node* child(std::string_view wanted);
  [[nodiscard]] const Node* child(std::string_view wanted) const {
    return const_cast<Node*>(this)->child(wanted);
  }
};

struct SyntaxError {
  int line = 1;
  std::string text;
};

/// TOML 1.0 to a tree. On an error `root` stays as it was.
[[nodiscard]] std::optional<SyntaxError> parse_tree(std::string_view text, Node& root);

}  // namespace leadline::config
