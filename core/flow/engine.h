#pragma once

#include "core/messages/message.h"

namespace leadline {

/// Where an Engine puts its results.
class EngineOutput {
 public:
  virtual ~EngineOutput() = default;
  /// A Solution, FixVerdict, ModeChange or Health, true at `valid`; source: the fix's source for a
  /// FixVerdict.
  virtual void publish(Time valid, const Message& message, SourceId source = kNoSource) = 0;
};

/// Facts to navigation solutions: a pure function of what it was given and of its configuration. It has no
/// clock, file, thread or global; the same messages in the same order give the same bits.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Every fact and Tick in the Bus's order.
  virtual void take(const Envelope& envelope, EngineOutput& out) = 0;
};

/// Takes everything the Bus numbers, in order: recorder, screen, exporters.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void take(const Envelope& envelope) = 0;
};

}  // namespace leadline
