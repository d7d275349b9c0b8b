#pragma once

#include "app/graph.h"
#include "app/inputs.h"
#include "sessions/export/summary.h"

namespace leadline::app {

/// Says what engines, decoders and links have to tell the operator while a run goes on.
class Speaker final : public Sink {
 public:
  explicit Speaker(const std::vector<SourceInfo>& sources) : sources_(sources) {}
  void take(const Envelope& envelope) override;

 private:
  const std::vector<SourceInfo>& sources_;
};

/// Says once, at the end, what the logs suffered. True when a frame was refused or bytes were skipped.
bool report_damage(const Bus& bus, const Inputs& inputs);
/// A device's clock that is seconds off would put its facts beside those of the others.
void report_clocks(const Bus& bus, const sessions::Summary& summary);
/// A line an engine.
void report_engines(const std::vector<std::string>& names, const sessions::Summary& summary);

}  // namespace leadline::app
