#include "core/config/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/config/words.h"

namespace leadline::config {
namespace {

constexpr std::size_t kCommentColumn = 34;

struct Written {
  std::string value;
  bool given = true;
};

Written written(const double* value) {
  if (!std::isfinite(*value)) return {"", false};
  std::string text = fmt::format("{}", *value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return {text};
}
Written written(const std::optional<double>* value) {
  return *value ? written(&**value) : Written{"", false};
}
Written written(const bool* value) { return {*value ? "true" : "false"}; }
Written written(const std::int64_t* value) { return {fmt::format("{}", *value)}; }
Written written(const std::string* value) { return {quoted(*value), !value->empty()}; }
Written written(const std::vector<std::string>* value) {
  std::string text;
  for (const auto& element : *value) text += (text.empty() ? "" : ", ") + quoted(element);
  return {"[" + text + "]", !value->empty()};
}

}  // namespace

std::string render(std::string_view header, const std::vector<BoundKey>& keys) {
  std::string text;
  if (!header.empty()) text += fmt::format("{}\n", header);
  for (const BoundKey& key : keys) {
    const auto [value, given] = std::visit([](const auto* target) { return written(target); }, key.target);
    std::string line =
        fmt::format("{}{} ={}{}", given ? "" : "# ", key_text(key.name), value.empty() ? "" : " ", value);
    std::string comment(key.help);
    if (const std::string bounds = bounds_text(key); !bounds.empty())
      comment += fmt::format("{}({})", comment.empty() ? "" : " ", bounds);
    std::replace_if(
        comment.begin(), comment.end(), [](char c) { return c >= 0 && c < 0x20; }, ' ');
    if (!comment.empty()) {
      line.resize(std::max(line.size() + 2, kCommentColumn), ' ');
      line += "# " + comment;
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace leadline::config
