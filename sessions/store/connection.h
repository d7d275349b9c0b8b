#pragma once

// Inside this folder only: the one place where SQLite is opened, and where its exceptions end.

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <memory>
#include <string>

#include "core/types/result.h"

namespace leadline::sessions {

enum class Open { read, read_immutable, append };

/// An open database with Leadline's pragmas. A reader is held to reading: no writes, no extensions, no side
/// effects of a foreign schema, two seconds a question.
class Connection {
 public:
  /// Throws SQLite::Exception.
  Connection(const std::string& path, Open how);

  [[nodiscard]] SQLite::Database& database() { return database_; }
  /// Begins another question: its time starts now.
  void restart_clock(std::chrono::seconds limit = std::chrono::seconds(2)) {
    clock_->deadline = std::chrono::steady_clock::now() + limit;
  }

 private:
  struct Clock {
    std::chrono::steady_clock::time_point deadline;
  };
  static int expired(void* clock);

  std::unique_ptr<Clock> clock_ = std::make_unique<Clock>();  // SQLite keeps its address
  SQLite::Database database_;
};

/// An exception of SQLite in the operator's words.
[[nodiscard]] Error error_of(const SQLite::Exception& failure, const std::string& path);

/// A question was cut off because its time was over.
[[nodiscard]] bool interrupted(const SQLite::Exception& failure);

/// The file is no SQLite database.
[[nodiscard]] bool is_no_database(const SQLite::Exception& failure);

/// Runs `work`, which returns a Result or nothing; what SQLite throws becomes an Error.
template <class Work>
auto guarded(const std::string& path, Work&& work) {
  using Returned = decltype(work());
  if constexpr (std::is_void_v<Returned>) {
    try {
      work();
      return Result<void>{};
    } catch (const SQLite::Exception& failure) {
      return Result<void>(error_of(failure, path));
    }
  } else {
    try {
      return work();
    } catch (const SQLite::Exception& failure) {
      return Returned(error_of(failure, path));
    }
  }
}

/// A text column; it may hold any bytes.
[[nodiscard]] inline std::string text_of(const SQLite::Column& column) {
  const char* text = column.getText("");
  return {text, static_cast<std::size_t>(column.getBytes())};
}

}  // namespace leadline::sessions
