#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/option_key.h"

namespace leadline::config {

struct Node;

/// Something wrong with a configuration, in the operator's words.
struct Problem {
  std::string file;
  int line = 0;      ///< from 1; 0: of the file as a whole
  std::string key;   ///< full dotted path; may be empty
  std::string text;  ///< what is wrong and what is legal

  /// "leadline.toml:14: navigation.aiding.gnss_drm_m: unknown key; the nearest known key is gnss_drms_m"
  [[nodiscard]] std::string line_text() const;
};

class Table;

/// A configuration text. Readers walk it by their key tables; it remembers what they asked for, so that
/// finish() can name every key that nobody knows. Never throws; what is wrong is in problems().
class Document {
 public:
  static constexpr std::size_t kLargest = 10 * 1024 * 1024;  ///< bytes
  static constexpr std::size_t kMostProblems = 100;          ///< more are not listed

  /// A text that is no TOML, or is too large or too deep, is an empty document with a problem.
  [[nodiscard]] static Document parse(std::string text, std::string file);
  [[nodiscard]] static Document load(const std::string& path);
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();

  /// In the order of their lines.
  [[nodiscard]] const std::vector<Problem>& problems() const&;
  void problems() const&& = delete;  // they end with their Document
  [[nodiscard]] bool ok() const { return problems().empty(); }
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const std::string& file() const;

  [[nodiscard]] Table root() &;
  /// After everything was read: reports each key and table that nobody asked for.
  void finish();
  void report(int line, std::string key, std::string text);

 private:
  friend class Table;
  struct Content;
  explicit Document(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// One table of a Document, or an absent one, which is empty. A light handle, valid as long as its Document.
class Table {
 public:
  /// The table `key` inside this one: [this.key] or key = { ... }.
  Table table(std::string_view key);
  /// The list of tables `key`: each [[this.key]]. Empty when there is none.
  std::vector<Table> tables(std::string_view key);

  /// Sets the target of each key that is present and legal; reports the others. A number may be written
  /// without a decimal point, a date with or without quotes.
  void read(const std::vector<BoundKey>& keys);
  /// Reports the key if it is absent or an empty text; true when it is there.
  bool require(std::string_view key);

  [[nodiscard]] bool given() const { return given_; }  ///< stands in the file
  [[nodiscard]] bool has(std::string_view key) const;
  /// Of its header; of the nearest table around it when it is absent.
  [[nodiscard]] int line() const;
  /// Of the key; of the table when the key is absent.
  [[nodiscard]] int line_of(std::string_view key) const;
  /// Full dotted path of a key, of the table itself when empty; list elements by their `name` or their place
  /// counted from 1: source "dvl".mount.yaw_deg, source[2].link.
  [[nodiscard]] std::string path_of(std::string_view key) const;
  void report(std::string_view key, std::string text);

 private:
  friend class Document;
  Table(Document::Content& content, Node& node, std::string path, bool given);
  Table absent(std::string_view key);

  Document::Content* content_;
  Node* node_;
  std::string path_;
  bool given_;
};

}  // namespace leadline::config
