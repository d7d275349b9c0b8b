#pragma once

// Why a value of gpsd may differ from ours: one test a rule of tests/data/nmea_gpsd/differences.md.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/golden/gpsd_log.h"

namespace leadline::test::gpsd {

/// One value of gpsd's that is not equal to ours.
struct Difference {
  const Log& log;
  std::size_t told;  ///< an index into log.told
  std::optional<Value> ours;
};

/// Does the rule explain the difference?
using Rule = std::function<bool(const Difference&)>;
/// The rules by their name in the list.
const std::map<std::string, Rule>& rules();

/// One row of the list.
struct Row {
  std::string rule, what, why;
  bool outside = false;  ///< gpsd's value is no reading of a sentence: it leaves the count
  std::string log;       ///< an example: a line of a log, and its text
  int line = 0;
  std::string text;
};
std::vector<Row> read_rows(const std::string& path);

}  // namespace leadline::test::gpsd
