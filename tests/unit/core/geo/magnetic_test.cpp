#include "core/geo/magnetic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/files.h"

namespace leadline::geo {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::string built_folder() { return std::string(LEADLINE_BINARY_DIR) + "/magnetic"; }

const MagneticModel& model() {
  static const MagneticModel loaded = [] {
    auto result = MagneticModel::load(built_folder());
    if (!result) ADD_FAILURE() << result.error().line();
    return std::move(result).value();
  }();
  return loaded;
}

Time first_of(int year) { return *from_civil({year, 1, 1}); }

Time at_year(double year) {
  const int whole = static_cast<int>(std::floor(year));
  return first_of(whole) + duration((year - whole) * seconds(first_of(whole + 1) - first_of(whole)));
}

Geodetic at(double lat_deg, double lon_deg) {
  return {Angle::deg(lat_deg), Angle::deg(lon_deg).wrapped_pi()};
}

/// An empty folder of its own for one test, gone afterwards.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::path(testing::TempDir()) / ("leadline_" + name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

/// How many rows of NOAA's test values are met within 0.01 deg; every row that is not fails the test.
int rows_met(const std::string& file, std::size_t declination_column) {
  std::istringstream text(test::read_text(test::data_path("geomag_wmm/" + file)));
  int met = 0;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::vector<double> column;
    for (double value = 0.0; fields >> value;) column.push_back(value);
    if (column.size() < 18) {
      ADD_FAILURE() << file << ": " << line;
      continue;
    }
    const auto found =
        model().declination(at(column[2], column[3]), {column[1] * 1000.0}, at_year(column[0]));
    const double error_deg = (found.east - Angle::deg(column[declination_column])).wrapped_pi().deg();
    EXPECT_LE(std::abs(error_deg), 0.01) << file << ": " << line;
    EXPECT_FALSE(found.outside_validity) << line;
    if (std::abs(error_deg) <= 0.01) ++met;
  }
  return met;
}

TEST(Magnetic, MeetsNoaasTestValuesOf2025) { EXPECT_EQ(rows_met("WMM2025_TEST_VALUES.txt", 4), 100); }
TEST(Magnetic, MeetsNoaasTestValuesOf2020) { EXPECT_EQ(rows_met("WMM2020_TEST_VALUES.txt", 4), 100); }
TEST(Magnetic, MeetsTheShortTableOf2020) { EXPECT_EQ(rows_met("WMM2020testvalues.txt", 10), 15); }
TEST(Magnetic, MeetsTheShortTableOf2015v2) { EXPECT_EQ(rows_met("WMM2015v2testvalues.txt", 10), 12); }

// The first GGA inside winriver01.PD0: 4455.266147,N,06659.567103,W, antenna 9.3 m, geoid -28.1 m.
TEST(Magnetic, MaineInApril2017) {
  const Geodetic place = at(44.0 + 55.266147 / 60.0, -(66.0 + 59.567103 / 60.0));
  const auto found = model().declination(place, {9.3 - 28.1}, *from_civil({2017, 4, 5, 12, 9, 53}));
  EXPECT_NEAR(found.east.deg(), -16.76, 0.02);
  EXPECT_FALSE(found.outside_validity);
}

// The models disagree slightly where they meet: which one answered shows in the jump.
TEST(Magnetic, AnEpochsFirstInstantBelongsToTheNewModel) {
  const Geodetic place = at(80, -96);
  for (const int year : {2020, 2025}) {
    const auto declination = [&](Time t) { return model().declination(place, {0.0}, t).east.deg(); };
    const Duration ms(1'000'000);
    const double before = declination(first_of(year) - ms), first = declination(first_of(year));
    const double after = declination(first_of(year) + ms);
    EXPECT_GT(std::abs(first - before), 0.01) << year;
    EXPECT_LT(std::abs(after - first), 1e-6) << year;
  }
}

TEST(Magnetic, OutsideTheModelsYearsTheNearestAnswersAndSaysSo) {
  const Geodetic place = at(45, -67);
  const auto near = [&](Time inside, Time outside) {
    const auto a = model().declination(place, {0.0}, inside), b = model().declination(place, {0.0}, outside);
    EXPECT_FALSE(a.outside_validity);
    EXPECT_TRUE(b.outside_validity);
    EXPECT_NEAR(a.east.deg(), b.east.deg(), 1e-4);
  };
  const Duration minute = std::chrono::minutes(1);
  near(first_of(2015), first_of(2015) - minute);
  near(first_of(2030) - minute, first_of(2030));
  EXPECT_TRUE(model().declination(place, {0.0}, Time{}).outside_validity);
}

TEST(Magnetic, ManyThreadsMayAsk) {
  const double alone = model().declination(at(20, 30), {0.0}, at_year(2023.5)).east.rad();
  std::vector<std::thread> threads;
  std::vector<int> differing(4, 0);
  for (int& count : differing)
    threads.emplace_back([&count, alone] {
      for (int i = 0; i < 200; ++i)
        if (model().declination(at(20, 30), {0.0}, at_year(2023.5)).east.rad() != alone) ++count;
    });
  for (auto& t : threads) t.join();
  EXPECT_THAT(differing, testing::Each(0));
}

TEST(Magnetic, MovesAndStillAnswers) {
  auto loaded = MagneticModel::load(built_folder());
  ASSERT_TRUE(loaded.ok());
  MagneticModel first = std::move(loaded).value();
  const MagneticModel second = std::move(first);
  EXPECT_EQ(second.declination(at(1, 2), {0.0}, first_of(2026)).east.rad(),
            model().declination(at(1, 2), {0.0}, first_of(2026)).east.rad());
}

TEST(Magnetic, AnEmptyFolderIsRefusedByFileAndRemedy) {
  const Folder empty("magnetic_empty");
  const auto loaded = MagneticModel::load(empty.path());
  ASSERT_FALSE(loaded.ok());
  EXPECT_THAT(loaded.error().where, HasSubstr("wmm2015v2.wmm"));
  EXPECT_THAT(loaded.error().what, HasSubstr("missing"));
  EXPECT_THAT(loaded.error().remedy, HasSubstr("magnetic_models"));
}

TEST(Magnetic, AModelCutShortIsRefused) {
  const Folder folder("magnetic_cut");
  for (const auto& file : fs::directory_iterator(built_folder()))
    fs::copy(file.path(), fs::path(folder.path()) / file.path().filename());
  ASSERT_TRUE(MagneticModel::load(folder.path()).ok());
  fs::resize_file(fs::path(folder.path()) / "wmm2020.wmm.cof", 500);
  const auto loaded = MagneticModel::load(folder.path());
  ASSERT_FALSE(loaded.ok());
  EXPECT_THAT(loaded.error().line(), HasSubstr("wmm2020.wmm"));
}

TEST(DecimalYear, CountsTheFractionOfItsOwnYear) {
  EXPECT_DOUBLE_EQ(decimal_year(first_of(2025)), 2025.0);
  EXPECT_DOUBLE_EQ(decimal_year(*from_civil({2024, 7, 2})), 2024.5);
  EXPECT_DOUBLE_EQ(decimal_year(*from_civil({2025, 7, 2, 12, 0, 0})), 2025.5);
  EXPECT_DOUBLE_EQ(decimal_year(*from_civil({1969, 7, 2, 12, 0, 0})), 1969.5);
}

}  // namespace
}  // namespace leadline::geo
