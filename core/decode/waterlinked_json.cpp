#include "core/decode/waterlinked_json.h"

#include <array>
#include <cmath>

#include "core/decode/json_reader.h"
#include "core/decode/line_search.h"
#include "core/decode/number.h"
#include "core/decode/waterlinked.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongest = std::size_t{64} << 10;
constexpr double kFarthest_m = 1000.0;

using Kind = JsonEvent::Kind;

/// What one line said, before its type is known: members may come in any order.
class Report {
 public:
  std::string_view type;
  WaterLinkedVelocity velocity;
  WaterLinkedAttitude attitude;

  /// False: a member that is known has another type or is there twice.
  bool take(const JsonEvent& e) {
    if (e.depth == 1) return take_member(e);
    if (list_ == "covariance") return take_covariance(e);
    if (list_ == "transducers") return take_transducer(e);
    return true;
  }

 private:
  bool take_member(const JsonEvent& e) {
    if (e.kind == Kind::object || e.kind == Kind::list) {
      list_ = e.kind == Kind::list ? e.key : std::string_view{};
      const bool known = list_ == "covariance" || list_ == "transducers";
      return !known || first(list_ == "covariance" ? 30 : 31);
    }
    if (e.kind == Kind::object_end || e.kind == Kind::list_end) return end_list();
    if (e.key == "type") {
      type = e.value;
      return e.kind == Kind::text && first(0);
    }
    if (e.key == "velocity_valid") {
      velocity.valid = e.value == "true";
      return e.kind == Kind::boolean && first(1);
    }
    if (e.key == "status") {
      const auto status = e.kind == Kind::number ? parse_digits(e.value) : std::nullopt;
      velocity.status = attitude.status = status.value_or(0);
      return status && first(2);
    }
    struct Number {
      std::string_view key;
      std::optional<double>& into;
    };
    const std::array<Number, 10> numbers{{{"vx", velocity.mps[0]},
                                          {"vy", velocity.mps[1]},
                                          {"vz", velocity.mps[2]},
                                          {"fom", velocity.fom_mps},
                                          {"altitude", velocity.altitude_m},
                                          {"time_of_validity", velocity.validity_us},
                                          {"time_of_transmission", velocity.transmission_us},
                                          {"ts", attitude.time_s},
                                          {"roll", attitude.roll_deg},
                                          {"pitch", attitude.pitch_deg}}};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (e.key != numbers[i].key) continue;
      if (e.kind == Kind::null) return first(3 + i);
      const auto value = number(e);
      numbers[i].into = value;
      return value && first(3 + i);
    }
    return true;
  }

  bool take_covariance(const JsonEvent& e) {
    if (e.kind == Kind::list || e.kind == Kind::list_end) return e.depth == 2;
    const auto value = number(e);
    if (!value || e.depth != 3 || elements_ == covariance_.size()) return false;
    covariance_[elements_++] = *value;
    return true;
  }

  bool take_transducer(const JsonEvent& e) {
    if (e.depth == 2) {
      if (e.kind == Kind::object) id_.reset(), distance_m_.reset(), beam_valid_ = false;
      if (e.kind == Kind::object_end) return keep_transducer();
      return e.kind == Kind::object;
    }
    if (e.depth != 3) return true;
    if (e.key == "id") return (id_ = number(e)).has_value();
    if (e.key == "distance") return (distance_m_ = number(e)).has_value();
    if (e.key == "beam_valid") {
      beam_valid_ = e.value == "true";
      return e.kind == Kind::boolean;
    }
    return true;
  }

  bool keep_transducer() {
    if (!id_ || *id_ < 0.0 || *id_ > 3.0 || *id_ != std::floor(*id_)) return false;
    const auto i = static_cast<std::size_t>(*id_);
    if ((beams_ & (1u << i)) != 0) return false;
    beams_ |= 1u << i;
    if (beam_valid_ && distance_m_ && *distance_m_ > 0.0) range_m_[i] = *distance_m_;
    return !(range_m_[i] > kFarthest_m);
  }

  bool end_list() {
    if (list_ == "covariance" && elements_ > 0) {
      if (elements_ != covariance_.size()) return false;
      velocity.covariance_m2ps2 = covariance_;
    }
    if (list_ == "transducers" && beams_ == 0xF) velocity.range_m = range_m_;
    list_ = {};
    return true;
  }

  static std::optional<double> number(const JsonEvent& e) {
    return e.kind == Kind::number ? parse_scientific(e.value) : std::nullopt;
  }
  bool first(std::size_t member) {
    const std::uint32_t bit = 1u << member;
    const bool is_first = (seen_ & bit) == 0;
    seen_ |= bit;
    return is_first;
  }

  std::string_view list_;  ///< the member of the object that is open
  std::uint32_t seen_ = 0;
  std::array<double, 9> covariance_{};
  std::size_t elements_ = 0;
  std::array<double, 4> range_m_{};
  std::uint32_t beams_ = 0;
  std::optional<double> id_, distance_m_;
  bool beam_valid_ = false;
};

class WaterLinkedJson final : public Decoder, private LineReader {
 public:
  WaterLinkedJson() : lines_(*this, kLongest) {}

  void feed(std::span<const std::uint8_t> bytes, std::optional<Arrival> arrival,
            DecoderOutput& out) override {
    arrival_ = arrival;
    lines_.feed(bytes, out);
  }
  void finish(DecoderOutput& out) override { lines_.finish(out); }

 private:
  Verdict read(const FoundLine& line, DecoderOutput& out) override {
    Verdict verdict;
    FrameReport& report = verdict.report;
    report.byte_class = ByteClass::refused;
    report.kind = "line";
    if (line.end == FoundLine::End::too_long) return report.reason = "too long", verdict;
    const std::size_t brace = line.text.find_first_not_of(" \t");
    if (line.text[brace] != '{') {
      report.byte_class = is_printable(line.text) ? ByteClass::unknown : ByteClass::skipped;
      report.kind = report.byte_class == ByteClass::unknown ? "text" : "";
      return verdict;
    }
    Report message;
    JsonReader reader(line.text);
    bool fits = true;
    for (JsonEvent event; reader.next(event);)
      if (event.depth > 0) fits = message.take(event) && fits;
    if (!reader.whole()) {
      report.reason = line.end == FoundLine::End::stream ? "truncated" : "syntax";
      return verdict;
    }
    judge(message, fits, out, report);
    return verdict;
  }

  void judge(Report& message, bool fits, DecoderOutput& out, FrameReport& report) {
    report.byte_class = ByteClass::decoded;
    if (message.type == "velocity" || message.type == "velocity_water") {
      message.velocity.water = message.type == "velocity_water";
      report.kind = message.velocity.water ? "velocity_water" : "velocity";
      report.reason = fits ? facts_.tell(report.kind, message.velocity, arrival_, out) : "fields";
    } else if (message.type == "position_local") {
      report.kind = "position_local";
      report.reason = fits ? facts_.tell(message.attitude, arrival_, out) : "fields";
    } else {
      const bool known = message.type == "response";
      report.kind = known ? "response" : "object";
      report.byte_class = known ? ByteClass::unused : ByteClass::unknown;
    }
    if (!report.reason.empty()) report.byte_class = ByteClass::refused;
  }

  WaterLinkedFacts facts_;
  LineSearch lines_;
  std::optional<Arrival> arrival_;
};

}  // namespace

std::unique_ptr<Decoder> make_waterlinked_json(const DecoderSettings&) {
  return std::make_unique<WaterLinkedJson>();
}

}  // namespace leadline::decode
