#include "sessions/store/session_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>

namespace leadline::sessions {
namespace {

std::string reason() { return std::strerror(errno); }

std::uint32_t big32(const unsigned char* b) {
  return static_cast<std::uint32_t>(b[0]) << 24 | static_cast<std::uint32_t>(b[1]) << 16 |
         static_cast<std::uint32_t>(b[2]) << 8 | b[3];
}

using Inode = std::pair<std::uint64_t, std::uint64_t>;

/// The files that this process writes sessions into.
struct OwnFiles {
  std::mutex mutex;
  std::set<Inode> inodes;
};
OwnFiles& own_files() {
  static OwnFiles files;
  return files;
}

Inode inode_of(const struct stat& status) { return {status.st_dev, status.st_ino}; }

Error taken(const std::string& path) {
  return {"another Leadline records into it", path,
          "end that one first, or record into another session; it can be watched meanwhile"};
}

}  // namespace

Error no_session(const std::string& path, const std::string& what) {
  return {what, path, "it is left as it is; name another file"};
}

SessionFile::~SessionFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!inode_) return;
  const std::lock_guard lock(own_files().mutex);
  own_files().inodes.erase(*inode_);
}

Result<void> SessionFile::enter(const std::string& path) {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode))
    return Error{"is no file", path, "name a session file"};
  const std::lock_guard lock(own_files().mutex);
  if (!own_files().inodes.insert(inode_of(status)).second) return taken(path);
  inode_ = inode_of(status);
  return {};
}

Result<SessionFile> SessionFile::create(const std::string& path) {
  SessionFile file;
  file.descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file.descriptor_ < 0 && errno == EEXIST)
    return Error{"exists already", path, "choose another name, or replace it with --force"};
  if (file.descriptor_ < 0)
    return Error{"the session cannot be made: " + reason(), path,
                 "choose a folder that exists and can be written"};
  if (auto entered = file.enter(path); !entered) return entered.error();
  if (auto locked = file.lock(path); !locked) return locked.error();
  return file;
}

Result<SessionFile> SessionFile::open(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {  // before a descriptor is there that would have to be closed
    const std::lock_guard lock(own_files().mutex);
    if (own_files().inodes.count(inode_of(status)) != 0) return taken(path);
  }
  SessionFile file;
  file.descriptor_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file.descriptor_ < 0)
    return Error{"cannot be written: " + reason(), path,
                 errno == ENOENT ? "is the name right?" : "is it yours, and its folder?"};
  if (auto entered = file.enter(path); !entered) return entered.error();
  return file;
}

Result<void> SessionFile::lock(const std::string& path) {
  constexpr int kTries = 10;
  for (int i = 0; i < kTries; ++i) {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return {};
    if (errno != EWOULDBLOCK) return Error{"cannot be locked: " + reason(), path, "use a local disk"};
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return taken(path);
}

Result<int> SessionFile::schema(const std::string& path) const {
  std::array<unsigned char, 100> head{};
  const ssize_t size = ::pread(descriptor_, head.data(), head.size(), 0);
  if (size < 0) return no_session(path, "cannot be read: " + reason());
  if (size == 0) return no_session(path, "is empty, so it is no session");
  if (size < static_cast<ssize_t>(head.size()) || std::memcmp(head.data(), "SQLite format 3", 16) != 0)
    return no_session(path, "is no Leadline session, or its beginning is damaged");
  if (big32(head.data() + 68) != kApplicationId)
    return no_session(path, "is another program's database, no Leadline session");
  return static_cast<int>(big32(head.data() + 60));
}

std::array<std::string, 4> files_of(const std::string& path) {
  return {path, path + "-wal", path + "-shm", path + "-journal"};
}

}  // namespace leadline::sessions
