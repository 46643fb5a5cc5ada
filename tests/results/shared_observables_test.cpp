// Tests of the observables on rows that several ranks share: every rank gets
// the bits that one process gets from all rows, on any number of threads. The
// ranks are threads. Tolerance: none, where no other is given.
#include "results/observables/area_estimate.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace asperity::results::shared_observables_test {

/// Patches of contact that cross the border, the rows between ranks and the
/// ends of chunks.
struct Maps {
  std::vector<double> pressure, gap, displacement;
};

Maps patchy(const Grid& grid) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Maps maps;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double height =
          std::sin(0.4 * ix + 1.0) * std::cos(0.3 * iy + 0.5) +
          0.1 * unit(random) - 0.4;
      maps.pressure.push_back(height > 0.0 ? std::sqrt(height) : 0.0);
      maps.gap.push_back(height > 0.0 ? 0.0 : 1e-3 * std::pow(-height, 1.5));
      maps.displacement.push_back(height + unit(random));
    }
  return maps;
}

struct Numbers {
  double mean, area, perimeter, corrected, free_perimeter, free_corrected,
      elastic, contact, fit, variance, moment, centre_x, centre_y;

  bool operator==(const Numbers&) const = default;
};

Observed corrected(const Grid& grid, const Maps& maps, double modulus,
                   const Workers& workers, Border border = Border::periodic) {
  return corrected_area_fraction(grid, maps.pressure, maps.gap,
                                 {modulus, halfspace_area_coefficients, border},
                                 workers);
}

Numbers observed(const Grid& grid, const Maps& maps, const Workers& workers) {
  const std::vector<double>& p = maps.pressure;
  const PressureFit fit = fit_pressure_distribution(p, {}, workers);
  const PressureCentre centre = pressure_centre(grid, p, {}, workers);
  return {
      weighted_mean(maps.displacement, {}, workers),
      counted_area_fraction(ContactNodes::under(p), {}, workers),
      contact_perimeter(grid, ContactNodes::under(p), Border::periodic,
                        workers),
      corrected(grid, maps, 2.0, workers).value,
      contact_perimeter(grid, ContactNodes::under(p), Border::free, workers),
      corrected(grid, maps, 2.0, workers, Border::free).value,
      elastic_energy(p, maps.displacement, {}, workers),
      contact_energy(p, 0.7, {}, workers),
      fit.area_fraction,
      fit.variance,
      pressure_fit_by_moment(p, {}, workers).area_fraction,
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

void expect_bits_of_one_process(const Grid& grid,
                                const std::vector<std::vector<int>>& shares) {
  const Maps maps = patchy(grid);
  const Numbers alone = observed(grid, maps, {1, grid});
  EXPECT_GT(alone.perimeter, 0.0);
  EXPECT_GT(alone.free_perimeter, alone.perimeter);
  EXPECT_NE(alone.free_corrected, alone.corrected);
  EXPECT_TRUE(std::isfinite(alone.fit) && std::isfinite(alone.corrected));
  EXPECT_TRUE(observed(grid, maps, {3, grid}) == alone) << "3 threads";
  for (const std::vector<int>& bounds : shares)
    tests::on_thread_ranks(
        static_cast<int>(bounds.size()) - 1, [&](RankGroup& ranks) {
          const SharedRows rows(grid, ranks, bounds);
          EXPECT_TRUE(observed(grid, rows_in(rows, maps), {2, rows}) == alone)
              << bounds.size() - 1 << " ranks";
        });
}

// The first grid has five groups of one chunk; the units
// (ranks/node_chunks.hpp) have 64, 8 and 64 rows.
TEST(SharedObservables, HaveTheBitsOfOneProcess) {
  expect_bits_of_one_process(
      {128, 300, 3.0, 7.0},
      {{0, 300}, {0, 192, 300}, {0, 64, 128, 300}, {0, 64, 128, 256, 300}});
  expect_bits_of_one_process({1000, 41, 7.0, 0.3},
                             {{0, 41}, {0, 24, 41}, {0, 8, 24, 32, 41}});
  expect_bits_of_one_process({301, 193, 3.0, 2.0},
                             {{0, 64, 193}, {0, 64, 128, 192, 193}});
}

// The sums in chunks differ from those in the order of the nodes by roundoff:
// 100 eps of sums of positive numbers, of which a chunk adds 8192.
// Displacements in contact are positive, because their heights are.
TEST(SharedObservables, AreTheSumsOfAllNodes) {
  const Grid grid{128, 300, 3.0, 7.0};
  const Maps maps = patchy(grid);
  const Numbers chunked = observed(grid, maps, 2);
  std::size_t in_contact = 0, edges_x = 0, edges_y = 0;
  double square = 0.0, moment_x = 0.0, moment_y = 0.0, load = 0.0;
  double work = 0.0, displacement = 0.0, largest = 0.0;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const auto p = [&](int x, int y) {
        return maps.pressure[grid.index(x % grid.points_x, y % grid.points_y)];
      };
      const double here = p(ix, iy);
      const double moved = maps.displacement[grid.index(ix, iy)];
      in_contact += here > 0.0 ? 1 : 0;
      edges_x += (here > 0.0) != (p(ix + 1, iy) > 0.0) ? 1 : 0;
      edges_y += (here > 0.0) != (p(ix, iy + 1) > 0.0) ? 1 : 0;
      square += here * here;
      load += here;
      work += here * moved;
      displacement += moved;
      largest = std::max(largest, std::abs(moved));
      moment_x += here * (ix - 64);
      moment_y += here * (iy - 150);
    }
  const auto n = static_cast<double>(grid.size());

  EXPECT_EQ(chunked.area, static_cast<double>(in_contact) / n);
  EXPECT_EQ(chunked.perimeter,
            (static_cast<double>(edges_x) * grid.spacing_y() +
             static_cast<double>(edges_y) * grid.spacing_x()) /
                grid.area());
  const double roundoff = 100.0 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(chunked.contact / (0.35 * square / n), 1.0, roundoff);
  EXPECT_NEAR(chunked.elastic / (0.5 * work / n), 1.0, roundoff);
  EXPECT_NEAR(chunked.mean, displacement / n, roundoff * largest);
  EXPECT_NEAR(chunked.centre_x, grid.spacing_x() * moment_x / load,
              roundoff * grid.length_x);
  EXPECT_NEAR(chunked.centre_y, grid.spacing_y() * moment_y / load,
              roundoff * grid.length_y);
}

// A number that cannot be computed on one rank fails on all, with the message
// of one process.
TEST(SharedObservables, FailOnAllRanks) {
  const Grid grid{128, 256, 1.0, 1.0};
  Maps maps = patchy(grid);
  maps.pressure.assign(grid.size(), 0.0);
  maps.pressure[grid.index(3, 200)] = 1.0;
  maps.gap[grid.index(4, 200)] = std::numeric_limits<double>::quiet_NaN();
  const auto message_of = [&](const Maps& own, const Workers& workers) {
    try {
      static_cast<void>(corrected(grid, own, 1.0, workers));
    } catch (const std::domain_error& error) {
      return std::string(error.what());
    }
    return std::string("no failure");
  };
  const std::string alone = message_of(maps, 1);
  EXPECT_NE(alone.find("gap_outside"), std::string::npos) << alone;
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    const SharedRows rows(grid, ranks, {0, 64, 128, 256});
    EXPECT_EQ(message_of(rows_in(rows, maps), {1, rows}), alone);
  });
}

} // namespace asperity::results::shared_observables_test
