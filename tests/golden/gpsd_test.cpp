// The second opinion: every value that gpsd's own decoder made of its 86 real logs, beside ours. Differences
// are explained by the rules of tests/data/nmea_gpsd/differences.md, or the test fails.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "tests/golden/gpsd_rules.h"
#include "tests/support/files.h"

namespace leadline::test::gpsd {
namespace {

std::vector<std::string> logs_with_reference() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data_path("nmea_gpsd")))
    if (entry.path().extension() == ".chk") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

struct Count {
  int told = 0, equal = 0, by_rule = 0, no_reading = 0;
  [[nodiscard]] double percent() const { return 100.0 * equal / std::max(told - no_reading, 1); }
};

struct Outcome {
  std::map<Field, Count> counts;
  std::map<std::string, int> used;  ///< by rule
  std::set<std::string> explained;  ///< "rule log:line"
  std::vector<std::string> unexplained;
  int logs = 0, unfound = 0;
};

std::string place(const Log& log, const Told& told) {
  return log.name + ":" + std::to_string(log.telegrams[told.at].line);
}

void explain(const Difference& d, const std::vector<Row>& rows, Outcome& outcome) {
  const Told& told = d.log.told[d.told];
  for (const Row& row : rows) {
    if (!rules().at(row.rule)(d)) continue;
    Count& count = outcome.counts[told.field];
    ++(row.outside ? count.no_reading : count.by_rule);
    ++outcome.used[row.rule];
    outcome.explained.insert(row.rule + " " + place(d.log, told));
    return;
  }
  outcome.unexplained.push_back(
      name_of(told.field) + " " + place(d.log, told) + ": gpsd " + std::to_string(told.value.a) + " " +
      std::to_string(told.value.b) + ", ours " +
      (d.ours ? std::to_string(d.ours->a) + " " + std::to_string(d.ours->b) : "none") + ", after " +
      d.log.telegrams[told.at].text);
}

Outcome compare(const std::vector<Row>& rows) {
  Outcome outcome;
  for (const std::string& name : logs_with_reference()) {
    const Log log = read_log(name);
    ++outcome.logs;
    outcome.unfound += log.unfound;
    for (std::size_t i = 0; i < log.told.size(); ++i) {
      const Told& told = log.told[i];
      Count& count = outcome.counts[told.field];
      ++count.told;
      const auto value = ours(log, told);
      if (value && equal(told.field, *value, told.value))
        ++count.equal;
      else
        explain({log, i, value}, rows, outcome);
    }
  }
  return outcome;
}

class Gpsd : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rows_ = read_rows(data_path("nmea_gpsd/differences.md"));
    for (const Row& row : rows_) ASSERT_EQ(rules().count(row.rule), 1u) << row.rule;
    outcome_ = compare(rows_);
  }
  static std::vector<Row> rows_;
  static Outcome outcome_;
};
std::vector<Row> Gpsd::rows_;
Outcome Gpsd::outcome_;

TEST_F(Gpsd, EveryDifferenceHasARule) {
  EXPECT_EQ(outcome_.logs, 86);
  EXPECT_EQ(outcome_.unfound, 0) << "sentences of the references that the logs do not hold";
  for (const std::string& difference : outcome_.unexplained) ADD_FAILURE() << difference;

  std::printf("%-14s %6s %10s %7s %7s %10s\n", "", "told", "no reading", "equal", "rules",
              "equal of compared");
  for (const Field field : kFields) {
    const Count& c = outcome_.counts[field];
    std::printf("%-14s %6d %10d %7d %7d %9.2f %%\n", name_of(field).c_str(), c.told, c.no_reading, c.equal,
                c.by_rule, c.percent());
  }
  for (const auto& [rule, times] : outcome_.used) std::printf("%-20s %4d times\n", rule.c_str(), times);
}

TEST_F(Gpsd, PositionsTimesSpeedsTracksAndHeadingsAreEqualInNinetyEightOfAHundred) {
  EXPECT_EQ(outcome_.counts[Field::position].told, 1793);
  for (const Field field : {Field::position, Field::time, Field::speed, Field::track, Field::mag_heading})
    EXPECT_GE(outcome_.counts[field].percent(), 98.0) << name_of(field);
  EXPECT_GE(outcome_.counts[Field::height].percent(), 97.0);
  EXPECT_EQ(outcome_.counts[Field::position].no_reading, 0) << "every position of gpsd's counts";
  EXPECT_EQ(outcome_.counts[Field::time].by_rule, 0);
}

TEST_F(Gpsd, EveryRuleIsUsedAndItsExampleIsOneOfItsCases) {
  EXPECT_LE(rows_.size(), 25u);
  EXPECT_EQ(rows_.size(), rules().size());
  for (const Row& row : rows_) {
    EXPECT_FALSE(row.why.empty()) << row.rule;
    EXPECT_GT(outcome_.used[row.rule], 0) << row.rule;
    const std::string where = row.log + ":" + std::to_string(row.line);
    EXPECT_EQ(outcome_.explained.count(row.rule + " " + where), 1u) << row.rule << " at " << where;
    std::istringstream lines(read_text(data_path("nmea_gpsd/" + row.log)));
    std::string text;
    for (int i = 0; i < row.line; ++i) std::getline(lines, text);
    EXPECT_EQ(text.substr(0, row.text.size()), row.text) << where;
  }
}

TEST(GpsdRules, ExplainNoValueThatIsMerelyOff) {
  for (const char* name : {"ac12.log", "bn-9015.log", "garmin-10x.log", "pypilot.log", "ublox-lea-4s.log"}) {
    Log log = read_log(name);
    for (std::size_t i = 0; i < log.told.size(); ++i) {
      const Told right = log.told[i];
      log.told[i].value.a += right.field == Field::position ? 1e-5 : 0.5;
      for (const auto& [rule, holds] : rules())
        EXPECT_FALSE(holds({log, i, ours(log, right)}))
            << rule << " " << name_of(right.field) << " " << place(log, right);
      log.told[i] = right;
    }
  }
}

}  // namespace
}  // namespace leadline::test::gpsd
