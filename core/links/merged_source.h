#pragma once

#include <memory>
#include <vector>

#include "core/flow/source.h"

namespace leadline::links {

/// Several Sources as one timeline: always the chunk with the earliest arrival; equal ones in the order of
/// the list (the command line's), then of their file. A source whose stamps go back takes the place of its
/// latest so far, and its chunks keep their own stamps: the order is the same each time.
class MergedSource final : public Source {
 public:
  explicit MergedSource(std::vector<std::unique_ptr<Source>> sources);
  bool next(Chunk& chunk) override;
  /// Which of the list the last chunk came from.
  [[nodiscard]] std::size_t input() const { return input_; }

 private:
  struct Head {
    std::unique_ptr<Source> source;
    Chunk chunk;
    Arrival place;  ///< in the timeline: the latest arrival of the source so far
    bool has_chunk = false;
  };
  static void advance(Head& head);

  std::vector<Head> heads_;
  std::size_t input_ = 0;
  bool started_ = false;
};

}  // namespace leadline::links
