#include "core/links/merged_source.h"

#include <algorithm>
#include <limits>

namespace leadline::links {

MergedSource::MergedSource(std::vector<std::unique_ptr<Source>> sources) {
  heads_.reserve(sources.size());
  for (auto& source : sources) {
    Head& head = heads_.emplace_back();
    head.source = std::move(source);
    head.place = {std::numeric_limits<std::int64_t>::min()};
  }
}

void MergedSource::advance(Head& head) {
  head.has_chunk = head.source->next(head.chunk);
  if (head.has_chunk) head.place = std::max(head.place, head.chunk.arrival);
}

bool MergedSource::next(Chunk& chunk) {
  // A head's bytes are valid until its source is asked again: only the one handed out last is, and only now.
  if (!started_)
    for (auto& head : heads_) advance(head);
  else if (input_ < heads_.size())
    advance(heads_[input_]);
  started_ = true;

  input_ = heads_.size();
  for (std::size_t i = 0; i < heads_.size(); ++i)
    if (heads_[i].has_chunk && (input_ == heads_.size() || heads_[i].place < heads_[input_].place))
      input_ = i;
  if (input_ == heads_.size()) return false;
  chunk = heads_[input_].chunk;
  return true;
}

}  // namespace leadline::links
