#include "core/decode/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/decode/number.h"
#include "core/decode/table_columns.h"

namespace leadline::decode {
namespace {

using Q = Quantity;

constexpr std::size_t kLineCeiling = std::size_t{64} << 10;
constexpr std::string_view kRow = "row";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_nan(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return text.size() == 3 && (text[0] | 0x20) == 'n' && (text[1] | 0x20) == 'a' && (text[2] | 0x20) == 'n';
}

/// What a field of a table may hold as a number; also ".5", which Fortran and MATLAB write.
std::optional<double> number(std::string_view text) {
  if (const auto plain = parse_number(text)) return plain;
  if (const auto scientific = parse_scientific(text)) return scientific;
  const bool sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  if (text.size() < (sign ? 3u : 2u) || text[sign ? 1 : 0] != '.' || !is_digit(text[sign ? 2 : 1]))
    return std::nullopt;
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (sign ? 1 : 0), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return text[0] == '-' ? -value : value;
}

/// The digits at the front of `text`, which loses them; empty when they are fewer than `least`.
std::optional<int> take_digits(std::string_view& text, std::size_t least, std::size_t most) {
  std::size_t count = 0;
  int value = 0;
  for (; count < most && count < text.size() && is_digit(text[count]); ++count)
    value = value * 10 + (text[count] - '0');
  if (count < least) return std::nullopt;
  text.remove_prefix(count);
  return value;
}

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

/// ".123456789" at the front as nanoseconds; further digits are dropped. -1 when a point has no digits.
std::int64_t take_fraction(std::string_view& text) {
  if (!take(text, '.')) return 0;
  std::int64_t ns = 0, unit = 100'000'000;
  if (text.empty() || !is_digit(text.front())) return -1;
  for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1), unit /= 10)
    ns += (text.front() - '0') * unit;
  return ns;
}

/// YYYY-MM-DD or YYYY/MM/DD.
bool read_date(std::string_view text, Civil& c) {
  const auto year = take_digits(text, 4, 4);
  if (!year || text.empty() || (text[0] != '-' && text[0] != '/')) return false;
  const char between = text[0];
  take(text, between);
  const auto month = take_digits(text, 1, 2);
  if (!month || !take(text, between)) return false;
  const auto day = take_digits(text, 1, 2);
  if (!day || !text.empty()) return false;
  c.year = *year, c.month = *month, c.day = *day;
  return true;
}

/// hh:mm:ss[.f][Z].
bool read_time_of_day(std::string_view text, Civil& c) {
  const auto hour = take_digits(text, 1, 2);
  if (!hour || !take(text, ':')) return false;
  const auto minute = take_digits(text, 2, 2);
  if (!minute || !take(text, ':')) return false;
  const auto second = take_digits(text, 2, 2);
  if (!second) return false;
  const std::int64_t ns = take_fraction(text);
  take(text, 'Z');
  if (ns < 0 || !text.empty()) return false;
  c.hour = *hour, c.minute = *minute, c.second = *second, c.nanosecond = static_cast<std::int32_t>(ns);
  return true;
}

enum class Cell : std::uint8_t { good, absent, fields, range };

/// Decimal seconds digit by digit: a double near 1.8e9 is exact to 0.2 us only.
Cell read_unix(std::string_view text, Time& time) {
  constexpr double kMost = 9.2e9;
  std::string_view rest = text;
  const bool negative = take(rest, '-');
  std::int64_t second = 0;
  std::size_t digits = 0;
  for (; digits < 10 && !rest.empty() && is_digit(rest.front()); ++digits, rest.remove_prefix(1))
    second = second * 10 + (rest.front() - '0');
  const std::int64_t ns = digits > 0 ? take_fraction(rest) : -1;
  if (ns >= 0 && rest.empty() && static_cast<double>(second) < kMost) {
    time.ns = second * 1'000'000'000 + ns;
    if (negative) time.ns = -time.ns;
    return Cell::good;
  }
  const auto value = number(text);
  if (!value) return Cell::fields;
  if (std::fabs(*value) >= kMost) return Cell::range;
  time = from_unix(*value);
  return Cell::good;
}

std::optional<bool> read_flag(std::string_view text) {
  std::array<char, 5> lower{};
  if (text.empty() || text.size() > lower.size()) return std::nullopt;
  std::transform(text.begin(), text.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const std::string_view word(lower.data(), text.size());
  if (word == "1" || word == "y" || word == "yes" || word == "t" || word == "true") return true;
  if (word == "0" || word == "n" || word == "no" || word == "f" || word == "false") return false;
  const auto value = number(text);
  if (value == 1.0) return true;
  if (value == 0.0) return false;
  return std::nullopt;
}

/// One row's values, by quantity.
class Values {
 public:
  void clear() { present_ = 0; }
  void set(Q q, double value) {
    values_[static_cast<std::size_t>(q)] = value;
    present_ |= bit(q);
  }
  [[nodiscard]] bool has(Q q) const { return (present_ & bit(q)) != 0; }
  [[nodiscard]] double operator[](Q q) const { return values_[static_cast<std::size_t>(q)]; }
  [[nodiscard]] std::optional<double> get(Q q) const {
    return has(q) ? std::optional((*this)[q]) : std::nullopt;
  }
  [[nodiscard]] std::optional<Angle> degrees(Q q) const {
    return has(q) ? std::optional(Angle::deg((*this)[q])) : std::nullopt;
  }
  /// The largest of those given.
  [[nodiscard]] std::optional<double> largest(std::initializer_list<Q> quantities) const {
    std::optional<double> most;
    for (const Q q : quantities)
      if (has(q)) most = std::max(most.value_or(0.0), (*this)[q]);
    return most;
  }

 private:
  static_assert(kQuantities <= 64);
  static std::uint64_t bit(Q q) { return std::uint64_t{1} << static_cast<unsigned>(q); }
  std::array<double, kQuantities> values_{};
  std::uint64_t present_ = 0;
};

class Table final : public Decoder {
 public:
  Table(const DecoderSettings& settings, const TableOptions& options, char separator,
        std::vector<TableColumn> columns)
      : magnetic_(settings.heading_magnetic),
        separator_(separator),
        lines_to_skip_(options.skip_lines),
        comment_(options.comment),
        columns_(std::move(columns)),
        fields_(columns_.size()) {
    const auto holds = [&](Q q) {
      return std::any_of(columns_.begin(), columns_.end(),
                         [&](const TableColumn& c) { return c.quantity == q; });
    };
    has_velocity_ = holds(Q::vel_x), has_vel_z_ = holds(Q::vel_z);
    increments_ =
        std::any_of(columns_.begin(), columns_.end(), [](const TableColumn& c) { return c.increment; });
  }

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival>, DecoderOutput& out) override {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    while (!text.empty()) {
      const std::size_t newline = text.find('\n');
      const std::string_view piece =
          text.substr(0, newline == std::string_view::npos ? newline : newline + 1);
      text.remove_prefix(piece.size());
      if (newline == std::string_view::npos)
        keep(piece);
      else if (length_ == 0 && piece.size() <= kLineCeiling)
        end_line(piece, out);
      else
        keep(piece), end_line(pending_, out);
    }
  }

  void finish(DecoderOutput& out) override {
    if (length_ > 0) end_line(pending_, out);
  }

 private:
  /// A line that is not yet whole; above the ceiling only its length.
  void keep(std::string_view piece) {
    length_ += piece.size();
    if (length_ <= kLineCeiling)
      pending_.append(piece);
    else
      pending_.clear();
  }

  void end_line(std::string_view line, DecoderOutput& out) {
    const std::uint64_t length = std::max<std::uint64_t>(length_, line.size());
    const bool skipped_header = lines_to_skip_ > 0;
    if (skipped_header) --lines_to_skip_;
    const bool at_start = offset_ == 0;
    if (length > kLineCeiling)
      report_long(skipped_header ? ByteClass::comment : ByteClass::refused, length, out);
    else if (skipped_header || is_comment(line, at_start))
      report(ByteClass::comment, {}, {}, length, out);
    else
      decode_row(line, at_start, out);
    pending_.clear();
    length_ = 0;
  }

  static std::string_view content(std::string_view line, bool at_start) {
    if (at_start && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);
    if (!line.empty() && line.back() == '\n') line.remove_suffix(1);
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  [[nodiscard]] bool is_comment(std::string_view line, bool at_start) const {
    const std::string_view text = trimmed(content(line, at_start));
    return text.empty() || (!comment_.empty() && text.substr(0, comment_.size()) == comment_);
  }

  void report(ByteClass byte_class, std::string_view kind, std::string_view reason, std::uint64_t length,
              DecoderOutput& out) {
    FrameReport frame;
    frame.byte_class = byte_class, frame.kind = kind, frame.reason = reason;
    frame.offset = offset_, frame.length = static_cast<std::uint32_t>(length);
    offset_ += length;
    out.frame(frame);
  }

  /// A report's length has 32 bits; a line need not keep to them.
  void report_long(ByteClass byte_class, std::uint64_t length, DecoderOutput& out) {
    constexpr std::uint64_t kPiece = std::uint64_t{1} << 30;
    const bool refused = byte_class == ByteClass::refused;
    report(byte_class, refused ? kRow : "", refused ? "too long" : "", std::min(length, kPiece), out);
    for (std::uint64_t rest = length - std::min(length, kPiece); rest > 0; rest -= std::min(rest, kPiece))
      report(refused ? ByteClass::skipped : byte_class, {}, {}, std::min(rest, kPiece), out);
  }

  void decode_row(std::string_view line, bool at_start, DecoderOutput& out) {
    const std::size_t found = split(content(line, at_start));
    if (found != columns_.size()) {
      const bool torn = found < columns_.size() && line.back() != '\n';
      return report(ByteClass::refused, kRow, torn ? "truncated" : "fields", line.size(), out);
    }
    bool valid = true;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].quantity != Q::valid || fields_[i].empty() || is_nan(fields_[i])) continue;
      const auto flag = read_flag(fields_[i]);
      if (!flag) return report(ByteClass::refused, kRow, "fields", line.size(), out);
      valid = *flag;
    }
    const Cell cell = read_values();
    if (valid && cell != Cell::good)
      return report(ByteClass::refused, kRow, cell == Cell::range ? "range" : "fields", line.size(), out);
    if (valid)
      say_facts(out);
    else if (has_velocity_)
      out.fact(time_, DvlVelocity{});
    report(ByteClass::decoded, kRow, {}, line.size(), out);
  }

  /// Fills fields_; the number of fields, of which those beyond the columns are not kept.
  std::size_t split(std::string_view text) {
    std::size_t count = 0;
    const auto put = [&](std::string_view field) {
      if (count < fields_.size()) fields_[count] = trimmed(field);
      ++count;
    };
    if (separator_ == ' ') {
      for (std::size_t at = text.find_first_not_of(" \t"); at < text.size();
           at = text.find_first_not_of(" \t", at)) {
        const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
        put(text.substr(at, end - at));
        at = end;
      }
      return count;
    }
    for (;;) {
      const std::size_t end = text.find(separator_);
      if (end == std::string_view::npos) break;
      put(text.substr(0, end));
      text.remove_prefix(end + 1);
    }
    if (count != columns_.size() || !trimmed(text).empty())
      put(text);  // a separator at the line's end is no field
    return count;
  }

  /// All of the row's numbers and its time; the first thing wrong with them.
  Cell read_values() {
    values_.clear();
    time_.reset();
    Cell worst = Cell::good;
    Civil civil;
    bool date = false, time_of_day = false;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const TableColumn& column = columns_[i];
      const std::string_view field = fields_[i];
      if (column.quantity == Q::skip || column.quantity == Q::valid || field.empty() || is_nan(field))
        continue;
      Cell cell = Cell::good;
      if (column.quantity == Q::unix_s) {
        Time time;
        cell = read_unix(field, time);
        if (cell == Cell::good) time_ = time;
      } else if (column.quantity == Q::date) {
        date = read_date(field, civil);
        cell = date ? Cell::good : Cell::fields;
      } else if (column.quantity == Q::time) {
        time_of_day = read_time_of_day(field, civil);
        cell = time_of_day ? Cell::good : Cell::fields;
      } else {
        cell = read_number(column, field);
      }
      if (worst == Cell::good) worst = cell;
    }
    if (date && time_of_day) {
      time_ = from_civil(civil);
      if (!time_ && worst == Cell::good) worst = Cell::range;
    }
    return worst;
  }

  Cell read_number(const TableColumn& column, std::string_view field) {
    const auto value = number(field);
    if (!value) return Cell::fields;
    if (*value < column.min || *value > column.max) return Cell::range;
    values_.set(column.quantity, *value * column.scale);
    return Cell::good;
  }

  void say_facts(DecoderOutput& out) const {
    const Values& v = values_;
    const auto say = [&](const Message& message) { out.fact(time_, message); };
    if (time_) say(ClockReading{"row", time_->ns, std::nullopt});
    if (v.has(Q::roll) && v.has(Q::pitch))
      say(Attitude{Angle::deg(v[Q::roll]), Angle::deg(v[Q::pitch]), std::nullopt, v.degrees(Q::sd_roll),
                   v.degrees(Q::sd_pitch)});
    if (v.has(Q::heading)) say_heading(Q::heading, magnetic_, out);
    if (v.has(Q::magnetic_heading)) say_heading(Q::magnetic_heading, true, out);
    if (v.has(Q::rate_z)) say(Rates{v[Q::rate_z]});
    if (v.has(Q::gyro_x) && v.has(Q::gyro_y) && v.has(Q::gyro_z) && v.has(Q::accel_x) && v.has(Q::accel_y) &&
        v.has(Q::accel_z))
      say(ImuSample{increments_,
                    {v[Q::gyro_x], v[Q::gyro_y], v[Q::gyro_z]},
                    {v[Q::accel_x], v[Q::accel_y], v[Q::accel_z]}});
    if (v.has(Q::vel_x) && v.has(Q::vel_y) && (v.has(Q::vel_z) || !has_vel_z_)) say_velocity(out);
    if (v.has(Q::vel_north) && v.has(Q::vel_east)) say_course(out);
    if (v.has(Q::depth)) say(DepthMeasured{Depth{v[Q::depth]}, v.get(Q::sd_depth)});
    if (v.has(Q::altitude)) say(AltitudeAboveBottom{v[Q::altitude]});
    if (v.has(Q::lat) && v.has(Q::lon)) say_fix(out);
  }

  void say_heading(Q quantity, bool magnetic, DecoderOutput& out) const {
    Heading heading;
    heading.heading = Angle::deg(values_[quantity]).wrapped_2pi();
    heading.reference = magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north;
    heading.sd = values_.degrees(Q::sd_heading);
    out.fact(time_, heading);
  }

  void say_velocity(DecoderOutput& out) const {
    DvlVelocity velocity;
    velocity.x_mps = values_[Q::vel_x], velocity.y_mps = values_[Q::vel_y];
    if (has_vel_z_) velocity.z_mps = values_[Q::vel_z];
    velocity.valid = true;
    velocity.sd_mps = values_.largest({Q::sd_vel, Q::sd_vel_x, Q::sd_vel_y, Q::sd_vel_z});
    out.fact(time_, velocity);
  }

  void say_course(DecoderOutput& out) const {
    const double north = values_[Q::vel_north], east = values_[Q::vel_east];
    Course course;
    course.speed_mps = std::hypot(north, east);
    if (course.speed_mps > 0.0) course.course = Angle::rad(std::atan2(east, north)).wrapped_2pi();
    course.vel_down_mps = values_.get(Q::vel_down);
    course.sd_mps = values_.largest({Q::sd_vel, Q::sd_vel_north, Q::sd_vel_east, Q::sd_vel_down});
    out.fact(time_, course);
  }

  void say_fix(DecoderOutput& out) const {
    const double lon_deg = values_[Q::lon];
    GnssFix fix;
    fix.position = {Angle::deg(values_[Q::lat]), Angle::deg(lon_deg >= 180.0 ? lon_deg - 360.0 : lon_deg)};
    if (values_.has(Q::ellipsoid_height)) fix.height = EllipsoidHeight{values_[Q::ellipsoid_height]};
    fix.sd_north_m = values_.get(Q::sd_north);
    fix.sd_east_m = values_.get(Q::sd_east);
    fix.sd_down_m = values_.get(Q::sd_down);
    out.fact(time_, fix);
  }

  bool magnetic_;
  char separator_;
  std::int64_t lines_to_skip_;
  std::string comment_;
  std::vector<TableColumn> columns_;
  std::vector<std::string_view> fields_;
  bool has_velocity_ = false, has_vel_z_ = false, increments_ = false;

  std::string pending_;
  std::uint64_t length_ = 0;  // of the line so far, while it comes in pieces
  std::uint64_t offset_ = 0;  // of the next report
  Values values_;
  std::optional<Time> time_;
};

}  // namespace

std::span<const Key<TableOptions>> table_keys() {
  using O = TableOptions;
  static const std::array<Key<O>, 4> keys{{
      {"separator", &O::separator,
       "between the columns: one character; a blank takes any run of blanks and tabs"},
      {"skip_lines", &O::skip_lines, "header lines at the top", 0, 1e9},
      {"comment", &O::comment, "lines that begin with it are comment; empty: none"},
      {"columns", &O::columns, "what each column holds, e.g. unix_s, heading_deg, depth_m; - skips one"},
  }};
  return keys;
}

Result<std::unique_ptr<Decoder>> make_table(const DecoderSettings& settings, const TableOptions& options) {
  const std::string& written = options.separator;
  const char separator = written == "\\t" ? '\t' : written.size() == 1 ? written[0] : '\0';
  if (separator == '\0' || separator == '\n' || separator == '\r')
    return Error{"\"" + written + "\" is no separator", "separator",
                 "use one character, for example \",\", \";\" or \" \""};
  if (options.skip_lines < 0) return Error{"is negative", "skip_lines", "use 0 or more"};
  auto columns = table_columns(options.columns);
  if (!columns) return columns.error();
  return std::unique_ptr<Decoder>(
      std::make_unique<Table>(settings, options, separator, std::move(columns).value()));
}

}  // namespace leadline::decode
