#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sessions/store/session.h"

namespace leadline::sessions {

/// A raw frame of a session. Its bytes and words are valid until the reader goes on.
struct StoredFrame {
  RunId run = 0;
  std::uint64_t seq = 0;
  SourceId source = kNoSource;  ///< its place in that run
  Arrival arrival;
  Time wall;
  std::span<const std::uint8_t> bytes;
  SenderName sender;
  /// Why its log refused the line before any decoder saw it: one of the words of core/links; else empty.
  std::string_view settled;
};

/// The raw frames of one run in their order, a page at a time: nothing is held between pages, so that it may
/// run beside a recorder, and no table is ever in memory.
class FrameReader {
 public:
  /// from: the first number to be read.
  FrameReader(Session& session, RunId run, std::uint64_t from = 0);

  /// The next frame; false at the end. Error: the file is damaged here.
  [[nodiscard]] Result<bool> next(StoredFrame& frame);

 private:
  struct Row {
    StoredFrame frame;
    std::size_t begin, size;
  };
  [[nodiscard]] Result<void> fill();
  std::string_view settled_word(const std::string& reason, const StoredFrame& frame);

  Session& session_;
  RunId run_;
  std::int64_t after_;
  std::map<std::int64_t, SourceId> places_;
  std::vector<bool> heard_;  // sources that had a frame already
  std::vector<Row> page_;
  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool started_ = false, ended_ = false;
};

}  // namespace leadline::sessions
