#include "sessions/export/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/geo/geodesy.h"

namespace leadline::sessions {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// To a fixed number of parts of one, so that the last bits of a sum do not show.
Json rounded(double value, double parts) { return std::round(value * parts) / parts; }

}  // namespace

Summary::Summary(std::vector<std::string> engines, std::vector<std::string> inputs, std::string body,
                 std::vector<bool> stamped)
    : engine_names_(std::move(engines)),
      inputs_(std::move(inputs)),
      body_(std::move(body)),
      stamped_(std::move(stamped)),
      figures_(engine_names_.size()),
      clocks_(stamped_.size()) {}

void Summary::take(const Envelope& envelope) {
  if (const auto* solution = std::get_if<Solution>(&envelope.message)) {
    if (solution->engine >= figures_.size()) return;
    EngineFigures& figures = figures_[solution->engine];
    ++figures.rows;
    if (figures.last) {
      const double dt_s = seconds(envelope.valid - figures.last->first);
      if (solution->vel_north_mps && solution->vel_east_mps) {
        figures.distance_run_m += std::hypot(*solution->vel_north_mps, *solution->vel_east_mps) * dt_s;
      } else {
        const auto step = geo::difference(figures.last->second, solution->position);
        figures.distance_run_m += std::hypot(step.north_m, step.east_m);
      }
    }
    figures.last = {envelope.valid, solution->position};
  } else if (const auto* verdict = std::get_if<FixVerdict>(&envelope.message)) {
    EngineFigures& figures = figures_[verdict->engine];
    if (verdict->accepted) ++(*verdict->accepted ? figures.fixes_accepted : figures.fixes_rejected);
    if (!verdict->residual_m || (verdict->accepted && !*verdict->accepted)) return;
    figures.end_error_m = verdict->residual_m;
    figures.dr_end_error_m = verdict->dr_residual_m;
  } else if (const auto* reading = std::get_if<ClockReading>(&envelope.message)) {
    Clock& clock = clocks_[envelope.source];
    if (reading->reference_ns)
      clock.against_reference_s.push_back(static_cast<double>(*reading->reference_ns - reading->device_ns) *
                                          1e-9);
    if (!stamped_[envelope.source]) return;
    const auto telegram = reading->telegram.view();
    auto found = clock.against_arrival_s.find(telegram);
    if (found == clock.against_arrival_s.end())
      found = clock.against_arrival_s.emplace(std::string(telegram), std::vector<double>()).first;
    found->second.push_back(static_cast<double>(envelope.arrival.ns - reading->device_ns) * 1e-9);
  }
}

std::optional<double> Summary::clock_offset_s(SourceId source) const {
  const Clock& clock = clocks_[source];
  std::optional<double> least;
  for (const auto& [telegram, offsets] : clock.against_arrival_s) {
    const double offset_s = median(offsets);
    if (!least || offset_s < *least) least = offset_s;
  }
  if (least) return least;
  if (!clock.against_reference_s.empty()) return median(clock.against_reference_s);
  return std::nullopt;
}

std::string Summary::json(const Bus& bus, double wall_s) const {
  Json j;
  j["inputs"] = inputs_;
  j["body"] = body_;
  j["sources"] = Json::object();
  Json offsets = Json::object();
  for (const auto& source : bus.sources()) {
    const Ledger& ledger = bus.ledger(source.id);
    Json rejected = Json::object();
    for (const auto& reason : ledger.refusals()) rejected[std::string(reason.name)] = reason.count;
    j["sources"][source.name] = {{"frames", ledger.frames()},
                                 {"bytes", ledger.bytes_total()},
                                 {"decoded", ledger.frames(ByteClass::decoded)},
                                 {"rejected", rejected}};
    const auto offset_s = clock_offset_s(source.id);
    offsets[source.name] = offset_s ? rounded(*offset_s, 1e6) : Json(nullptr);
  }
  const auto first = bus.first_arrival();
  const double span_s = first ? seconds(bus.last_arrival() - *first) : 0.0;
  j["start_utc"] = first ? Json(iso8601(first->host(), 6)) : Json(nullptr);
  j["end_utc"] = first ? Json(iso8601(bus.last_arrival().host(), 6)) : Json(nullptr);
  j["span_s"] = rounded(span_s, 1e6);
  j["wall_s"] = rounded(wall_s, 1e6);
  j["realtime_factor"] = wall_s > 0.0 ? rounded(span_s / wall_s, 10) : Json(nullptr);
  j["clock_offset_s"] = offsets;
  j["engines"] = Json::object();
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const EngineFigures& f = figures_[i];
    const auto percent = [&](std::optional<double> error_m) {
      return error_m && f.distance_run_m > 0.0 ? std::optional(100.0 * *error_m / f.distance_run_m)
                                               : std::nullopt;
    };
    j["engines"][engine_names_[i]] = {{"rows", f.rows},
                                      {"distance_run_m", rounded(f.distance_run_m, 1e3)},
                                      {"fixes_accepted", f.fixes_accepted},
                                      {"fixes_rejected", f.fixes_rejected},
                                      {"end_error_m", or_null(f.end_error_m)},
                                      {"end_error_percent", or_null(percent(f.end_error_m))},
                                      {"dr_end_error_m", or_null(f.dr_end_error_m)},
                                      {"dr_end_error_percent", or_null(percent(f.dr_end_error_m))},
                                      {"heading_misalignment_deg", nullptr}};
  }
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace leadline::sessions
