#include "tests/golden/gpsd_log.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/decode/nmea0183.h"
#include "tests/support/files.h"

namespace leadline::test::gpsd {
namespace {

constexpr Duration kSameEpoch = std::chrono::milliseconds(10);  // UTC to the hundredth and to the thousandth

std::string without_terminator(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

class Telegrams final : public DecoderOutput {
 public:
  explicit Telegrams(const std::string& bytes) : bytes_(bytes) {}
  void fact(std::optional<Time> device_time, const Message& message) override {
    if (device_time) epoch_ = device_time;
    open_.facts.push_back({device_time, message});
  }
  void frame(const FrameReport& report) override {
    open_.text = without_terminator(bytes_.substr(report.offset, report.length));
    open_.kind = report.kind;
    open_.line = line_;
    open_.epoch = epoch_;
    line_ += static_cast<int>(
        std::count(bytes_.begin() + static_cast<std::ptrdiff_t>(report.offset),
                   bytes_.begin() + static_cast<std::ptrdiff_t>(report.offset) + report.length, '\n'));
    found.push_back(std::move(open_));
    open_ = {};
  }
  std::vector<Telegram> found;

 private:
  const std::string& bytes_;
  Telegram open_;
  std::optional<Time> epoch_;
  int line_ = 1;
};

std::vector<Telegram> decode(const std::string& bytes) {
  DecoderSettings settings;
  settings.checksum_required = false;
  const auto decoder = decode::make_nmea0183(settings);
  Telegrams telegrams(bytes);
  decoder->feed(as_bytes(bytes), {}, telegrams);
  decoder->finish(telegrams);
  return std::move(telegrams.found);
}

std::optional<Value> value_of(const Decoded::Fact& fact, Field field) {
  const auto degrees = [](const std::optional<Angle>& angle) {
    return angle ? std::optional(Value{angle->deg()}) : std::nullopt;
  };
  if (field == Field::time || field == Field::time_no_fix)
    return fact.device_time ? std::optional(Value{to_unix(*fact.device_time)}) : std::nullopt;
  if (const auto* fix = std::get_if<GnssFix>(&fact.message)) {
    if (field == Field::position) return Value{fix->position.lat.deg(), fix->position.lon.deg()};
    if (field == Field::height && fix->height) return Value{fix->height->m};
  } else if (const auto* course = std::get_if<Course>(&fact.message)) {
    if (field == Field::speed) return Value{course->speed_mps};
    if (field == Field::track) return degrees(course->course);
  } else if (const auto* heading = std::get_if<Heading>(&fact.message)) {
    const Field told =
        heading->reference == HeadingReference::true_north ? Field::heading : Field::mag_heading;
    if (field == told) return Value{heading->heading.deg()};
  } else if (const auto* attitude = std::get_if<Attitude>(&fact.message)) {
    if (field == Field::roll) return Value{attitude->roll.deg()};
    if (field == Field::pitch) return Value{attitude->pitch.deg()};
  }
  return std::nullopt;
}

std::optional<Value> value_of(const Telegram& telegram, Field field) {
  for (const auto& fact : telegram.facts)
    if (const auto value = value_of(fact, field)) return value;
  return std::nullopt;
}

void add_told(const nlohmann::json& report, std::size_t at, Log& log) {
  const auto number = [&](const char* key) { return report.at(key).get<double>(); };
  std::optional<Time> time;
  if (report.contains("time")) time = parse_iso8601(report.at("time").get<std::string>());
  const auto add = [&](Field field, Value value) { log.told.push_back({field, value, at, time}); };
  const auto add_number = [&](Field field, const char* key) {
    if (report.contains(key)) add(field, {number(key)});
  };
  const std::string what = report.at("class");
  if (what == "TPV") {
    const bool fix = report.contains("lat");
    if (fix) add(Field::position, {number("lat"), number("lon")});
    if (time) add(fix ? Field::time : Field::time_no_fix, {to_unix(*time)});
    add_number(Field::height, "altHAE");
    add_number(Field::speed, "speed");
    add_number(Field::track, "track");
  } else if (what == "ATT") {
    add_number(Field::heading, "heading");
    add_number(Field::mag_heading, "mheading");
    add_number(Field::roll, "roll");
    add_number(Field::pitch, "pitch");
  }
}

}  // namespace

std::string name_of(Field field) {
  constexpr std::array names = {"position", "time",    "time, no fix", "height", "speed",
                                "track",    "heading", "mag. heading", "roll",   "pitch"};
  return names.at(static_cast<std::size_t>(field));
}

bool equal(Field field, const Value& x, const Value& y) {
  constexpr double kHalfDigit = 0.000501, kPosition_deg = 1e-7 + 1e-12;
  const double off = std::abs(x.a - y.a);
  switch (field) {
    case Field::position:
      return off <= kPosition_deg && std::abs(x.b - y.b) <= kPosition_deg;
    case Field::track:
    case Field::heading:
    case Field::mag_heading:
      return std::min(off, 360.0 - off) <= kHalfDigit;
    default:
      return off <= kHalfDigit;
  }
}

Log read_log(const std::string& name) {
  const std::string path = data_path("nmea_gpsd/" + name);
  Log log;
  log.name = name;
  log.telegrams = decode(read_text(path));
  std::istringstream reference(read_text(path + ".chk"));
  std::size_t next = 0;
  for (std::string line; std::getline(reference, line);) {
    line = without_terminator(line);
    if (line.empty()) continue;
    if (line[0] == '{') {
      if (next > 0) add_told(nlohmann::json::parse(line), next - 1, log);
      continue;
    }
    std::size_t found = next;
    while (found < log.telegrams.size() && log.telegrams[found].text != line) ++found;
    if (found < log.telegrams.size())
      next = found + 1;
    else
      ++log.unfound;
  }
  return log;
}

std::optional<Value> ours(const Log& log, const Told& told) {
  const bool timed = told.time && told.field != Field::time && told.field != Field::time_no_fix;
  for (const bool of_this_time : {true, false}) {
    if (of_this_time && !timed) continue;
    const auto take = [&](std::size_t i) -> std::optional<Value> {
      const Telegram& t = log.telegrams[i];
      if (of_this_time && (!t.epoch || std::chrono::abs(*t.epoch - *told.time) > kSameEpoch))
        return std::nullopt;
      return value_of(t, told.field);
    };
    for (std::size_t i = told.at + 1; i-- > 0;)
      if (const auto value = take(i)) return value;
    for (std::size_t i = told.at + 1; i < log.telegrams.size(); ++i)
      if (const auto value = take(i)) return value;
  }
  return std::nullopt;
}

std::optional<Value> alone(const Telegram& telegram, Field field) {
  for (const Telegram& t : decode(telegram.text + "\r\n"))
    if (const auto value = value_of(t, field)) return value;
  return std::nullopt;
}

std::string field_of(const std::string& sentence, std::size_t n) {
  std::istringstream in(sentence.substr(0, sentence.find('*')));
  std::string field;
  for (std::size_t i = 0; i <= n; ++i)
    if (!std::getline(in, field, ',')) return {};
  return field;
}

}  // namespace leadline::test::gpsd
