#include "sessions/export/solution_csv.h"

#include <cmath>
#include <filesystem>
#include <system_error>

namespace leadline::sessions {
namespace {

constexpr std::string_view kSolutionColumns =
    "unix_s,utc,lat_deg,lon_deg,depth_m,roll_deg,pitch_deg,heading_deg,vel_north_mps,vel_east_mps,vel_down_"
    "mps,"
    "sd_north_m,sd_east_m,sd_down_m,sd_heading_deg,heading_bias_deg,mode,position_source";
constexpr std::string_view kFixColumns =
    "unix_s,source,body,lat_deg,lon_deg,depth_m,residual_m,gate_m,accepted";

std::string_view name_of(Mode mode) {
  constexpr std::string_view kNames[] = {"A", "B", "C", "D", "E1", "E0"};
  return kNames[static_cast<std::size_t>(mode)];
}

std::string_view name_of(PositionSource source) {
  return source == PositionSource::gnss ? "gnss" : source == PositionSource::usbl ? "usbl" : "";
}

std::optional<double> degrees(std::optional<Angle> angle) {
  return angle ? std::optional(angle->deg()) : std::nullopt;
}

std::optional<double> metres(std::optional<Depth> depth) {
  return depth ? std::optional(depth->m) : std::nullopt;
}

/// Rounding must not print the heading 360.
std::optional<double> heading_degrees(std::optional<Angle> heading) {
  if (!heading) return std::nullopt;
  const double deg = heading->wrapped_2pi().deg();
  return deg >= 359.999995 ? 0.0 : deg;
}

}  // namespace

Result<SolutionCsv> SolutionCsv::create(const std::string& folder, const std::vector<std::string>& engines,
                                        const std::vector<SourceInfo>& sources) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"cannot be made: " + failed.message(), folder, "choose another --csv folder"};
  SolutionCsv sink;
  sink.folder_ = folder;
  for (const auto& source : sources) {
    sink.source_names_.push_back(csv_text(source.name));
    sink.source_bodies_.push_back(leadline::name_of(source.body));
  }
  std::filesystem::remove(folder + "/ship.csv", failed);
  for (std::size_t i = 0; i < engines.size(); ++i) {
    auto solution = CsvFile::create(folder + "/" + engines[i] + ".csv", kSolutionColumns);
    if (!solution) return solution.error();
    auto fixes =
        CsvFile::create(folder + (i == 0 ? "/fixes.csv" : "/" + engines[i] + "_fixes.csv"), kFixColumns);
    if (!fixes) return fixes.error();
    sink.solutions_.push_back(std::move(solution).value());
    sink.fixes_.push_back(std::move(fixes).value());
  }
  return sink;
}

void SolutionCsv::row(CsvFile& csv, Time t, const Solution& s) {
  csv.time(t);
  csv.iso(t);
  csv.number(s.position.lat.deg(), 10);
  csv.number(s.position.lon.deg(), 10);
  csv.number(metres(s.depth), 3);
  csv.number(degrees(s.roll), 4);
  csv.number(degrees(s.pitch), 4);
  csv.number(heading_degrees(s.heading), 5);
  csv.number(s.vel_north_mps, 5);
  csv.number(s.vel_east_mps, 5);
  csv.number(s.vel_down_mps, 5);
  csv.number(std::sqrt(s.var_north_m2), 4);
  csv.number(std::sqrt(s.var_east_m2), 4);
  csv.number(s.sd_down_m, 4);
  csv.number(degrees(s.sd_heading), 5);
  csv.number(degrees(s.heading_bias), 5);
  csv.text(s.mode ? name_of(*s.mode) : "");
  csv.text(name_of(s.position_source));
  csv.end_row();
}

void SolutionCsv::take(const Envelope& envelope) {
  if (const auto* solution = std::get_if<Solution>(&envelope.message)) {
    if (solution->engine < solutions_.size()) {
      row(solutions_[solution->engine], envelope.valid, *solution);
    } else if (solution->engine == kShipTrack) {
      if (!ship_) {
        auto created = CsvFile::create(folder_ + "/ship.csv", kSolutionColumns);
        if (!created) {
          failure_ = created.error();
          return;
        }
        ship_ = std::move(created).value();
      }
      row(*ship_, envelope.valid, *solution);
    }
  } else if (const auto* verdict = std::get_if<FixVerdict>(&envelope.message)) {
    if (verdict->engine >= fixes_.size()) return;
    CsvFile& csv = fixes_[verdict->engine];
    csv.time(envelope.valid);
    csv.text(source_names_[envelope.source]);
    csv.text(source_bodies_[envelope.source]);
    csv.number(verdict->position.lat.deg(), 10);
    csv.number(verdict->position.lon.deg(), 10);
    csv.number(metres(verdict->depth), 3);
    csv.number(verdict->residual_m, 3);
    csv.number(verdict->gate_m, 3);
    csv.flag(verdict->accepted);
    csv.end_row();
  }
}

Result<void> SolutionCsv::close() {
  if (failure_) return *failure_;
  for (auto* files : {&solutions_, &fixes_})
    for (CsvFile& csv : *files)
      if (auto closed = csv.close(); !closed) return closed;
  return ship_ ? ship_->close() : Result<void>{};
}

}  // namespace leadline::sessions
