#include "core/links/live_inputs.h"

#include <algorithm>

#include "core/types/expect.h"

namespace leadline::links {
namespace {

/// The wall clock is told beside the arrival only where it was set meanwhile.
constexpr std::int64_t kSameNs = 1'000'000;

}  // namespace

LiveInputs::LiveInputs(InputQueue queue, std::vector<Line> lines)
    : queue_(std::move(queue)),
      lines_(std::move(lines)),
      overload_(lines_.size()),
      left_behind_(queue_.status().left_behind_frames) {
  frame_.link = static_cast<std::uint16_t>(lines_.size());
}

Result<std::unique_ptr<LiveInputs>> LiveInputs::open(IoLoop& loop, const std::vector<WantedInput>& wanted,
                                                     const Options& options) {
  std::vector<Line> lines;
  for (const auto& [source, address] : wanted) {
    const auto same = [&a = address](const Line& line) { return line.address == a; };
    auto line = std::find_if(lines.begin(), lines.end(), same);
    if (line == lines.end()) line = lines.insert(line, Line{address, {}, nullptr, {}});
    line->sources.push_back(source);
  }
  auto queue_options = options.queue;
  for (const Line& line : lines) queue_options.links += line.address.text() + "\n";
  auto queue = InputQueue::open(queue_options);
  if (!queue) return queue.error();
  auto inputs = std::unique_ptr<LiveInputs>(new LiveInputs(std::move(queue).value(), std::move(lines)));
  for (std::size_t i = 0; i < inputs->lines_.size(); ++i) {
    Line& line = inputs->lines_[i];
    const auto hear = [to = inputs.get(), link = static_cast<std::uint16_t>(i)](const Hearing& heard) {
      const ArrivalClock& clock = to->clock_;
      const Arrival arrival = heard.kernel_wall_ns ? clock.heard_at(*heard.kernel_wall_ns) : clock.now();
      to->queue_.push({.link = link,
                       .arrival = arrival,
                       .wall = clock.wall(),
                       .sender = heard.sender,
                       .bytes = heard.bytes});
    };
    line.receiver = std::make_unique<LinkReceiver>(loop, line.address, options.limits, hear);
  }
  return inputs;
}

LiveInputs::~LiveInputs() { close(); }

void LiveInputs::close() {
  for (Line& line : lines_) {
    if (!line.receiver) continue;
    line.last = line.receiver->status();
    line.receiver.reset();
  }
}

bool LiveInputs::take(Chunk& chunk, std::chrono::milliseconds at_most) {
  if (frame_.link >= lines_.size() || next_source_ == lines_[frame_.link].sources.size()) {
    next_source_ = 0;
    if (!queue_.take(frame_, at_most)) {
      frame_.link = static_cast<std::uint16_t>(lines_.size());
      return false;
    }
    LL_EXPECT(frame_.link < lines_.size());
    // What a former program left is old, and not because of us.
    const bool ours = left_behind_ == 0;
    if (!ours) --left_behind_;
    refused_ = ours && !overload_.decode(frame_.link, frame_.bytes.size(), frame_.arrival, clock_.now());
  }
  chunk = Chunk{};
  chunk.source = lines_[frame_.link].sources[next_source_++];
  chunk.arrival = frame_.arrival;
  const std::int64_t apart_ns = frame_.wall.ns - frame_.arrival.ns;
  if (apart_ns > kSameNs || apart_ns < -kSameNs) chunk.wall = frame_.wall;
  chunk.bytes = frame_.bytes;
  chunk.sender = frame_.sender;
  if (refused_) chunk.settled = ByteClass::refused, chunk.reason = "overload";
  return true;
}

std::vector<LiveInputs::State> LiveInputs::states() const {
  std::vector<State> states;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    states.push_back({lines_[i].address, lines_[i].sources,
                      lines_[i].receiver ? lines_[i].receiver->status() : lines_[i].last,
                      overload_.not_decoded(i)});
  return states;
}

}  // namespace leadline::links
