#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/types/result.h"
#include "core/types/time.h"

namespace leadline::sessions {

/// A text a spreadsheet will not take for a formula: quoted when it needs it, and led by ' where it begins
/// with = + - @ and is no number.
[[nodiscard]] std::string csv_text(std::string_view text);

/// One CSV file, written row by row through one buffer. What is not known is an empty field.
class CsvFile {
 public:
  /// Error: the file cannot be made.
  [[nodiscard]] static Result<CsvFile> create(const std::string& path, std::string_view header);

  void time(Time t);  ///< seconds since 1970 with 6 decimals, rounded to the nearest
  void iso(Time t);   ///< the same as ISO 8601 with milliseconds
  void text(std::string_view text) { field(), row_.append(text); }
  void number(std::optional<double> value, int decimals);
  void flag(std::optional<bool> value) { field(), row_.append(!value ? "" : *value ? "1" : "0"); }
  void end_row();

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Writes what is buffered. Error: the disk did not take it all.
  [[nodiscard]] Result<void> close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void field() {
    if (begun_) row_.push_back(',');
    begun_ = true;
  }

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  fmt::memory_buffer buffer_;
  std::string row_;
  bool begun_ = false, failed_ = false;
  std::size_t rows_ = 0;
};

}  // namespace leadline::sessions
