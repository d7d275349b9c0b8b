#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/types/expect.h"

namespace leadline {

/// An expected failure at a door, in the operator's words: what happened, where, what to do about it.
struct Error {
  std::string what;
  std::string where;   ///< file, file:line, link or source; may be empty
  std::string remedy;  ///< what the reader can do; may be empty

  /// One line: "where: what; remedy".
  [[nodiscard]] std::string line() const {
    std::string text = where.empty() ? what : where + ": " + what;
    if (!remedy.empty()) text += "; " + remedy;
    return text;
  }
};

/// A value or an Error: a small subset of C++23's std::expected, which g++ 12 does not yet have.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  [[nodiscard]] T& value() & { return checked(), std::get<0>(content_); }
  [[nodiscard]] const T& value() const& { return checked(), std::get<0>(content_); }
  [[nodiscard]] T&& value() && { return checked(), std::get<0>(std::move(content_)); }
  [[nodiscard]] const Error& error() const {
    LL_EXPECT(!ok());
    return std::get<1>(content_);
  }

 private:
  void checked() const { LL_EXPECT(ok()); }
  std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  [[nodiscard]] bool ok() const { return ok_; }
  explicit operator bool() const { return ok_; }
  [[nodiscard]] const Error& error() const {
    LL_EXPECT(!ok_);
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace leadline
