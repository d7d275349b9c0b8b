#include "core/geo/magnetic.h"

#include <GeographicLib/MagneticModel.hpp>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

namespace leadline::geo {
namespace {

struct Epoch {
  double first_year;
  const char* name;
};
constexpr std::array<Epoch, 3> kEpochs = {{{2015.0, "wmm2015v2"}, {2020.0, "wmm2020"}, {2025.0, "wmm2025"}}};
constexpr double kEnd_year = 2030.0;

constexpr const char* kRemedy =
    "build the target magnetic_models or reinstall Leadline: the folder must hold wmm2015v2, wmm2020 and "
    "wmm2025, "
    "each as .wmm and .wmm.cof";

using Model = GeographicLib::MagneticModel;

}  // namespace

struct MagneticModel::Models {
  std::array<std::unique_ptr<const Model>, kEpochs.size()> of_epoch;
};

MagneticModel::MagneticModel(std::unique_ptr<const Models> models) : models_(std::move(models)) {}
MagneticModel::MagneticModel(MagneticModel&&) noexcept = default;
MagneticModel& MagneticModel::operator=(MagneticModel&&) noexcept = default;
MagneticModel::~MagneticModel() = default;

double decimal_year(Time time) {
  using namespace std::chrono;
  const sys_time<nanoseconds> instant{nanoseconds(time.ns)};
  const year y = year_month_day(floor<days>(instant)).year();
  // In whole seconds: the first of January 1677 is outside the range of nanoseconds.
  const auto first = sys_seconds(sys_days(y / January / 1)),
             next = sys_seconds(sys_days((y + years(1)) / January / 1));
  const sys_seconds second = floor<std::chrono::seconds>(instant);
  const double elapsed_s =
      static_cast<double>((second - first).count()) + leadline::seconds(instant - second);
  return static_cast<int>(y) + elapsed_s / static_cast<double>((next - first).count());
}

Result<MagneticModel> MagneticModel::load(const std::string& folder) {
  auto models = std::make_unique<Models>();
  for (std::size_t i = 0; i < kEpochs.size(); ++i) {
    const std::string stem = (std::filesystem::path(folder) / kEpochs[i].name).string();
    for (const char* ending : {".wmm", ".wmm.cof"}) {
      std::error_code ignored;
      if (!std::filesystem::is_regular_file(stem + ending, ignored))
        return Error{"file of the world magnetic model is missing", stem + ending, kRemedy};
    }
    try {
      models->of_epoch[i] = std::make_unique<const Model>(kEpochs[i].name, folder);
    } catch (const std::exception& e) {
      return Error{std::string("world magnetic model cannot be read: ") + e.what(), stem + ".wmm", kRemedy};
    }
  }
  return MagneticModel(std::move(models));
}

MagneticModel::Declination MagneticModel::declination(Geodetic position, EllipsoidHeight height,
                                                      Time time) const {
  const double year = decimal_year(time);
  std::size_t i = 0;
  while (i + 1 < kEpochs.size() && year >= kEpochs[i + 1].first_year) ++i;
  double east_nt = 0.0, north_nt = 0.0, up_nt = 0.0;
  (*models_->of_epoch[i])(year, position.lat.deg(), position.lon.deg(), height.m, east_nt, north_nt, up_nt);
  return {Angle::rad(std::atan2(east_nt, north_nt)), year < kEpochs.front().first_year || year >= kEnd_year};
}

}  // namespace leadline::geo
