#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/document.h"
#include "core/flow/source_options.h"

namespace leadline::config::test {

/// One key of each type.
struct Every {
  double rate_hz = 1.0;
  std::optional<double> declination_deg;
  bool enabled = true;
  std::int64_t skip_lines = 0;
  std::string name;
  std::string mode = "utc";
  std::string date;
  std::vector<std::string> columns;
  std::vector<std::string> sentences;

  [[nodiscard]] std::vector<BoundKey> keys() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {{"rate_hz", &rate_hz, "how often", 0, 100, {}},
            {"declination_deg", &declination_deg, "east positive", -180, 180, {}},
            {"enabled", &enabled, "", -inf, inf, {}},
            {"skip_lines", &skip_lines, "lines", 0, inf, {}},
            {"name", &name, "its name", -inf, inf, {}},
            {"mode", &mode, "the clock", -inf, inf, {"utc", "gps"}},
            {"date", &date, "YYYY-MM-DD", -inf, inf, {}},
            {"columns", &columns, "what they hold", -inf, inf, {}},
            {"sentences", &sentences, "what is sent", -inf, inf, {"GGA", "HDT"}}};
  }
  bool operator==(const Every&) const = default;
};

inline std::vector<std::string> lines_of(const Document& document) {
  std::vector<std::string> lines;
  for (const Problem& p : document.problems()) lines.push_back(p.line_text());
  return lines;
}

/// Everything a reader of a whole configuration does.
inline void read_all(Document& document) {
  Every every;
  document.root().read(every.keys());
  Table navigation = document.root().table("navigation");
  navigation.read(every.keys());
  navigation.table("aiding").read(every.keys());
  for (Table& table : document.root().tables("source")) {
    SourceOptions source;
    MountOptions mount;
    table.read(bind(source_keys(), source));
    table.require("name");
    table.table("mount").read(bind(mount_keys(), mount));
  }
  document.finish();
}

}  // namespace leadline::config::test
