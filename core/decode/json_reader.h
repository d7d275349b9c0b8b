#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace leadline::decode {

/// One value of a JSON text, or where an object or list begins or ends.
struct JsonEvent {
  enum class Kind : std::uint8_t { object, object_end, list, list_end, text, number, boolean, null };
  Kind kind = Kind::null;
  /// Of a text, number or boolean as written; of a text between its quotes, escapes not undone.
  std::string_view value;
  std::string_view key;  ///< in an object, likewise; empty in a list and at an end
  int depth = 0;         ///< objects and lists around it
};

/// Reads one JSON text (RFC 8259) value by value: no allocation, no recursion, no exception. Numbers are not
/// judged here beyond their characters.
class JsonReader {
 public:
  /// Objects and lists may be inside each other this deep.
  static constexpr int kDeepest = 8;
  explicit JsonReader(std::string_view text) : p_(text.data()), end_(text.data() + text.size()) {}
  /// The next event; false at the end of the text and where it is no JSON.
  [[nodiscard]] bool next(JsonEvent& event);
  /// After next() gave false: was it one whole value and nothing else?
  [[nodiscard]] bool whole() const { return done_ && !failed_; }

 private:
  void blanks();
  bool fail();
  bool text(std::string_view& into);
  bool word(std::string_view expected);
  bool value(JsonEvent& event);
  bool close(JsonEvent& event);

  const char* p_;
  const char* end_;
  std::array<bool, kDeepest> is_object_{};
  int depth_ = 0;
  bool begun_ = false;  ///< something of the open object or list has been read
  bool done_ = false, failed_ = false;
};

}  // namespace leadline::decode
