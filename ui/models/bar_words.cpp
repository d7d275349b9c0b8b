// The bars above the chart.

#include <algorithm>

#include "ui/models/own_data.h"

namespace leadline::ui {

const char* words_of(Mode mode) {
  switch (mode) {
    case Mode::A:
      return "GNSS and DVL";
    case Mode::B:
      return "USBL and DVL";
    case Mode::C:
      return "GNSS, no bottom lock";
    case Mode::D:
      return "USBL, no bottom lock";
    case Mode::E1:
      return "DVL only, σ grows";
    case Mode::E0:
      return "nothing, hold last";
  }
  return "";
}

TopBarText top_bar_text(const Snapshot& s) {
  TopBarText text;
  if (s.sources.empty() && s.file.empty()) {  // nothing is open: neither live nor recorded
    text.operation = Operation::none;
    text.dive = "no session";
    text.time = kUnknown;
    return text;
  }
  text.operation = s.replay ? Operation::replay : Operation::live;
  text.dive = s.dive;
  text.file = s.replay ? s.file + " · read only" : s.file;
  text.mode = s.availability.mode;
  if (text.mode) {
    text.mode_words = words_of(*text.mode);
    if (s.availability.since != Time{}) text.mode_since = "since " + time_text(s.availability.since);
  }
  if (s.replay) text.outputs = "Outputs off", text.outputs_2 = "nothing is sent";
  text.date = date_text(s.now);
  text.time = time_text(s.now);
  return text;
}

AlertBarText alert_bar_text(const Snapshot& s) {
  AlertBarText text;
  text.replay = s.replay;
  const AlertState* shown = nullptr;
  for (const AlertState& alert : s.alerts) {
    ++text.counts[alert.priority >= Alarm::Priority::alarm     ? 0
                  : alert.priority == Alarm::Priority::warning ? 1
                                                               : 2];
    if (shown == nullptr || alert.priority > shown->priority) shown = &alert;
  }
  if (shown == nullptr) return text;
  auto& alert = text.alert.emplace();
  alert.priority = shown->priority;
  // What is wrong and its cause stand in one sentence, a semicolon between.
  const auto cut = shown->text.find("; ");
  alert.text = shown->text.substr(0, cut);
  alert.cause = cut == std::string::npos ? shown->source : shown->text.substr(cut + 2);
  alert.state = time_text(shown->raised) + " · " + age_text(s.now - shown->raised) +
                (s.replay ? " · as it was, silent in replay" : " · unacknowledged");
  return text;
}

}  // namespace leadline::ui
