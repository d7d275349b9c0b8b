// One minute of a simulated run on the surface and the seven states an independent reference made of it
// (tests/data/reference-navigation/SOURCE.md).

#include <gtest/gtest.h>

#include <cmath>

#include "core/nav/filters/heading_bias_filter.h"
#include "core/types/angle.h"
#include "tests/support/csv_columns.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;
using F = HeadingBiasFilter;

TEST(Ekf7Of60Seconds, AllSevenStatesFollowTheReference) {
  const test::CsvColumns table(test::data_path("reference-navigation/ekf7_60s.csv"));
  ASSERT_EQ(table.rows().size(), 600U);
  const auto tcm = table.column("tcm_rad"), rate = table.column("rate_rad_s");
  const auto dvl_new = table.column("dvl_new"), u = table.column("dvl_u"), v = table.column("dvl_v");
  const auto gps_x = table.column("gps_X"), gps_y = table.column("gps_Y");
  const auto gate = table.column("speed_gate"), sigma_b = table.column("ekf_sigma_b");
  const char* names[] = {"ekf_X", "ekf_Y", "ekf_psi", "ekf_u", "ekf_v", "ekf_r", "ekf_b"};
  std::size_t states[F::kStates];
  for (int i = 0; i < F::kStates; ++i) states[i] = table.column(names[i]);

  F filter({.position_gate = false});  // the reference has the speed gate alone
  const auto& first = table.rows().front();
  filter.start({first[gps_x], first[gps_y]}, first[tcm], 0.0);
  double worst = 0.0, worst_sigma = 0.0;
  int other_gates = 0;
  for (const auto& row : table.rows()) {
    ASSERT_TRUE(filter.predict(0.1));
    filter.heading(row[tcm], 0.5 * kRadPerDeg);
    filter.rate(row[rate], 0.05 * kRadPerDeg);
    if (row[dvl_new] > 0.5)
      filter.velocity({row[u], row[v]}, {F::velocity_sd_mps(row[u]), F::velocity_sd_mps(row[v])});
    const bool used = filter.position(Vector2d(row[gps_x], row[gps_y]) - filter.antenna(), 0.3);
    other_gates += used != (row[gate] > 0.5);
    for (int i = 0; i < F::kStates; ++i) worst = std::max(worst, std::abs(filter.x()(i) - row[states[i]]));
    worst_sigma = std::max(worst_sigma, std::abs(std::sqrt(filter.P()(F::b, F::b)) - row[sigma_b]));
  }
  std::printf("largest difference %.2e of a state, %.2e of b's sigma\n", worst, worst_sigma);
  EXPECT_EQ(other_gates, 0);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(worst_sigma, 1e-9);
}

}  // namespace
}  // namespace leadline::nav
