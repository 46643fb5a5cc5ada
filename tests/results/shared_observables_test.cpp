// Tests of the observables on rows that several ranks share: every rank gets
// the bits that one process gets from all rows. The ranks are threads.
// Tolerance: none.
#include "results/observables/area_estimate.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/ranks/thread_ranks.hpp"

namespace asperity::results {
namespace {

/// Patches of contact that cross the border and the rows between ranks.
struct Maps {
  std::vector<double> pressure, gap, displacement;
};

Maps patchy(const Grid& grid) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Maps maps;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double height = std::sin(0.4 * ix) * std::cos(0.3 * iy + 0.5) +
                            0.1 * unit(random) - 0.4;
      maps.pressure.push_back(height > 0.0 ? std::sqrt(height) : 0.0);
      maps.gap.push_back(height > 0.0 ? 0.0 : 1e-3 * std::pow(-height, 1.5));
      maps.displacement.push_back(height + unit(random));
    }
  return maps;
}

struct Numbers {
  double mean, area, perimeter, corrected, elastic, contact, fit, variance,
      moment, centre_x, centre_y;

  bool operator==(const Numbers&) const = default;
};

Observed corrected(const Grid& grid, const Maps& maps, double modulus,
                   const SharedRows* rows) {
  return rows != nullptr
             ? corrected_area_fraction(*rows, maps.pressure, maps.gap, modulus,
                                       halfspace_area_coefficients)
             : corrected_area_fraction(grid, maps.pressure, maps.gap, modulus,
                                       halfspace_area_coefficients);
}

Numbers observed(const Grid& grid, const Maps& maps, const SharedRows* rows) {
  const std::vector<double>& p = maps.pressure;
  const PressureFit fit = fit_pressure_distribution(p, {}, rows);
  const PressureCentre centre = pressure_centre(grid, p, {}, rows);
  return {weighted_mean(maps.displacement, {}, rows),
          counted_area_fraction(p, {}, rows),
          contact_perimeter(grid, p, Border::periodic, rows),
          corrected(grid, maps, 2.0, rows).value,
          elastic_energy(p, maps.displacement, {}, rows),
          contact_energy(p, 0.7, {}, rows),
          fit.area_fraction,
          fit.variance,
          pressure_fit_by_moment(p, {}, rows).area_fraction,
          centre.x,
          centre.y};
}

Maps rows_in(const SharedRows& rows, const Maps& maps) {
  const auto part = [&](const std::vector<double>& field) {
    const auto first = field.begin() + static_cast<std::ptrdiff_t>(
                                           rows.grid().index(0, rows.first()));
    return std::vector<double>(
        first, first + static_cast<std::ptrdiff_t>(rows.size()));
  };
  return {part(maps.pressure), part(maps.gap), part(maps.displacement)};
}

TEST(SharedObservables, HaveTheBitsOfOneProcess) {
  const Grid grid{50, 37, 3.0, 2.0};
  const Maps maps = patchy(grid);
  const Numbers alone = observed(grid, maps, nullptr);
  EXPECT_GT(alone.perimeter, 0.0);
  EXPECT_TRUE(std::isfinite(alone.fit) && std::isfinite(alone.corrected));
  for (const std::vector<int>& bounds :
       {std::vector{0, 37}, {0, 10, 37}, {0, 1, 20, 37}, {0, 8, 9, 30, 37}})
    tests::on_thread_ranks(
        static_cast<int>(bounds.size()) - 1, [&](RankGroup& ranks) {
          const SharedRows rows(grid, ranks, bounds);
          EXPECT_TRUE(observed(grid, rows_in(rows, maps), &rows) == alone)
              << bounds.size() - 1 << " ranks";
        });
}

// A number that cannot be computed on one rank fails on all, with the message
// of one process.
TEST(SharedObservables, FailOnAllRanks) {
  const Grid grid{20, 16, 1.0, 1.0};
  Maps maps = patchy(grid);
  maps.pressure.assign(grid.size(), 0.0);
  maps.pressure[grid.index(3, 12)] = 1.0;
  maps.gap[grid.index(4, 12)] = std::numeric_limits<double>::quiet_NaN();
  const auto message_of = [&](const Maps& own, const SharedRows* rows) {
    try {
      static_cast<void>(corrected(grid, own, 1.0, rows));
    } catch (const std::domain_error& error) {
      return std::string(error.what());
    }
    return std::string("no failure");
  };
  const std::string alone = message_of(maps, nullptr);
  EXPECT_NE(alone.find("gap_outside"), std::string::npos) << alone;
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    const SharedRows rows(grid, ranks, {0, 4, 10, 16});
    EXPECT_EQ(message_of(rows_in(rows, maps), &rows), alone);
  });
}

} // namespace
} // namespace asperity::results
