#include "core/sim/telegrams/pressure_writer.h"

#include <fmt/format.h>

#include <iterator>

#include "core/decode/pressure_depth.h"
#include "core/sim/telegrams/sentence.h"

namespace leadline::sim {
namespace {

constexpr double kPaPerDbar = 1e4, kPaPerPsi = 6894.757293168;

/// The pressure above the atmosphere's at a depth: each step of Newton's leaves a thousandth of the error.
double pressure_pa(double depth_m) {
  constexpr double kPaPerMetre = 10'055.0;
  const Angle latitude = Angle::deg(decode::ProfileOptions{}.latitude_deg);
  double pa = depth_m * kPaPerMetre;
  for (int i = 0; i < 6; ++i) pa += (depth_m - decode::depth_of_pressure_m(pa, latitude)) * kPaPerMetre;
  return pa;
}

}  // namespace

void write_valeport(const DepthMeasurement& m, Telegrams& out) {
  Sentence s(out, "", "PVIPS2");
  s.text("01").text("45687").number(pressure_pa(m.depth_m) / kPaPerDbar, 3).text("d");
  s.number(m.depth_m, 3).text("M");
}

void write_paroscientific(const DepthMeasurement& m, Telegrams& out) {
  const double absolute_pa = pressure_pa(m.depth_m) + decode::kStandardAtmosphere_pa;
  fmt::format_to(std::back_inserter(out.bytes), "*0001{:.5f}\r\n", absolute_pa / kPaPerPsi);
  out.end();
}

}  // namespace leadline::sim
