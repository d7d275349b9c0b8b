#include "core/decode/iec61162_450_queue.h"

#include "core/types/expect.h"

namespace leadline::decode::udpbc {

ReportQueue::Ticket ReportQueue::add(std::uint64_t offset) {
  LL_EXPECT(!full());
  Waiting& fresh = at(end_);
  fresh = {};
  fresh.report.offset = offset;
  return end_++;
}

void ReportQueue::decide(Ticket ticket, const FrameReport& report) {
  Waiting& waiting = at(ticket);
  FrameReport decided = report;
  decided.offset = waiting.report.offset;
  decided.length = waiting.report.length;
  decided.lost = waiting.report.lost;
  waiting = {decided, true};
}

void ReportQueue::hand_on(DecoderOutput& out) {
  for (; begin_ != end_ && at(begin_).decided && at(begin_).report.length > 0; ++begin_)
    out.frame(at(begin_).report);
}

bool Group::is(const SenderName& from, const Tag& tag) const {
  return turn > 0 && id == tag.group->id && total == tag.group->total && sender == from &&
         (source.empty() || tag.source.empty() || source.view() == tag.source);
}

}  // namespace leadline::decode::udpbc
