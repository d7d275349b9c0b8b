#include "core/flow/bus.h"

#include <algorithm>

#include "core/types/expect.h"

namespace leadline {
namespace {

constexpr std::int64_t kTickNs = 100'000'000;
/// Every time-out is far shorter: of a silence longer than this only its beginning is told tick by tick, and
/// its end by one, not by millions.
constexpr std::int64_t kLongestSilenceNs = 3'600 * std::int64_t{1'000'000'000};

}  // namespace

class Bus::Output final : public DecoderOutput {
 public:
  Output(Bus& bus, SourceId source, Ledger& ledger) : bus_(bus), ledger_(ledger) {
    envelope_.source = source;
  }

  void fact(std::optional<Time> device_time, const Message& message) override {
    const SourceInfo& source = bus_.sources_[envelope_.source];
    send(validity(source, device_time, bus_.now_), message);
  }

  void frame(const FrameReport& report) override {
    ledger_.count(report, bus_.now_);
    if (report.byte_class == ByteClass::refused)
      send(bus_.now_.host(), Rejected{report.reason, report.offset, report.length});
  }

 private:
  void send(Time valid, const Message& message) {
    envelope_.raw = bus_.raws_[envelope_.source];
    envelope_.valid = valid;
    envelope_.arrival = bus_.now_;
    envelope_.wall_utc = bus_.now_.host();
    envelope_.message = message;
    bus_.deliver(envelope_);
  }

  Bus& bus_;
  Ledger& ledger_;
  Envelope envelope_;
};

Bus::Bus(std::vector<SourceInfo> sources)
    : sources_(std::move(sources)),
      decoders_(sources_.size()),
      raws_(sources_.size()),
      ledgers_(sources_.size() + 1) {}

Bus::~Bus() = default;

void Bus::attach(SourceId source, std::unique_ptr<Decoder> decoder) {
  LL_EXPECT(source < decoders_.size());
  decoders_[source] = std::move(decoder);
}

void Bus::advance_to(Arrival arrival) {
  if (!first_) {
    first_ = now_ = arrival;
    next_tick_ = {(arrival.ns / kTickNs + 1) * kTickNs};
  }
  if (arrival < now_) {
    ++clock_steps_;
    return;
  }
  const std::int64_t silent_from_ns = next_tick_.ns;
  Envelope tick;
  for (; next_tick_ <= arrival; next_tick_.ns += kTickNs) {
    if (next_tick_.ns - silent_from_ns > kLongestSilenceNs) next_tick_ = {arrival.ns / kTickNs * kTickNs};
    now_ = next_tick_;
    tick.valid = tick.wall_utc = next_tick_.host();
    tick.arrival = next_tick_;
    tick.message = Tick{next_tick_};
    deliver(tick);
  }
  now_ = arrival;
}

void Bus::pass_time(Arrival now) {
  if (!first_ || now > now_) advance_to(now);
}

void Bus::tell(const Message& message, SourceId source) {
  Envelope envelope;
  envelope.valid = envelope.wall_utc = now_.host();
  envelope.arrival = now_;
  envelope.source = source;
  envelope.message = message;
  deliver(envelope);
}

void Bus::take(const Chunk& chunk) {
  const bool known = chunk.source < sources_.size();
  Ledger& ledger = known ? ledgers_[chunk.source] : ledgers_.back();
  ledger.count(chunk);
  if (chunk.settled && *chunk.settled != ByteClass::refused) return;
  if (chunk.bytes.empty() && !chunk.settled) return pass_time(chunk.arrival);
  advance_to(chunk.arrival);

  Envelope envelope;
  envelope.source = known ? chunk.source : kNoSource;
  envelope.valid = now_.host();
  envelope.wall_utc = chunk.wall.value_or(now_.host());
  envelope.arrival = now_;
  envelope.message = RawFrame{chunk.bytes, SenderName(chunk.sender)};
  deliver(envelope);
  if (known) raws_[chunk.source] = envelope.seq;

  if (chunk.settled) {
    envelope.raw = envelope.seq;
    envelope.message = Rejected{chunk.reason, 0, static_cast<std::uint32_t>(chunk.bytes.size())};
    deliver(envelope);
  } else if (known && decoders_[chunk.source]) {
    Output out(*this, chunk.source, ledger);
    decoders_[chunk.source]->sender(chunk.sender);
    decoders_[chunk.source]->feed(chunk.bytes, now_, out);
  } else {  // nobody else accounts for these bytes
    ledger.count({.byte_class = known ? ByteClass::unused : ByteClass::unknown,
                  .length = static_cast<std::uint32_t>(chunk.bytes.size())},
                 now_);
  }
}

void Bus::finish() {
  for (std::size_t i = 0; i < decoders_.size(); ++i) {
    const auto id = static_cast<SourceId>(i);
    if (!decoders_[id]) continue;
    Output out(*this, id, ledgers_[id]);
    decoders_[id]->finish(out);
  }
}

void Bus::deliver(Envelope& envelope) {
  envelope.seq = ++seq_;
  for (Sink* sink : sinks_) sink->take(envelope);
  for (Engine* engine : engines_) engine->take(envelope, *this);
  for (std::size_t i = 0; i < said_.size();
       ++i) {  // engines do not hear engines: the list does not grow here
    said_[i].seq = ++seq_;
    for (Sink* sink : sinks_) sink->take(said_[i]);
  }
  said_.clear();
}

void Bus::publish(Time valid, const Message& message, SourceId source) {
  said_.push_back({.seq = 0,
                   .raw = 0,
                   .valid = valid,
                   .arrival = now_,
                   .wall_utc = now_.host(),
                   .source = source,
                   .message = message});
}

}  // namespace leadline
