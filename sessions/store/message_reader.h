#pragma once

// Inside this folder only.

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/messages/message.h"
#include "sessions/store/session.h"

namespace leadline::sessions {

/// Messages of one run out of their tables, by number; every statement is prepared once and kept. Nothing is
/// held between calls. Throws SQLite::Exception.
class MessageReader {
 public:
  static constexpr std::size_t kKinds = std::variant_size_v<Message>;

  MessageReader(SQLite::Database& database, RunId run);
  [[nodiscard]] RunId run() const { return run_; }
  /// A row was met that no Leadline wrote.
  [[nodiscard]] bool failed() const { return failed_; }

  /// Up to `most` messages in bus order, of the kinds and numbers asked for. Returns the number to go on
  /// with; empty: the end was reached, or `take` said so.
  std::optional<std::uint64_t> read(const Reading& reading, int most,
                                    const std::function<bool(const Envelope&)>& take);
  /// The last `most` of one kind and speaker with floor <= seq < end, newest first, behind those in `found`.
  void read_last(std::size_t kind, std::uint64_t floor, std::uint64_t end, std::size_t most,
                 const Speaker& speaker, std::vector<Envelope>& found);
  /// Number and arrival of the first message of any kind, or of `kind` alone, with seq >= from.
  struct Found {
    std::uint64_t seq;
    Arrival arrival;
  };
  std::optional<Found> first_from(std::uint64_t from, std::optional<std::size_t> kind = {});
  /// The number of the newest message of one kind before `end`.
  std::optional<std::uint64_t> newest_before(std::size_t kind, std::uint64_t end);

 private:
  enum class What : std::uint8_t { whole, head, last };
  using Prepared = std::array<std::unique_ptr<SQLite::Statement>, kKinds>;

  SQLite::Statement& statement(What what, std::size_t kind);
  void take_row(What what, std::size_t kind, SQLite::Statement& row, Envelope& envelope);
  [[nodiscard]] std::int64_t id(std::uint64_t seq) const;

  SQLite::Database& database_;
  RunId run_;
  std::map<std::int64_t, SourceId> places_;
  std::array<Prepared, 3> prepared_;
  std::array<Envelope, kKinds> next_;  // the row each kind waits with
  bool failed_ = false;
};

}  // namespace leadline::sessions
