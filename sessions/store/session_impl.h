#pragma once

// Inside this folder only.

#include <memory>
#include <optional>
#include <string>

#include "sessions/store/connection.h"
#include "sessions/store/message_reader.h"
#include "sessions/store/message_rows.h"
#include "sessions/store/session.h"
#include "sessions/store/session_file.h"

namespace leadline::sessions {

struct Session::Impl {
  std::string path;
  SessionFile file;  // outlives the connection
  std::unique_ptr<Connection> connection;
  std::optional<MessageReader> reader;  // of the run that was read last
  std::optional<MessageWriter> writer;  // of the current run
  RunId run = 0;
  Sync sync = Sync::normal;

  /// The database for one more question.
  SQLite::Database& database() {
    connection->restart_clock();
    return connection->database();
  }
  bool append = false;

  /// The log into the file; where a screen watches, it keeps the log, and the next close folds it.
  void fold() {
    reader.reset();
    writer.reset();
    database().setBusyTimeout(0);
    if (database().tryExec("PRAGMA journal_mode = DELETE") != 0) database().tryExec("PRAGMA wal_checkpoint");
  }
  ~Impl() {
    reader.reset();  // their statements before the database
    writer.reset();
    if (append && connection) try {
        fold();
      } catch (const SQLite::Exception&) {  // the log stays beside the file, which loses nothing
      }
  }
};

}  // namespace leadline::sessions
