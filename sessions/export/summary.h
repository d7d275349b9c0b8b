#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/bus.h"

namespace leadline::sessions {

/// The account of a replay: summary.json of the product page.
class Summary final : public Sink {
 public:
  /// stamped: for each source, whether its log carries arrival stamps that do not come from its own clock.
  Summary(std::vector<std::string> engines, std::vector<std::string> inputs, std::string body,
          std::vector<bool> stamped);

  void take(const Envelope& envelope) override;
  /// The JSON text; the bus gives the sources' accounts, wall_s is what the run took.
  [[nodiscard]] std::string json(const Bus& bus, double wall_s) const;

  struct EngineFigures {
    std::uint64_t rows = 0, fixes_accepted = 0, fixes_rejected = 0;
    double distance_run_m = 0.0;
    std::optional<double> end_error_m, dr_end_error_m;  ///< against the last fix
    std::optional<std::pair<Time, Geodetic>> last;
  };
  [[nodiscard]] const std::vector<EngineFigures>& engines() const { return figures_; }
  /// Reference minus device, s, to be added to the device's clock: the median of the telegram that is heard
  /// with the least delay; against a GNSS inside the telegrams where the log has no stamps of its own.
  [[nodiscard]] std::optional<double> clock_offset_s(SourceId source) const;

 private:
  struct Clock {
    std::map<std::string, std::vector<double>, std::less<>> against_arrival_s;  // by telegram
    std::vector<double> against_reference_s;
  };

  std::vector<std::string> engine_names_, inputs_;
  std::string body_;
  std::vector<bool> stamped_;
  std::vector<EngineFigures> figures_;
  std::vector<Clock> clocks_;
};

}  // namespace leadline::sessions
