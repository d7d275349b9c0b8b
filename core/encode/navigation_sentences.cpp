#include "core/encode/navigation_sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/encode/sentence.h"

namespace leadline::encode {
namespace {

constexpr std::string_view kTalker = "IN";
constexpr double kKnotsPerMps = 3600.0 / 1852.0, kKmhPerMps = 3.6;
constexpr double kAtRest_mps = 0.05;
constexpr int kMinuteDecimals = 7, kTimeDecimals = 3, kSpeedDecimals = 3, kAngleDecimals = 2,
              kMetreDecimals = 3;

/// How good a position is, in the words of the standard.
struct Standing {
  bool told = false;  ///< the position may be said
  char status = 'V';  ///< of RMC, GLL
  char mode = 'N';    ///< the mode indicator
  std::string_view quality = "0";
};

Standing standing_of(const std::optional<Solution>& solution) {
  constexpr Standing kVoid{}, kFixed{true, 'A', 'A', "1"}, kEstimated{true, 'V', 'E', "6"};
  if (!solution || !std::isfinite(solution->position.lat.rad()) ||
      !std::isfinite(solution->position.lon.rad()))
    return kVoid;
  if (!solution->mode)
    return solution->position_source == PositionSource::none ? Standing{true, 'V', 'E', ""} : kFixed;
  switch (*solution->mode) {
    case Mode::A:
    case Mode::B:
    case Mode::C:
    case Mode::D:
      return kFixed;
    case Mode::E1:
      return kEstimated;
    case Mode::E0:
      break;
  }
  return kVoid;
}

/// Everything a sentence says, ready to be written.
struct Words {
  explicit Words(const Told& told) : t(told), standing(standing_of(told.solution)) {
    time = standing.told ? t.valid : t.now;
    if (!t.solution) return;
    const Solution& s = *t.solution;
    if (standing.told) position = s.position;
    heading = s.heading;
    if (!standing.told || !s.vel_north_mps || !s.vel_east_mps) return;
    speed_mps = std::hypot(*s.vel_north_mps, *s.vel_east_mps);
    if (*speed_mps >= kAtRest_mps) course = Angle::rad(std::atan2(*s.vel_east_mps, *s.vel_north_mps));
  }
  [[nodiscard]] std::optional<double> speed(double unit) const {
    return speed_mps ? std::optional(*speed_mps * unit) : std::nullopt;
  }

  const Told& t;
  Standing standing;
  Time time;
  std::optional<Geodetic> position;
  std::optional<Angle> heading, course;
  std::optional<double> speed_mps;
};

std::string_view letter(const char& c) { return {&c, 1}; }

void write_gga(const Words& w, Sentence& s) {
  s.time_of_day(w.time, kTimeDecimals).position(w.position, kMinuteDecimals).text(w.standing.quality);
  s.text("").text("").text("").text("M").text("").text("M").text("").text("");
}

void write_rmc(const Words& w, Sentence& s) {
  const Civil date = to_civil(rounded(w.time, kTimeDecimals));
  s.time_of_day(w.time, kTimeDecimals).text(letter(w.standing.status)).position(w.position, kMinuteDecimals);
  s.number(w.speed(kKnotsPerMps), kSpeedDecimals).heading(w.course, kAngleDecimals);
  s.text(fmt::format("{:02d}{:02d}{:02d}", date.day, date.month, date.year % 100));
  s.text("").text("").text(letter(w.standing.mode));
}

void write_gll(const Words& w, Sentence& s) {
  s.position(w.position, kMinuteDecimals).time_of_day(w.time, kTimeDecimals);
  s.text(letter(w.standing.status)).text(letter(w.standing.mode));
}

void write_vtg(const Words& w, Sentence& s) {
  s.heading(w.course, kAngleDecimals).text("T").text("").text("M");
  s.number(w.speed(kKnotsPerMps), kSpeedDecimals).text("N").number(w.speed(kKmhPerMps), kSpeedDecimals);
  s.text("K").text(w.speed_mps ? letter(w.standing.mode) : "N");
}

void write_hdt(const Words& w, Sentence& s) { s.heading(w.heading, kAngleDecimals).text("T"); }

void write_ths(const Words& w, Sentence& s) {
  s.heading(w.heading, kAngleDecimals).text(w.heading ? "A" : "V");
}

void write_zda(const Words& w, Sentence& s) {
  const Civil date = to_civil(rounded(w.t.now, kTimeDecimals));
  s.time_of_day(w.t.now, kTimeDecimals).whole(date.day, 2).whole(date.month, 2).whole(date.year, 4);
  s.text("00").text("00");
}

void write_dpt(const Words& w, Sentence& s) {
  s.number(w.t.below_transducer_m, 2);
  s.number(w.t.below_transducer_m ? w.t.transducer_depth_m : std::nullopt, 2);
}

void write_rot(const Words& w, Sentence& s) {
  const auto rate = w.t.rate_z_rps;
  s.number(rate ? std::optional(*rate * kDegPerRad * 60.0) : std::nullopt, 2).text(rate ? "A" : "V");
}

void write_gst(const Words& w, Sentence& s) {
  s.time_of_day(w.time, kTimeDecimals).text("");
  if (!w.position) return void(s.text("").text("").text("").text("").text("").text(""));
  const Solution& x = *w.t.solution;
  // Eigenvalues of the horizontal covariance; the greater one's axis, clockwise from north.
  const double mean = 0.5 * (x.var_north_m2 + x.var_east_m2), half = 0.5 * (x.var_north_m2 - x.var_east_m2);
  const double radius = std::hypot(half, x.cov_north_east_m2);
  const Angle axis = Angle::rad(0.5 * std::atan2(x.cov_north_east_m2, half));
  s.number(std::sqrt(mean + radius), kMetreDecimals)
      .number(std::sqrt(std::max(mean - radius, 0.0)), kMetreDecimals)
      .heading(Angle::rad(std::fmod(axis.rad() + kPi, kPi)), 1)
      .number(std::sqrt(x.var_north_m2), kMetreDecimals)
      .number(std::sqrt(x.var_east_m2), kMetreDecimals)
      .number(x.sd_down_m, kMetreDecimals);
}

struct Writer {
  std::string_view name;
  void (*write)(const Words&, Sentence&);
};
constexpr std::array<Writer, 10> kWriters{{{"GGA", write_gga},
                                           {"RMC", write_rmc},
                                           {"GLL", write_gll},
                                           {"VTG", write_vtg},
                                           {"HDT", write_hdt},
                                           {"THS", write_ths},
                                           {"ZDA", write_zda},
                                           {"DPT", write_dpt},
                                           {"ROT", write_rot},
                                           {"GST", write_gst}}};

}  // namespace

std::span<const std::string_view> navigation_sentences() {
  static const auto kNames = [] {
    std::array<std::string_view, kWriters.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kWriters[i].name;
    return names;
  }();
  return kNames;
}

bool write_sentence(std::string_view name, const Told& told, Telegrams& out) {
  for (const Writer& writer : kWriters) {
    if (writer.name != name) continue;
    Sentence sentence(out, kTalker, name);
    writer.write(Words(told), sentence);
    return true;
  }
  return false;
}

}  // namespace leadline::encode
