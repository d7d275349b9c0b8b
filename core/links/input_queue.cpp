#include "core/links/input_queue.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace leadline::links {
namespace {

constexpr std::size_t kSpillPiece = std::size_t{256} << 10;  // written and read at once
constexpr std::uint32_t kMark = 0x4C4C4651;                  // each record begins with it

/// Before the bytes of a frame, in memory as in the file.
struct Head {
  std::uint32_t mark = kMark;
  std::uint32_t length = 0;
  std::uint16_t link = 0, sender_length = 0;
  std::uint32_t unused = 0;  // no byte is left to chance: the file is compared in tests
  std::int64_t arrival_ns = 0, wall_ns = 0;
};

std::size_t room_of(const InputFrame& frame) {
  return sizeof(Head) + frame.sender.size() + frame.bytes.size();
}

void append(std::vector<std::uint8_t>& to, const InputFrame& frame) {
  Head head;
  head.length = static_cast<std::uint32_t>(frame.bytes.size());
  head.link = frame.link;
  head.sender_length = static_cast<std::uint16_t>(frame.sender.size());
  head.arrival_ns = frame.arrival.ns, head.wall_ns = frame.wall.ns;
  const auto* first = reinterpret_cast<const std::uint8_t*>(&head);
  to.insert(to.end(), first, first + sizeof head);
  to.insert(to.end(), frame.sender.begin(), frame.sender.end());
  to.insert(to.end(), frame.bytes.begin(), frame.bytes.end());
}

/// The record at `at`; its length, or 0 where none is whole there.
std::size_t read(const std::vector<std::uint8_t>& from, std::size_t at, InputFrame* frame) {
  Head head;
  if (from.size() - at < sizeof head) return 0;
  std::memcpy(&head, from.data() + at, sizeof head);
  const std::size_t length = sizeof head + head.sender_length + head.length;
  if (head.mark != kMark || from.size() - at < length) return 0;
  if (frame != nullptr) {
    const auto* sender = from.data() + at + sizeof head;
    frame->link = head.link;
    frame->arrival = {head.arrival_ns};
    frame->wall = {head.wall_ns};
    frame->sender = {reinterpret_cast<const char*>(sender), head.sender_length};
    frame->bytes = {sender + head.sender_length, head.length};
  }
  return length;
}

constexpr std::uint16_t kTitle = 0xFFFF;  // the record that names the links

/// How much of a file left behind is whole records, and how many: its tail may be torn.
std::pair<std::uint64_t, std::uint64_t> whole_records(int file, std::uint64_t size) {
  std::uint64_t at = 0, count = 0;
  Head head;
  while (at + sizeof head <= size &&
         ::pread(file, &head, sizeof head, static_cast<off_t>(at)) == static_cast<ssize_t>(sizeof head)) {
    const std::uint64_t end = at + sizeof head + head.sender_length + head.length;
    if (head.mark != kMark || end > size) break;
    at = end, ++count;
  }
  return {at, count};
}

}  // namespace

InputQueue::InputQueue(const Options& options) : options_(options) {}

InputQueue::InputQueue(InputQueue&& other) noexcept
    : options_(std::move(other.options_)),
      waiting_(std::move(other.waiting_)),
      status_(std::move(other.status_)),
      spill_(std::exchange(other.spill_, -1)),
      to_spill_(std::move(other.to_spill_)),
      spill_read_(other.spill_read_),
      spill_written_(other.spill_written_),
      taken_(std::move(other.taken_)),
      at_(other.at_) {}

InputQueue::~InputQueue() {
  if (spill_ < 0) return;
  flush_spill();
  ::close(spill_);
  if (spill_read_ == spill_written_) ::unlink(options_.spill_path.c_str());
}

Result<InputQueue> InputQueue::open(const Options& options) {
  InputQueue queue(options);
  struct stat about {};
  if (options.spill_path.empty() || ::stat(options.spill_path.c_str(), &about) != 0) return queue;
  queue.spill_ = ::open(options.spill_path.c_str(), O_RDWR | O_CLOEXEC);
  if (queue.spill_ < 0)
    return Error{
        "holds input of a program that died and cannot be read (" + std::string(std::strerror(errno)) + ")",
        options.spill_path, "make it readable, or move it away"};
  const auto [bytes, records] = whole_records(queue.spill_, static_cast<std::uint64_t>(about.st_size));
  if (records == 0) {
    queue.end_spill();
    return queue;
  }
  std::vector<std::uint8_t> title, found;
  append(title, queue.title());
  found.resize(title.size());
  if (::pread(queue.spill_, found.data(), found.size(), 0) < 0 || found != title) {
    ::close(std::exchange(queue.spill_, -1));
    return Error{"holds input of a program that died, heard on other links", options.spill_path,
                 "record once with the configuration it had, or move the file away"};
  }
  queue.spill_read_ = title.size();
  queue.spill_written_ = bytes;
  queue.status_.left_behind_frames = records - 1;
  return queue;
}

InputFrame InputQueue::title() const {
  const auto* first = reinterpret_cast<const std::uint8_t*>(options_.links.data());
  return {.link = kTitle, .arrival = {}, .wall = {}, .sender = {}, .bytes = {first, options_.links.size()}};
}

void InputQueue::push(const InputFrame& frame) {
  bool was_empty = false;
  {
    const std::lock_guard lock(mutex_);
    was_empty = waiting_.empty() && spill_ < 0;
    // What came after something on the disk goes there too, or it would overtake it.
    if (spill_ >= 0 || waiting_.size() + room_of(frame) > options_.memory_bytes)
      spill(frame);
    else
      append(waiting_, frame);
  }
  if (was_empty) came_.notify_one();
}

void InputQueue::spill(const InputFrame& frame) {
  if (options_.spill_path.empty() ||
      spill_written_ + to_spill_.size() + room_of(frame) > options_.spill_bytes) {
    ++status_.lost_frames;
    if (status_.last_error.empty()) status_.last_error = "no room is left for input that waits";
    return;
  }
  if (spill_ < 0) {
    spill_ = ::open(options_.spill_path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (spill_ < 0) {
      ++status_.lost_frames;
      return spill_failed("opened");
    }
    append(to_spill_, title());
    flush_spill();
    spill_read_ = spill_written_;
  }
  append(to_spill_, frame);
  status_.spilled_bytes += frame.bytes.size();
  if (to_spill_.size() >= kSpillPiece) flush_spill();
}

void InputQueue::flush_spill() {
  std::size_t done = 0;
  while (done < to_spill_.size()) {
    const auto n = ::pwrite(spill_, to_spill_.data() + done, to_spill_.size() - done,
                            static_cast<off_t>(spill_written_ + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      for (std::size_t at = 0; at < to_spill_.size(); ++status_.lost_frames)
        at += std::max<std::size_t>(read(to_spill_, at, nullptr), 1);
      spill_failed("written");
      to_spill_.clear();
      return;
    }
    done += static_cast<std::size_t>(n);
  }
  spill_written_ += to_spill_.size();
  to_spill_.clear();
}

void InputQueue::spill_failed(const char* doing) {
  status_.last_error = options_.spill_path + " cannot be " + doing + " (" + std::strerror(errno) + ")";
}

/// The next piece of the file into the core's hands; false where it is at its end.
bool InputQueue::refill() {
  if (spill_ < 0) return false;
  flush_spill();
  const std::uint64_t left = spill_written_ - spill_read_;
  if (left == 0) {
    end_spill();
    return false;
  }
  for (std::size_t wanted = kSpillPiece;; wanted *= 4) {
    taken_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left, wanted)));
    const auto n = ::pread(spill_, taken_.data(), taken_.size(), static_cast<off_t>(spill_read_));
    if (n < 0 && errno == EINTR) continue;
    taken_.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    std::size_t whole = 0;
    while (const std::size_t length = read(taken_, whole, nullptr)) whole += length;
    if (whole > 0) {
      taken_.resize(whole);
      spill_read_ += whole;
      return true;
    }
    if (n <= 0 || static_cast<std::uint64_t>(n) == left) {  // nobody can read on from here
      spill_failed("read");
      end_spill();
      return false;
    }
  }
}

void InputQueue::end_spill() {
  ::close(std::exchange(spill_, -1));
  ::unlink(options_.spill_path.c_str());
  spill_read_ = spill_written_ = 0;
}

bool InputQueue::take(InputFrame& frame, std::chrono::milliseconds at_most) {
  if (at_ == taken_.size()) {
    taken_.clear();
    at_ = 0;
    std::unique_lock lock(mutex_);
    const auto end = std::chrono::steady_clock::now() + at_most;
    const auto came = [&] { return !waiting_.empty() || spill_ >= 0; };
    // Memory first: what is on the disk came behind it. A file read to its end is closed: then we wait again.
    while (waiting_.empty() && !refill())
      if (!came_.wait_until(lock, end, came)) return false;
    if (taken_.empty()) std::swap(taken_, waiting_);
  }
  at_ += read(taken_, at_, &frame);
  return true;
}

InputQueue::Status InputQueue::status() const {
  const std::lock_guard lock(mutex_);
  Status status = status_;
  status.waiting_bytes = waiting_.size();
  return status;
}

}  // namespace leadline::links
