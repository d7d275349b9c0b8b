#include "core/config/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <utility>

#include "core/config/nearest.h"
#include "core/config/tree.h"
#include "core/config/words.h"
#include "core/types/time.h"

namespace leadline::config {

struct Document::Content {
  std::string text, file;
  Node root;
  std::deque<Node> absent;  // tables that were asked for and are not there
  std::vector<Problem> problems;
  bool finished = false;

  void add(int line, std::string key, std::string words) {
    if (problems.size() > kMostProblems) return;
    if (problems.size() == kMostProblems) {
      problems.push_back({file, 0, "", "has more problems than these"});
      return;
    }
    const auto later = [](int l, const Problem& p) { return l < p.line; };
    const auto place = std::upper_bound(problems.begin(), problems.end(), line, later);
    problems.insert(place, {file, line, std::move(key), std::move(words)});
  }
  [[nodiscard]] bool full() const { return problems.size() > kMostProblems; }

  void find_unknown(const Node& table, const std::string& path);
};

namespace {

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? key_text(key) : path + "." + key_text(key);
}

std::string element_path(const std::string& list_path, const Node& element, std::size_t index) {
  const Node* name = element.child("name");
  if (name && name->kind == Node::Kind::text && !name->text.empty())
    return list_path + " " + quoted(name->text, 60);
  return fmt::format("{}[{}]", list_path, index + 1);
}

std::string given_text(const Node& node) {
  switch (node.kind) {
    case Node::Kind::table:
      return "a table";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::text:
      return quoted(node.text, 60);
    case Node::Kind::integer:
      return fmt::format("{}", node.integer);
    case Node::Kind::number:
      return fmt::format("{}", node.number);
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::date:
      return "the date " + node.text;
    case Node::Kind::time:
      return "a time";
  }
  return {};
}

bool is_table(const Node& node) { return node.kind == Node::Kind::table; }

bool legal_number(const BoundKey& key, const Node& node) {
  return (node.kind == Node::Kind::integer || node.kind == Node::Kind::number) &&
         std::isfinite(node.number) && node.number >= key.min && node.number <= key.max;
}

bool legal_words(const BoundKey& key, const Node& node) {
  if (node.kind != Node::Kind::text && node.kind != Node::Kind::date) return false;
  if (is_date_key(key) && !parse_date(node.text)) return false;
  return key.choices.empty() ||
         std::find(key.choices.begin(), key.choices.end(), node.text) != key.choices.end();
}

/// Sets the target when the value is legal; says whether it was.
struct Setter {
  const BoundKey& key;
  const Node& node;

  bool operator()(double* target) const {
    if (!legal_number(key, node)) return false;
    *target = node.number;
    return true;
  }
  bool operator()(std::optional<double>* target) const {
    if (!legal_number(key, node)) return false;
    *target = node.number;
    return true;
  }
  bool operator()(std::int64_t* target) const {
    if (node.kind != Node::Kind::integer || !legal_number(key, node)) return false;
    *target = node.integer;
    return true;
  }
  bool operator()(bool* target) const {
    if (node.kind != Node::Kind::boolean) return false;
    *target = node.boolean;
    return true;
  }
  bool operator()(std::string* target) const {
    if (!legal_words(key, node)) return false;
    *target = node.text;
    return true;
  }
  bool operator()(std::vector<std::string>* target) const {
    if (node.kind != Node::Kind::list) return false;
    std::vector<std::string> texts;
    for (const Node& element : node.children) {
      if (!legal_words(key, element)) return false;
      texts.push_back(element.text);
    }
    *target = std::move(texts);
    return true;
  }
};

std::string unknown_text(const Node& unknown, const std::vector<std::string>& known) {
  const bool is_list =
      unknown.kind == Node::Kind::list && !unknown.children.empty() && is_table(unknown.children[0]);
  std::string text = is_table(unknown) || is_list ? "unknown table" : "unknown key";
  if (const auto near = nearest(unknown.key, known)) return text + "; the nearest known key is " + *near;
  if (known.empty()) return text + "; nothing is known here";
  constexpr std::size_t kListed = 8;
  const auto end = known.begin() + static_cast<std::ptrdiff_t>(std::min(known.size(), kListed));
  return text + fmt::format("; known here are {}{}", fmt::join(known.begin(), end, ", "),
                            known.size() > kListed ? " ..." : "");
}

void remember(Node& table, std::string_view key) {
  if (std::find(table.known.begin(), table.known.end(), key) == table.known.end())
    table.known.emplace_back(key);
}

}  // namespace

std::string Problem::line_text() const {
  std::string out = line > 0 ? fmt::format("{}:{}", file, line) : file;
  if (!key.empty()) out += ": " + key;
  return out + ": " + text;
}

void Document::Content::find_unknown(const Node& table, const std::string& path) {
  for (const Node& child : table.children) {
    if (full()) return;
    const std::string child_path = joined(path, child.key);
    if (std::find(table.known.begin(), table.known.end(), child.key) == table.known.end()) {
      add(child.line, child_path, unknown_text(child, table.known));
    } else if (child.kind == Node::Kind::list) {
      for (std::size_t i = 0; i < child.children.size(); ++i)
        if (child.children[i].asked)
          find_unknown(child.children[i], element_path(child_path, child.children[i], i));
    } else if (child.asked) {
      find_unknown(child, child_path);
    }
  }
}

Document::Document(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

Document Document::parse(std::string text, std::string file) {
  auto content = std::make_unique<Content>();
  content->text = std::move(text);
  content->file = std::move(file);
  if (content->text.size() > kLargest)
    content->add(0, "", fmt::format("is larger than {} MiB: not a configuration", kLargest / 1024 / 1024));
  else if (auto error = parse_tree(content->text, content->root))
    content->add(error->line, "", std::move(error->text));
  return Document(std::move(content));
}

Document Document::load(const std::string& path) {
  std::string text;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  bool readable = file != nullptr;
  if (readable) {
    // One byte beyond the limit is enough to know that the file breaks it.
    char block[65536];
    for (std::size_t got = 1; got > 0 && text.size() <= kLargest; text.append(block, got))
      got = std::fread(block, 1, sizeof block, file.get());
    readable = std::ferror(file.get()) == 0;
  }
  if (readable) return parse(std::move(text), path);
  auto content = std::make_unique<Content>();
  content->file = path;
  content->add(0, "", fmt::format("cannot be read: {}", std::strerror(errno)));
  return Document(std::move(content));
}

const std::vector<Problem>& Document::problems() const& { return content_->problems; }
const std::string& Document::text() const { return content_->text; }
const std::string& Document::file() const { return content_->file; }
Table Document::root() & { return Table(*content_, content_->root, "", true); }

void Document::finish() {
  if (std::exchange(content_->finished, true)) return;
  content_->find_unknown(content_->root, "");
}

void Document::report(int line, std::string key, std::string text) {
  content_->add(line, std::move(key), std::move(text));
}

Table::Table(Document::Content& content, Node& node, std::string path, bool given)
    : content_(&content), node_(&node), path_(std::move(path)), given_(given) {
  node.asked = true;
}

Table Table::absent(std::string_view key) {
  Node& node = content_->absent.emplace_back();
  node.line = node_->line;
  return Table(*content_, node, path_of(key), false);
}

Table Table::table(std::string_view key) {
  remember(*node_, key);
  Node* child = node_->child(key);
  if (!child) return absent(key);
  if (is_table(*child)) return Table(*content_, *child, path_of(key), true);
  report(key, fmt::format("is {}; must be a table, [{}]", given_text(*child), path_of(key)));
  return absent(key);
}

std::vector<Table> Table::tables(std::string_view key) {
  remember(*node_, key);
  std::vector<Table> found;
  Node* list = node_->child(key);
  if (!list) return found;
  const std::string path = path_of(key);
  if (list->kind != Node::Kind::list) {
    report(key, fmt::format("is {}; must be a list of tables, each [[{}]]", given_text(*list), path));
    return found;
  }
  for (std::size_t i = 0; i < list->children.size(); ++i) {
    Node& element = list->children[i];
    std::string its_path = element_path(path, element, i);
    if (is_table(element))
      found.push_back(Table(*content_, element, std::move(its_path), true));
    else
      content_->add(element.line, its_path,
                    fmt::format("is {}; must be a table, [[{}]]", given_text(element), path));
  }
  return found;
}

void Table::read(const std::vector<BoundKey>& keys) {
  for (const BoundKey& key : keys) {
    remember(*node_, key.name);
    const Node* node = node_->child(key.name);
    if (!node || std::visit(Setter{key, *node}, key.target)) continue;
    const bool is_texts = std::holds_alternative<std::vector<std::string>*>(key.target);
    if (!is_texts || node->kind != Node::Kind::list) {
      report(key.name, fmt::format("is {}; must be {}", given_text(*node), legal_text(key)));
      continue;
    }
    for (std::size_t i = 0; i < node->children.size(); ++i) {
      const Node& element = node->children[i];
      if (legal_words(key, element)) continue;
      content_->add(element.line, fmt::format("{}[{}]", path_of(key.name), i + 1),
                    fmt::format("is {}; must be {}", given_text(element), legal_element_text(key)));
    }
  }
}

bool Table::require(std::string_view key) {
  remember(*node_, key);
  const Node* node = node_->child(key);
  const bool empty = node && node->kind == Node::Kind::text && node->text.empty();
  if (node && !empty) return true;
  report(key, empty ? "is empty; must be given" : "is missing; must be given");
  return false;
}

bool Table::has(std::string_view key) const { return node_->child(key) != nullptr; }
int Table::line() const { return node_->line; }
int Table::line_of(std::string_view key) const {
  const Node* node = node_->child(key);
  return node ? node->line : line();
}
std::string Table::path_of(std::string_view key) const { return key.empty() ? path_ : joined(path_, key); }
void Table::report(std::string_view key, std::string text) {
  content_->add(line_of(key), path_of(key), std::move(text));
}

}  // namespace leadline::config
