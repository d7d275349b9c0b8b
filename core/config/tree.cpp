#include "core/config/tree.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace leadline::config {
namespace {

/// The position after the string that begins at `i`; `line` counts the line ends inside. A string of one line
/// that is not closed ends with the line: toml++ will refuse it there.
std::size_t after_string(std::string_view text, std::size_t i, int& line) {
  const char quote = text[i];
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool long_form = text.substr(i, 3) == triple;
  for (i += long_form ? 3 : 1; i < text.size(); ++i) {
    if (text[i] == '\n') {
      if (!long_form) return i;
      ++line;
    } else if (text[i] == '\\' && quote == '"' && i + 1 < text.size() && text[i + 1] != '\n') {
      ++i;
    } else if (!long_form && text[i] == quote) {
      return i + 1;
    } else if (long_form && text.substr(i, 3) == triple) {
      i += 3;
      for (int extra = 0; extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
      return i;
    }
  }
  return i;
}

/// The first line where a dotted key has too many parts or brackets are too deep; 0: none. Before toml++,
/// which bounds neither dotted keys nor the recursion that frees their tables.
int too_deep_line(std::string_view text) {
  int line = 1, dots = 0, brackets = 0;
  for (std::size_t i = 0; i < text.size();) {
    switch (text[i]) {
      case '"':
      case '\'':
        i = after_string(text, i, line);
        continue;
      case '#':
        i = std::min(text.find('\n', i), text.size());
        continue;
      case '\n':
        ++line, dots = 0;
        break;
      case ',':
      case '=':
        dots = 0;
        break;
      case '[':
      case '{':
        ++brackets, dots = 0;
        break;
      case ']':
      case '}':
        brackets = std::max(0, brackets - 1);
        break;
      case '.':
        ++dots;
        break;
      default:
        break;
    }
    if (dots > kDeepest || brackets > kDeepest) return line;
    ++i;
  }
  return 0;
}

SyntaxError too_deep(int line) {
  return {line, fmt::format("tables and lists are inside each other more than {} deep", kDeepest)};
}

int line_of(const toml::source_region& region) { return static_cast<int>(std::max(1u, region.begin.line)); }

/// toml++'s value to a Node that already has its key and line. Throws SyntaxError.
void convert(const toml::node& from, int depth, Node& to) {
  if (depth > kDeepest) throw too_deep(to.line);
  if (const auto* table = from.as_table()) {
    to.kind = Node::Kind::table;
    to.children.reserve(table->size());
    for (const auto& [key, value] : *table) {
      Node& child = to.children.emplace_back();
      child.key = std::string(key.str());
      child.line = line_of(key.source());
      convert(value, depth + 1, child);
    }
  } else if (const auto* list = from.as_array()) {
    to.kind = Node::Kind::list;
    to.children.reserve(list->size());
    for (const auto& value : *list) {
      Node& child = to.children.emplace_back();
      child.line = line_of(value.source());
      convert(value, depth + 1, child);
    }
  } else if (const auto* text = from.as_string()) {
    to.kind = Node::Kind::text;
    to.text = text->get();
  } else if (const auto* integer = from.as_integer()) {
    to.kind = Node::Kind::integer;
    to.integer = integer->get();
    to.number = static_cast<double>(to.integer);
  } else if (const auto* number = from.as_floating_point()) {
    to.kind = Node::Kind::number;
    to.number = number->get();
  } else if (const auto* boolean = from.as_boolean()) {
    to.kind = Node::Kind::boolean;
    to.boolean = boolean->get();
  } else if (const auto* date = from.as_date()) {
    const toml::date d = date->get();
    to.kind = Node::Kind::date;
    to.text = fmt::format("{:04}-{:02}-{:02}", d.year, d.month, d.day);
  } else {
    to.kind = Node::Kind::time;
  }
}

}  // namespace

Node* Node::child(std::string_view wanted) {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const Node& n) { return n.key == wanted; });
  return kind == Kind::table && found != children.end() ? &*found : nullptr;
}

std::optional<SyntaxError> parse_tree(std::string_view text, Node& root) {
  if (const int line = too_deep_line(text); line > 0) return too_deep(line);
  try {
    Node fresh;
    convert(toml::parse(text), 0, fresh);
    root = std::move(fresh);
    return std::nullopt;
  } catch (const SyntaxError& e) {
    return e;
  } catch (const toml::parse_error& e) {
    std::string words(e.description());
    if (words.rfind("Error ", 0) == 0) words[0] = 'e';
    return SyntaxError{line_of(e.source()), "not TOML: " + words};
  } catch (const std::exception& e) {
    return SyntaxError{1, "not TOML: " + std::string(e.what())};
  }
}

}  // namespace leadline::config
