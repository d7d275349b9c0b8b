#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/types/result.h"

namespace leadline::sessions {

inline constexpr std::uint32_t kApplicationId = 0x4C444C4E;

/// A session's file, to be written: whether it is one, and that nobody else writes it. The lock is the
/// kernel's (flock): it ends with the process, however that ends.
/// It outlives SQLite's connection, and no second one is opened by the same process: closing any descriptor
/// of a file drops all locks the process holds on it, SQLite's too. A reader opens none, for the same reason.
class SessionFile {
 public:
  SessionFile() = default;
  ~SessionFile();
  SessionFile(SessionFile&& other) noexcept { *this = std::move(other); }
  SessionFile& operator=(SessionFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(inode_, other.inode_);
    return *this;
  }

  /// A new empty file, locked. Error: it exists, or the folder does not take it.
  [[nodiscard]] static Result<SessionFile> create(const std::string& path);
  /// Error: it cannot be written, or this process has it open already.
  [[nodiscard]] static Result<SessionFile> open(const std::string& path);

  /// Error after half a second: another process records into it.
  [[nodiscard]] Result<void> lock(const std::string& path);
  /// The schema number in the file's header. Error: empty, no database, another program's database.
  [[nodiscard]] Result<int> schema(const std::string& path) const;

 private:
  [[nodiscard]] Result<void> enter(const std::string& path);

  int descriptor_ = -1;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> inode_;  // as entered among this process's
};

/// The refusal of what is no session, in one wording.
[[nodiscard]] Error no_session(const std::string& path, const std::string& what);

/// The four files that may belong to a session: itself, "-wal", "-shm", "-journal".
[[nodiscard]] std::array<std::string, 4> files_of(const std::string& path);

}  // namespace leadline::sessions
