#include "ui/models/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace leadline::ui {
namespace {

constexpr const char* kMinus = "\u2212";

bool is_zero(const std::string& digits) { return digits.find_first_of("123456789") == std::string::npos; }

std::string digits(double value, int decimals) { return fmt::format("{:.{}f}", std::abs(value), decimals); }

}  // namespace

std::string number_text(double value, int decimals) {
  if (!std::isfinite(value)) return kUnknown;
  std::string text = digits(value, decimals);
  return value < 0.0 && !is_zero(text) ? kMinus + text : text;
}

std::string signed_text(double value, int decimals) {
  if (!std::isfinite(value)) return kUnknown;
  const std::string text = digits(value, decimals);
  return (value < 0.0 && !is_zero(text) ? kMinus : "+") + text;
}

int decimals_for(std::optional<double> sigma, int at_most) {
  if (!sigma || !(*sigma > 0.0) || !std::isfinite(*sigma)) return at_most;
  return std::clamp(static_cast<int>(std::floor(-std::log10(*sigma / 10.0) + 1e-9)), 0, at_most);
}

std::string sigma_text(double sigma) {
  if (!std::isfinite(sigma) || sigma < 0.0) return kUnknown;
  if (sigma < 0.0005) return sigma > 0.0 ? "<0.001" : "0";
  return number_text(sigma, sigma < 0.0095 ? 3 : sigma < 0.095 ? 2 : sigma < 9.95 ? 1 : 0);
}

std::string heading_text(Angle heading, int decimals) {
  if (!std::isfinite(heading.rad())) return kUnknown;
  const double step = std::pow(10.0, decimals);
  auto units = std::llround(heading.wrapped_2pi().deg() * step);
  if (units >= std::llround(360.0 * step)) units = 0;
  return fmt::format("{:0{}.{}f}", static_cast<double>(units) / step, decimals > 0 ? decimals + 4 : 3,
                     decimals);
}

std::string distance_text(double metres) {
  if (!std::isfinite(metres)) return kUnknown;
  return std::abs(metres) < 9'999.5 ? number_text(metres, 0) + " m" : number_text(metres / 1000.0, 1) + " km";
}

std::string age_text(Duration age) {
  const std::int64_t tenths = std::max<std::int64_t>(age.count(), 0) / 100'000'000;
  const std::int64_t s = tenths / 10;
  if (s < 10) return fmt::format("{}.{} s", s, tenths % 10);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string time_text(Time time, int decimals) {
  const Civil c = to_civil(time);
  std::string text = fmt::format("{:02}:{:02}:{:02}", c.hour, c.minute, c.second);
  if (decimals > 0) text += "." + fmt::format("{:09}", c.nanosecond).substr(0, decimals);
  return text + " Z";
}

std::string date_text(Time time) {
  const Civil c = to_civil(time);
  return fmt::format("{:04}-{:02}-{:02}", c.year, c.month, c.day);
}

std::string rate_text(double hz) {
  if (!std::isfinite(hz)) return kUnknown;
  return number_text(hz, hz < 0.9995 && hz > 0.0 ? 3 : hz < 9.95 ? 1 : 0) + " Hz";
}

std::string latency_text(double latency_s) {
  if (!std::isfinite(latency_s)) return kUnknown;
  const double size_s = std::abs(latency_s);
  if (size_s < 0.9995) return number_text(latency_s * 1e3, 0) + " ms";
  if (size_s < 59.95) return number_text(latency_s, 1) + " s";
  if (size_s > 1e9) return (latency_s < 0.0 ? kMinus : "") + std::string("years");
  return (latency_s < 0.0 ? kMinus : "") + age_text(Duration(static_cast<std::int64_t>(size_s * 1e9)));
}

std::string scale_text(double denominator) {
  if (!std::isfinite(denominator) || denominator < 0.0) return std::string("1 : ") + kUnknown;
  const double power =
      std::pow(10.0, std::max(std::floor(std::log10(std::max(denominator, 1.0))) - 1.0, 0.0));
  std::string text = fmt::format("{:.0f}", std::min(std::round(denominator / power) * power, 1e12));
  for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), " ");
  return "1 : " + text;
}

}  // namespace leadline::ui
