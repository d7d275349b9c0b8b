#pragma once

// Inside this folder only.

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/messages/message.h"
#include "sessions/store/runs.h"

namespace leadline::sessions {

/// A message's id in the file: its run and its number there, growing with both.
inline constexpr int kSeqBits = 36;
[[nodiscard]] constexpr std::int64_t id_of(RunId run, std::uint64_t seq) {
  return (run << kSeqBits) + static_cast<std::int64_t>(seq);
}
[[nodiscard]] constexpr std::uint64_t seq_of(std::int64_t id) {
  return static_cast<std::uint64_t>(id) & ((std::uint64_t{1} << kSeqBits) - 1);
}

/// Messages to rows, one prepared statement a kind. Throws SQLite::Exception.
class MessageWriter {
 public:
  MessageWriter(SQLite::Database& database, RunId run, std::vector<std::int64_t> sources, bool stores_frames)
      : database_(database), run_(run), sources_(std::move(sources)), stores_frames_(stores_frames) {}
  void put(const Envelope& envelope);
  /// After a failure: no statement may hold the transaction.
  void reset();

 private:
  SQLite::Statement& statement(std::size_t kind, const std::string& table,
                               const std::vector<std::string>& columns);
  void bind_source(SQLite::Statement& statement, int index, SourceId place) const;

  SQLite::Database& database_;
  RunId run_;
  std::vector<std::int64_t> sources_;  // row ids by place
  bool stores_frames_;
  std::array<std::unique_ptr<SQLite::Statement>, std::variant_size_v<Message>> statements_;
};

/// Up to `most` messages of one kind (its index in Message) with after < id < end, in their order; empty at
/// the end. `failed` tells of a row that no Leadline wrote. Throws SQLite::Exception.
[[nodiscard]] std::vector<Envelope> message_page(SQLite::Database& database, std::size_t kind,
                                                 std::int64_t after, std::int64_t end, int most,
                                                 const std::map<std::int64_t, SourceId>& sources,
                                                 bool& failed);

}  // namespace leadline::sessions
