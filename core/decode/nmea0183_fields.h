#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/types/angle.h"
#include "core/types/position.h"

namespace leadline::decode::nmea0183 {

// Why a sentence is refused, in the words that are counted.
inline constexpr std::string_view kReasonChecksum = "checksum";
inline constexpr std::string_view kReasonChecksumAbsent = "checksum absent";
inline constexpr std::string_view kReasonTorn = "torn";
inline constexpr std::string_view kReasonTooLong = "too long";
inline constexpr std::string_view kReasonTruncated = "truncated";
inline constexpr std::string_view kReasonRange = "range";
inline constexpr std::string_view kReasonFields = "fields";
inline constexpr std::string_view kReasonNotPrintable = "not printable";

/// The fields of one sentence, numbered from 1 after the address. An empty or missing field is an empty
/// optional; the first malformed or illegal one is kept in refusal(), so that a sentence is read in one go
/// and judged once.
class Fields {
 public:
  /// text: what follows the address and its comma, up to the '*'.
  explicit Fields(std::string_view text);
  Fields() : starts_{} {}  ///< no field at all

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::string_view all() const { return text_; }
  [[nodiscard]] std::string_view text(int n) const {
    if (n > count_) return {};
    const std::size_t begin = starts_[static_cast<std::size_t>(n - 1)],
                      next = starts_[static_cast<std::size_t>(n)];
    return {text_.data() + begin, next - begin - 1};
  }
  /// '\0' when empty; more than one character is malformed.
  [[nodiscard]] char letter(int n);
  [[nodiscard]] std::optional<double> number(int n);
  [[nodiscard]] std::optional<double> number(int n, double lowest, double highest);
  /// A non-negative integer.
  [[nodiscard]] std::optional<std::uint32_t> digits(int n, std::uint32_t highest);
  /// Degrees 0..360 as [0, 2 pi).
  [[nodiscard]] std::optional<Angle> heading(int n);
  [[nodiscard]] std::optional<Angle> angle(int n, double limit_deg);
  /// hhmmss[.s...] as ns since midnight; second 60 is a leap second and reaches 86400 s.
  [[nodiscard]] std::optional<std::int64_t> time_of_day(int n);
  /// ddmm.m, N or S, dddmm.m, E or W in four fields from n; no position when one is empty.
  [[nodiscard]] std::optional<Geodetic> position(int n);
  /// A magnitude and its direction letter in two fields from n: positive for `positive`.
  [[nodiscard]] std::optional<Angle> directed(int n, char positive, char negative);

  /// Notes that fewer fields than `least` are there.
  void require(int least) {
    if (count_ < least) refuse(kReasonFields);
  }
  void refuse(std::string_view reason) {
    if (refusal_.empty()) refusal_ = reason;
  }
  [[nodiscard]] std::string_view refusal() const { return refusal_; }

 private:
  [[nodiscard]] std::optional<double> degrees(int n, char positive, char negative, double limit);

  static constexpr int kMost = 32;  // further ones belong to newer revisions; XDR walks all() itself
  std::string_view text_;
  std::array<std::uint16_t, kMost + 1> starts_;  // [n-1] of field n; [count] one past the end
  int count_ = 0;
  std::string_view refusal_;
};

}  // namespace leadline::decode::nmea0183
