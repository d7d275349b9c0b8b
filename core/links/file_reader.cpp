#include "core/links/file_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/types/expect.h"

namespace leadline::links {
namespace {

std::string words_of(int error) { return std::generic_category().message(error); }

Error open_error(const std::string& path, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return {"there is no such file", path, "check the path"};
    case EACCES:
    case EPERM:
      return {"may not be read", path, "give yourself read permission or copy it"};
    default:
      return {"cannot be opened (" + words_of(error) + ")", path, "check the path and the disk"};
  }
}

}  // namespace

Result<FileReader> FileReader::open(const std::string& path) {
  // Without O_NONBLOCK a named pipe would hold us here until somebody writes.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return open_error(path, errno);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    const int error = errno;
    ::close(descriptor);
    return open_error(path, error);
  }
  if (!S_ISREG(status.st_mode)) {
    ::close(descriptor);
    if (S_ISDIR(status.st_mode)) return Error{"is a folder", path, "name the files in it"};
    return Error{"is not a plain file", path, "write its content to a file first: a replay reads it twice"};
  }
  return FileReader(path, descriptor, static_cast<std::uint64_t>(status.st_size));
}

FileReader::FileReader(std::string path, int descriptor, std::uint64_t size)
    : path_(std::move(path)),
      descriptor_(descriptor),
      size_(size),
      window_(std::make_unique_for_overwrite<char[]>(kWindow)) {}

FileReader::~FileReader() { close(); }

void FileReader::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

FileReader::FileReader(FileReader&& other) noexcept { *this = std::move(other); }

FileReader& FileReader::operator=(FileReader&& other) noexcept {
  if (this == &other) return *this;
  close();
  path_ = std::move(other.path_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  size_ = other.size_, offset_ = other.offset_;
  window_ = std::move(other.window_);
  begin_ = std::exchange(other.begin_, 0), end_ = std::exchange(other.end_, 0);
  ended_ = std::exchange(other.ended_, true);
  line_goes_on_ = other.line_goes_on_;
  failure_ = std::move(other.failure_);
  return *this;
}

void FileReader::fill(std::size_t wanted) {
  if (end_ - begin_ >= wanted || ended_) return;
  std::memmove(window_.get(), window_.get() + begin_, end_ - begin_);
  end_ -= begin_, begin_ = 0;
  while (end_ < kWindow) {
    const ssize_t got = ::read(descriptor_, window_.get() + end_, kWindow - end_);
    if (got > 0) {
      end_ += static_cast<std::size_t>(got);
    } else if (got == 0 || errno != EINTR) {
      if (got < 0)
        failure_ = Error{"cannot be read further (" + words_of(errno) + ")", path_, "check the disk"};
      ended_ = true;
      return;
    }
  }
}

bool FileReader::line(std::string_view& out) {
  fill(kLineCeiling + 1);  // one more: whether a line at the ceiling goes on
  const std::size_t have = std::min(end_ - begin_, kLineCeiling);
  line_goes_on_ = false;
  if (have == 0) return false;
  const char* const start = window_.get() + begin_;
  const void* const newline = std::memchr(start, '\n', have);
  const std::size_t length =
      newline ? static_cast<std::size_t>(static_cast<const char*>(newline) - start) + 1 : have;
  out = {start, length};
  consume(length);
  line_goes_on_ = newline == nullptr && begin_ < end_;
  return true;
}

std::span<const std::uint8_t> FileReader::peek(std::size_t n) {
  LL_EXPECT(n <= kWindow);
  fill(n);
  return {reinterpret_cast<const std::uint8_t*>(window_.get()) + begin_, std::min(n, end_ - begin_)};
}

std::span<const std::uint8_t> FileReader::take(std::size_t n) {
  const auto bytes = peek(n);
  line_goes_on_ = false;
  consume(bytes.size());
  return bytes;
}

void FileReader::rewind() {
  failure_.reset();
  begin_ = end_ = 0, offset_ = 0;
  line_goes_on_ = false;
  ended_ = ::lseek(descriptor_, 0, SEEK_SET) != 0;
  if (ended_) failure_ = Error{"cannot be read again (" + words_of(errno) + ")", path_, "check the disk"};
}

}  // namespace leadline::links
