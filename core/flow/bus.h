#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/flow/decoder.h"
#include "core/flow/engine.h"
#include "core/flow/ledger.h"
#include "core/flow/source.h"
#include "core/flow/source_info.h"

namespace leadline {

/// Numbers everything and hands it on in one fixed order: raw bytes to the sinks (the recorder is the first),
/// then to their decoder; each fact to the sinks, then to the engines; what engines say after the fact that
/// made them speak. Derives the Ticks. One thread.
class Bus final : private EngineOutput {
 public:
  explicit Bus(std::vector<SourceInfo> sources);
  ~Bus() override;

  /// The decoder of a source; a source without one is recorded only.
  void attach(SourceId source, std::unique_ptr<Decoder> decoder);
  void attach(Engine& engine) { engines_.push_back(&engine); }
  void attach(Sink& sink) { sinks_.push_back(&sink); }

  /// One chunk. Arrivals must not go back: an earlier one is taken as the latest so far (`clock_steps`
  /// counts).
  void take(const Chunk& chunk);
  /// Nothing was heard until then: Ticks go on, so that time-outs happen in silence. An earlier time than the
  /// latest arrival says nothing.
  void pass_time(Arrival now);
  /// Something the host has to say besides what was heard: a link that is down, a disk that fills.
  void tell(const Message& message, SourceId source = kNoSource);
  /// The end of all input: decoders give up what they hold.
  void finish();

  [[nodiscard]] const std::vector<SourceInfo>& sources() const { return sources_; }
  [[nodiscard]] const Ledger& ledger(SourceId source) const { return ledgers_[source]; }
  /// The account of bytes that belong to no configured source.
  [[nodiscard]] const Ledger& stray() const { return ledgers_.back(); }
  [[nodiscard]] std::uint64_t clock_steps() const { return clock_steps_; }
  [[nodiscard]] std::optional<Arrival> first_arrival() const { return first_; }
  [[nodiscard]] Arrival last_arrival() const { return now_; }

 private:
  class Output;  // turns one decoder's facts into envelopes

  void advance_to(Arrival arrival);
  void deliver(Envelope& envelope);
  void publish(Time valid, const Message& message, SourceId source) override;

  std::vector<SourceInfo> sources_;
  std::vector<std::unique_ptr<Decoder>> decoders_;
  std::vector<std::uint64_t> raws_;  // seq of each source's latest RawFrame
  std::vector<Ledger> ledgers_;      // one a source, the last one for strays
  std::vector<Engine*> engines_;
  std::vector<Sink*> sinks_;
  std::vector<Envelope> said_;  // by engines, waiting for their turn
  std::uint64_t seq_ = 0;
  std::uint64_t clock_steps_ = 0;
  std::optional<Arrival> first_;
  Arrival now_, next_tick_;
};

}  // namespace leadline
