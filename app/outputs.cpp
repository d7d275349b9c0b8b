#include "app/outputs.h"

#include <algorithm>
#include <cmath>

#include "core/encode/navigation_sentences.h"
#include "core/encode/udpbc.h"
#include "core/links/link_sender.h"

namespace leadline::app {
namespace {

constexpr Duration kLeastStale = std::chrono::seconds(1), kMostStale = std::chrono::seconds(5);

bool is_udpbc(const OutputOptions& output) { return output.format == "iec61162-450"; }

/// The newest of a kind of fact, while it is fresh.
template <class T>
class Latest {
 public:
  void set(const T& value, SourceId source, Arrival at) {
    if (heard_ && source == source_) interval_ = at - *heard_;
    if (source != source_) interval_ = kLeastStale;
    value_ = value;
    source_ = source;
    heard_ = at;
  }
  /// The first of several sources is preferred while it is alive.
  void prefer(const T& value, SourceId source, Arrival at) {
    if (source <= source_ || !fresh(at)) set(value, source, at);
  }
  [[nodiscard]] bool fresh(Arrival now) const {
    return heard_ && now - *heard_ <= std::clamp(3 * interval_, kLeastStale, kMostStale);
  }
  [[nodiscard]] const T* at(Arrival now) const { return fresh(now) ? &value_ : nullptr; }

 private:
  T value_{};
  SourceId source_ = kNoSource;
  std::optional<Arrival> heard_;
  Duration interval_ = kLeastStale;
};

}  // namespace

std::vector<OutputProblem> check_output(const OutputOptions& output, const Configuration& configuration) {
  std::vector<OutputProblem> problems;
  const auto link = links::parse_link(output.link);
  if (output.link.empty())
    problems.push_back({"link", "is required: where it goes, as \"udp://127.0.0.1:10110\""});
  else if (!link)
    problems.push_back({"link", link.error().line()});
  else if (is_udpbc(output) && link.value().kind != links::LinkKind::udp)
    problems.push_back({"link", "iec61162-450 goes over udp:// only"});
  if (output.sentences.empty())
    problems.push_back({"sentences", "names none; name those to be sent, as [\"GGA\", \"HDT\"]"});
  if (is_udpbc(output) && !encode::good_sfi(output.sfi))
    problems.push_back({"sfi", "must be two capital letters and four digits, as \"IN0001\""});
  if (!output.destination.empty() && !encode::good_sfi(output.destination))
    problems.push_back({"destination", "must be two capital letters and four digits, as \"NV0001\""});
  const auto& followed = configuration.navigation.navigation.body;
  const auto of_ship = [](const SourceConfiguration& s) { return s.options.body == "ship"; };
  if (output.body != followed && output.body == "vehicle")
    problems.push_back({"body", "nobody follows the vehicle: navigation.body is \"" + followed + "\""});
  if (output.body != followed && output.body == "ship" &&
      std::none_of(configuration.sources.begin(), configuration.sources.end(), of_ship))
    problems.push_back({"body", "no [[source]] of this file is on the ship"});
  return problems;
}

struct Outputs::Output {
  struct Solved {
    Solution solution;
    Time valid;
  };
  struct Water {
    double below_transducer_m = 0.0, lever_down_m = 0.0;
  };

  Output(links::IoLoop& loop, const OutputOptions& o, const links::LinkAddress& address, bool own_track)
      : options(o),
        body(o.body == "ship" ? Body::ship : Body::vehicle),
        ship_track(own_track),
        period(duration(1.0 / o.rate_hz)),
        udpbc(o.sfi, o.destination),
        sender(loop, address) {}

  void hear(const Envelope& envelope, const std::vector<SourceInfo>& sources) {
    const Arrival at = envelope.arrival;
    if (const auto* s = std::get_if<Solution>(&envelope.message)) {
      if ((s->engine == kShipTrack) == ship_track && (ship_track || s->engine == 0))
        solved.set({*s, envelope.valid}, 0, at);
      return;
    }
    if (envelope.source >= sources.size() || sources[envelope.source].body != body) return;
    const double lever_down_m = sources[envelope.source].lever.z;
    if (const auto* r = std::get_if<Rates>(&envelope.message))
      rate_z_rps.prefer(r->rate_z_rps, envelope.source, at);
    else if (const auto* a = std::get_if<AltitudeAboveBottom>(&envelope.message))
      water.prefer({a->above_bottom_m, lever_down_m}, envelope.source, at);
    else if (const auto* b = std::get_if<BottomDepth>(&envelope.message);
             b && b->below == BottomDepth::Below::transducer)
      water.prefer({b->depth_m, lever_down_m}, envelope.source, at);
  }

  [[nodiscard]] encode::Told told(Arrival now) const {
    encode::Told t;
    t.now = t.valid = now.host();
    if (const auto* s = solved.at(now)) {
      t.solution = s->solution;
      t.valid = s->valid;
    }
    if (const auto* w = water.at(now)) {
      t.below_transducer_m = w->below_transducer_m;
      if (t.solution && t.solution->depth) t.transducer_depth_m = t.solution->depth->m + w->lever_down_m;
    }
    if (const auto* r = rate_z_rps.at(now)) t.rate_z_rps = *r;
    return t;
  }

  void tick(Arrival now) {
    if (due && now < *due) return;
    // From when it was due, not from when it was sent: 3 Hz stays 3 Hz on ticks of 100 ms.
    due = due && now - *due < period ? *due + period : now + period;
    lines.clear();
    datagrams.clear();
    const encode::Told state = told(now);
    for (const auto& name : options.sentences) encode::write_sentence(name, state, lines);
    if (is_udpbc(options)) udpbc.wrap(lines, datagrams);
    const encode::Telegrams& frames = is_udpbc(options) ? datagrams : lines;
    for (std::size_t i = 0; i < frames.size(); ++i)
      (void)sender.send({reinterpret_cast<const std::uint8_t*>(frames[i].data()), frames[i].size()});
  }

  OutputOptions options;
  Body body;
  bool ship_track;
  Duration period;
  encode::Udpbc udpbc;
  links::LinkSender sender;
  encode::Telegrams lines, datagrams;
  std::optional<Arrival> due;
  Latest<Solved> solved;
  Latest<Water> water;
  Latest<double> rate_z_rps;
};

Outputs::Outputs() = default;
Outputs::~Outputs() = default;

Result<std::unique_ptr<Outputs>> Outputs::open(links::IoLoop& loop, const Configuration& configuration) {
  auto outputs = std::unique_ptr<Outputs>(new Outputs);
  outputs->sources_ = source_infos(configuration);
  for (const auto& options : configuration.outputs) {
    const auto problems = check_output(options, configuration);
    if (!problems.empty())
      return Error{"[[output]] " + options.name + ": " + problems[0].key + " " + problems[0].text,
                   configuration.file, ""};
    outputs->outputs_.push_back(
        std::make_unique<Output>(loop, options, links::parse_link(options.link).value(),
                                 options.body != configuration.navigation.navigation.body));
  }
  return outputs;
}

void Outputs::take(const Envelope& envelope) {
  if (const auto* tick = std::get_if<Tick>(&envelope.message)) {
    for (auto& output : outputs_) output->tick(tick->at);
    return;
  }
  for (auto& output : outputs_) output->hear(envelope, sources_);
}

std::vector<OutputStatus> Outputs::status() const {
  std::vector<OutputStatus> all;
  for (const auto& output : outputs_) {
    const auto status = output->sender.status();
    const std::string link = output->sender.address().text();
    all.push_back({output->options.name.empty() ? link : output->options.name, link, status.open,
                   status.sent_frames, status.dropped_frames, status.last_error});
  }
  return all;
}

bool Outputs::finish(std::chrono::milliseconds at_most) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  bool all = true;
  for (auto& output : outputs_) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    all = output->sender.finish(std::max(left, std::chrono::milliseconds(0))) && all;
  }
  return all;
}

}  // namespace leadline::app
