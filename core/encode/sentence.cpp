#include "core/encode/sentence.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace leadline::encode {
namespace {

std::int64_t power_of_ten(int n) {
  std::int64_t power = 1;
  for (; n > 0; --n) power *= 10;
  return power;
}

}  // namespace

Time rounded(Time t, int decimals) {
  const std::int64_t unit = power_of_ten(9 - decimals);
  const std::int64_t up = t.ns + unit / 2;
  return {up - ((up % unit) + unit) % unit};
}

Sentence::Sentence(Telegrams& out, std::string_view talker, std::string_view address)
    : out_(out), begin_(out.bytes.size()) {
  out_.bytes.append("$").append(talker).append(address);
}

Sentence::~Sentence() {
  std::uint8_t sum = 0;
  for (const char c : std::string_view(out_.bytes).substr(begin_ + 1))
    sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
  fmt::format_to(std::back_inserter(out_.bytes), "*{:02X}\r\n", sum);
  out_.end();
}

Sentence& Sentence::text(std::string_view text) {
  out_.bytes.append(",").append(text);
  return *this;
}

Sentence& Sentence::number(std::optional<double> value, int decimals) {
  if (!value) return text("");
  fmt::format_to(std::back_inserter(out_.bytes), ",{:.{}f}", *value, decimals);
  return *this;
}

Sentence& Sentence::whole(std::int64_t value, int width) {
  fmt::format_to(std::back_inserter(out_.bytes), ",{:0{}d}", value, width);
  return *this;
}

Sentence& Sentence::heading(std::optional<Angle> angle, int decimals) {
  if (!angle) return text("");
  const auto unit = static_cast<double>(power_of_ten(decimals));
  const double turned = std::round(angle->wrapped_2pi().deg() * unit);
  return number(turned >= 360.0 * unit ? 0.0 : turned / unit, decimals);
}

Sentence& Sentence::directed(std::optional<Angle> angle, int decimals, char positive, char negative) {
  if (!angle) return text("").text("");
  number(std::abs(angle->deg()), decimals);
  const char side = angle->deg() >= 0.0 ? positive : negative;
  return text({&side, 1});
}

void Sentence::arc(double deg, int degree_digits, int decimals, char positive, char negative) {
  const std::int64_t unit = power_of_ten(decimals);
  const std::int64_t minutes = std::llround(std::abs(deg) * 60.0 * static_cast<double>(unit));
  const std::int64_t whole_deg = minutes / (60 * unit), rest = minutes % (60 * unit);
  whole(whole_deg, degree_digits);
  fmt::format_to(std::back_inserter(out_.bytes), "{:02d}", rest / unit);
  if (decimals > 0) fmt::format_to(std::back_inserter(out_.bytes), ".{:0{}d}", rest % unit, decimals);
  const char side = deg >= 0.0 ? positive : negative;
  text({&side, 1});
}

Sentence& Sentence::position(const std::optional<Geodetic>& p, int decimals) {
  if (!p) return text("").text("").text("").text("");
  arc(p->lat.deg(), 2, decimals, 'N', 'S');
  arc(p->lon.deg(), 3, decimals, 'E', 'W');
  return *this;
}

Sentence& Sentence::time_of_day(Time t, int decimals) {
  const Time r = rounded(t, decimals);
  const Civil c = to_civil(r);
  fmt::format_to(std::back_inserter(out_.bytes), ",{:02d}{:02d}{:02d}", c.hour, c.minute, c.second);
  if (decimals > 0)
    fmt::format_to(std::back_inserter(out_.bytes), ".{:0{}d}", c.nanosecond / power_of_ten(9 - decimals),
                   decimals);
  return *this;
}

}  // namespace leadline::encode
