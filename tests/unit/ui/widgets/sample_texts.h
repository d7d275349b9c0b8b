#pragma once

// One moment of one dive, in words, for every test that draws.

#include "ui/models/bar_text.h"
#include "ui/models/table_rows.h"
#include "ui/models/tile_text.h"
#include "ui/models/timeline_data.h"

namespace leadline::ui::test {

inline TileText tile(const char* label, const char* value, const char* unit, const char* sigma,
                     const char* source, const char* age) {
  TileText text;
  text.label = label;
  text.value = value;
  text.unit = unit;
  text.sigma = sigma;
  text.source = source;
  text.age = age;
  return text;
}

inline TileText depth() { return tile("Depth", "1512.4", "m", "0.3", "press", "0.2 s"); }

inline OwnDataText vehicle(bool replay = false) {
  OwnDataText own;
  own.subject = "MDV-1";
  own.fact = "engine fusion   10 Hz";
  own.position = tile("Position", "36°54.60000′ N", "", "0.6 m", "USBL + DVL", "0.1 s");
  own.position->value_2 = "129°54.30000′ E";
  own.heading = tile("Heading", "071.9", "° T", "0.3°", "AHRS", "0.1 s");
  own.speed = tile("Speed over ground", "1.42", "m/s", "0.01", "DVL", "0.2 s");
  own.speed->note = "COG 074.8° T";
  own.depth = depth();
  own.altitude = tile("Altitude", "18.6", "m", "0.1", "DVL", "0.2 s");
  own.roll = tile("Roll", "+0.8", "°", "0.1", "", "0.1 s");
  own.pitch = tile("Pitch", "−1.6", "°", "0.1", "", "0.1 s");
  own.current = tile("Current to 212° T", "0.11", "m/s", "0.02", "", "5 s");
  own.rose = RoseAngles{71.9, 74.8, 212.0, 71.8, ValueState::live, replay, false};
  for (auto* figure : {&own.position, &own.heading, &own.speed, &own.depth, &own.altitude, &own.roll,
                       &own.pitch, &own.current})
    (*figure)->replay = replay;
  return own;
}

inline OwnDataText ship(bool replay = false) {
  OwnDataText own;
  own.subject = "HAEYANG 7";
  own.fact = "GNSS   1 Hz";
  own.position = tile("Position", "36°54.46120′ N", "", "0.9 m", "GNSS", "0.2 s");
  own.position->value_2 = "129°54.52310′ E";
  own.heading = tile("Heading", "308.4", "° T", "0.2°", "Gyro", "0.1 s");
  own.speed = tile("Speed over ground", "0.3", "kn", "0.1", "GNSS", "0.2 s");
  own.speed->note = "COG 301.2° T";
  own.rose = RoseAngles{308.4, 301.2, {}, {}, ValueState::live, replay, false};
  for (auto* figure : {&own.position, &own.heading, &own.speed}) (*figure)->replay = replay;
  return own;
}

inline SourcesText sources(bool replay = false) {
  SourcesText text;
  text.fact = replay ? "6 of 6 recorded" : "6 of 6 live";
  text.rows = {
      {"DVL", "5.0 Hz", "0.2 s", "41 ms", "4 beams", ValueState::live, {}, "frames 48 120, refused 2"},
      {"USBL", "0.125 Hz", "3 s", "1.1 s", "3 of 8 refused", ValueState::live, Alarm::Priority::warning,
       "residuals 35 to 38 m"},
      {"AHRS", "50 Hz", "0.1 s", "12 ms", "σ 0.3°", ValueState::live, {}, ""},
      {"Pressure", "4.0 Hz", "0.2 s", "18 ms", "σ 0.3 m", ValueState::ageing, {}, ""},
      {"GNSS ship", "1.0 Hz", "14 s", "64 ms", "σ 0.9 m", ValueState::stale, {}, ""},
      {"Gyro ship", "", "2:41", "", "σ 0.2°", ValueState::lost, {}, ""}};
  return text;
}

inline RangesText ranges() {
  RangesText text;
  text.rows = {{"Ship", "MDV-1", "420 m", "308.0° T", "1570 m", ValueState::live, "σ 1.1 m"},
               {"MDV-1", "T1", "214 m", "112.0° T", "215 m", ValueState::live, ""},
               {"Ship", "T1", "223 m", "323.4° T", "1545 m", ValueState::stale, ""}};
  return text;
}

inline TopBarText top_bar(Operation operation) {
  TopBarText text;
  text.operation = operation;
  const bool replay = operation == Operation::replay;
  text.dive = "Dive 07 · survey box 3";
  text.file = replay ? "dive-07.leadline · read only" : "dive-07.leadline · 2 h 41 min";
  text.mode = Mode::B;
  text.mode_words = "USBL and DVL";
  text.mode_since = "since 13:02:40 Z";
  text.outputs = replay ? "Outputs off" : "Recording 1.84 GB";
  text.outputs_2 = replay ? "nothing is sent" : "96 h left · all rows acknowledged";
  text.date = "2026-09-14";
  text.time = "14:02:37 Z";
  return text;
}

inline AlertBarText alert_bar(Alarm::Priority priority = Alarm::Priority::warning, bool replay = false) {
  AlertBarText text;
  text.alert = AlertBarText::Alert{
      priority, AlertMark::unacknowledged, "USBL: 3 of the last 8 fixes refused",
      "residuals 35 to 38 m, gate 15.2 m",
      replay ? "14:02:26 Z · 11 s · as it was, silent in replay" : "14:02:26 Z · 11 s · unacknowledged"};
  text.counts = {0, 1, 2};
  text.replay = replay;
  return text;
}

inline StatusBarText status_bar(bool replay = false) {
  return {"36°54.48270′ N  129°54.16108′ E",
          "MDV-1",
          "299 m  223.6° T",
          "1561 m",
          "bathymetry",
          "WGS 84 · UTM 52N",
          "Measure",
          "M",
          replay ? "closed in replay" : "6 of 6",
          "60 Hz  newest wins",
          "watch 2"};
}

inline Time at(int hour, int minute, int second = 0) {
  return *from_civil({2026, 9, 14, hour, minute, second, 200'000'000});
}

inline TimelineData timeline() {
  TimelineData data;
  data.run = {at(11, 21), at(15, 31)};
  data.availability = {{{at(11, 21), at(11, 48)}, Mode::C}, {{at(11, 48), at(12, 14)}, Mode::D},
                       {{at(12, 14), at(12, 57)}, Mode::B}, {{at(12, 57), at(13, 2)}, Mode::E1},
                       {{at(13, 2), at(13, 32)}, Mode::B},  {{at(13, 32), at(13, 34)}, Mode::E0},
                       {{at(13, 34), at(14, 17)}, Mode::B}, {{at(14, 17), at(14, 22)}, Mode::D},
                       {{at(14, 22), at(15, 2)}, Mode::B},  {{at(15, 2), at(15, 26)}, Mode::D},
                       {{at(15, 26), at(15, 31)}, Mode::C}};
  data.alerts = {{at(11, 48), Alarm::Priority::caution, "GNSS only"},
                 {at(12, 57), Alarm::Priority::warning, "USBL lost"},
                 {at(13, 32), Alarm::Priority::alarm, "no position"},
                 {at(14, 2, 26), Alarm::Priority::warning, "3 of 8 fixes refused"},
                 {at(14, 17), Alarm::Priority::caution, "bottom lock lost"}};
  data.events = {
      {at(11, 50), "dive start"}, {at(12, 14), "bottom lock"}, {at(13, 41), "C2"}, {at(15, 2), "ascent"}};
  data.gaps = {{{at(13, 32), at(13, 34)}, "2 min of USBL"}};
  for (int minute = 0; minute <= 250; ++minute) {
    const Time t = data.run.from + std::chrono::minutes(minute);
    const bool off = at(11, 48) <= t && t < at(12, 14);
    const double growing = at(12, 57) <= t && t < at(13, 2) ? (minute - 96) * 0.9 : 0.0;
    data.sigma.push_back({t, (off ? 3.0 : 0.6) + growing});
  }
  return data;
}

}  // namespace leadline::ui::test
