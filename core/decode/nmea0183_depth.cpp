// Echo sounders: DBT, DPT; a pressure sensor: PVIPS2.

#include "core/decode/nmea0183_sentences.h"
#include "core/decode/valeport.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr double kDeepest_m = 20'000.0;
constexpr double kPaPerDbar = 1e4;
constexpr double kMetresPerFoot = 0.3048, kMetresPerFathom = 1.8288;

}  // namespace

Verdict read_dbt(Fields& f, Reading& r) {
  f.require(2);
  const auto feet = f.number(1, 0.0, kDeepest_m / kMetresPerFoot), metres = f.number(3, 0.0, kDeepest_m),
             fathoms = f.number(5, 0.0, kDeepest_m / kMetresPerFathom);
  if (!f.refusal().empty()) return refused(f.refusal());
  std::optional<double> depth = metres;
  if (!depth && feet) depth = *feet * kMetresPerFoot;
  if (!depth && fathoms) depth = *fathoms * kMetresPerFathom;
  if (depth) r.out.fact(std::nullopt, BottomDepth{*depth, BottomDepth::Below::transducer});
  return decoded();
}

Verdict read_dpt(Fields& f, Reading& r) {
  f.require(1);
  const auto below_transducer = f.number(1, 0.0, kDeepest_m), offset = f.number(2, -kDeepest_m, kDeepest_m);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!below_transducer) return decoded();
  using Below = BottomDepth::Below;
  const double depth = *below_transducer + offset.value_or(0.0);
  if (depth < 0.0) return refused(kReasonRange);
  const Below below = !offset || *offset == 0.0 ? Below::transducer
                      : *offset > 0.0           ? Below::surface
                                                : Below::keel;
  r.out.fact(std::nullopt, BottomDepth{depth, below});
  return decoded();
}

Verdict read_pvips2(Fields& f, Reading& r) {
  const MiniIps2 said = read_mini_ips2(f);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (said.pressure_dbar) r.out.fact(std::nullopt, Pressure{*said.pressure_dbar * kPaPerDbar});
  if (said.depth_m) r.out.fact(std::nullopt, DepthMeasured{Depth{*said.depth_m}, {}});
  return decoded();
}

}  // namespace leadline::decode::nmea0183
