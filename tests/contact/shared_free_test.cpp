// Tests of the half-space with free boundaries on rows that several ranks
// share: every number of ranks gives the bits of one process. The ranks are
// threads. Tolerance: none.
#include "contact/certificate/certificate.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/active_set.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"
#include "tests/contact/solved.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::contact::shared_free_test {

using Kind = mechanics::Control;

constexpr double modulus = 1.0;

/// What an operator makes of fields, with all rows.
struct Applied {
  std::vector<double> displacement, change, estimate, wide_estimate;
  double short_wave;

  bool operator==(const Applied&) const = default;
};

/// @param own  of all rows
std::vector<double> gathered(const SharedRows& rows,
                             std::span<const float> own) {
  return rows.gathered(std::vector<double>(own.begin(), own.end()));
}

Applied applied(SurfaceOperator& elasticity) {
  const SharedRows rows = elasticity.shared_rows() != nullptr
                              ? *elasticity.shared_rows()
                              : SharedRows(elasticity.grid());
  const SharedRows wide = elasticity.wide_shared_rows() != nullptr
                              ? *elasticity.wide_shared_rows()
                              : SharedRows(elasticity.wide_grid());
  const std::vector<double> all = problems::random_field(rows.grid().size());
  const std::vector<double> all_wide =
      problems::random_field(wide.grid().size());
  const auto own = rows_in(rows, all), own_wide = rows_in(wide, all_wide);
  const std::vector<float> field(own.begin(), own.end());
  const std::vector<float> wide_field(own_wide.begin(), own_wide.end());
  std::vector<double> exact(field.size());
  std::vector<float> change(field.size()), estimate(field.size()),
      wide_estimate(wide_field.size());
  elasticity.displacement(own, exact);
  elasticity.displacement_change(field, change);
  elasticity.pressure_estimate(field, 0.1, estimate);
  elasticity.wide_pressure_estimate(wide_field, 0.0, wide_estimate);
  return {rows.gathered(exact), gathered(rows, change),
          gathered(rows, estimate), gathered(wide, wide_estimate),
          elasticity.short_wave_compliance()};
}

// Claim: so do grids of every second node, some of which are not shared, and a
// clone.
TEST(SharedFreeHalfspace, HasTheBitsOfOneProcess) {
  const Grid grid{256, 512, 2.0, 1.0};
  FreeHalfspace alone(grid, modulus);
  const auto half = alone.coarsened();
  const auto quarter = half->coarsened();
  const std::vector<Applied> expected{applied(alone), applied(*half),
                                      applied(*quarter)};
  for (int n = 1; n <= 4; ++n)
    for (const int threads : {1, 3})
      tests::on_thread_ranks(n, [&](RankGroup& ranks) {
        FreeHalfspace shared(grid, ranks, modulus, threads);
        const auto coarse = shared.coarsened();
        const auto coarser = coarse->coarsened();
        EXPECT_EQ(coarse->shared_rows() == nullptr, n == 3) << n;
        EXPECT_FALSE(coarse->is_periodic());
        EXPECT_TRUE(applied(*shared.clone()) == expected[0])
            << n << " ranks, " << threads << " threads";
        EXPECT_TRUE(applied(*coarse) == expected[1]) << n << " ranks";
        EXPECT_TRUE(applied(*coarser) == expected[2]) << n << " ranks";
      });
}

struct Setting {
  std::vector<double> heights;
  mechanics::ContactInterface interface { mechanics::ContactLaw::hard, 0.0 };
  std::vector<double> loads; ///< [Pa]
};

const Grid square{256, 256, 1.0, 1.0};

std::vector<Solved> solved(const Setting& setting,
                           std::unique_ptr<SurfaceOperator> elasticity) {
  const SharedRows rows = elasticity->shared_rows() != nullptr
                              ? *elasticity->shared_rows()
                              : SharedRows(elasticity->grid());
  const auto own = rows_in(rows, setting.heights);
  LoadSequence sequence(std::move(elasticity), {own.begin(), own.end()},
                        setting.interface,
                        1e-6 * problems::rms(setting.heights), 2000);
  std::vector<Solved> all;
  for (const double load : setting.loads)
    all.push_back(
        all_rows(sequence.solve({Kind::nominal_pressure, load}), rows));
  return all;
}

/// @return  what one process finds
std::vector<Solved> expect_same_on_all_ranks(const Setting& setting,
                                             const std::vector<int>& ranks,
                                             int threads = 1) {
  const std::vector<Solved> alone =
      solved(setting, std::make_unique<FreeHalfspace>(square, modulus));
  for (const Solved& one : alone)
    EXPECT_TRUE(one.converged) << one.note;
  for (const int n : ranks)
    tests::on_thread_ranks(n, [&](RankGroup& group) {
      EXPECT_TRUE(solved(setting,
                         std::make_unique<FreeHalfspace>(square, group, modulus,
                                                         threads)) == alone)
          << n << " ranks";
    });
  return alone;
}

std::size_t in_contact(const std::vector<double>& pressure) {
  return pressure.size() -
         static_cast<std::size_t>(std::ranges::count(pressure, 0.0));
}

TEST(SharedFreeContact, GivesTheBitsOfOneProcessForALoadingPath) {
  expect_same_on_all_ranks({.heights = problems::rough_heights(square, {}),
                            .loads = {0.02, 0.04, 0.3, 0.1}},
                           {1, 2, 3, 4});
}

TEST(SharedFreeContact, GivesTheBitsOfOneProcessOnSeveralThreads) {
  expect_same_on_all_ranks(
      {.heights = problems::rough_heights(square, {}), .loads = {0.03}}, {2},
      3);
}

TEST(SharedFreeContact, GivesTheBitsOfOneProcessForOtherLaws) {
  const std::vector<double> heights = problems::rough_heights(square, {});
  expect_same_on_all_ranks(
      {heights, {mechanics::ContactLaw::penalty, 50.0}, {0.02}}, {3});
  expect_same_on_all_ranks(
      {heights, {mechanics::ContactLaw::augmented, 500.0}, {0.05}}, {2});
}

// A sphere beside the middle: small loads, a contact that ends at the border,
// and full contact.
TEST(SharedFreeContact, GivesTheBitsOfOneProcessAtTheBorder) {
  std::vector<double> sphere(square.size());
  for (int iy = 0; iy < square.points_y; ++iy)
    for (int ix = 0; ix < square.points_x; ++ix)
      sphere[square.index(ix, iy)] =
          -(std::pow(ix * square.spacing_x() - 0.4, 2) +
            std::pow(iy * square.spacing_y() - 0.3, 2)) /
          20.0;
  const std::vector<Solved> found = expect_same_on_all_ranks(
      {.heights = sphere, .loads = {1e-4, 0.02, 1.0}}, {1, 2, 3, 4});
  EXPECT_EQ(found[0].pressure[128], 0.0);
  EXPECT_GT(found[1].pressure[128], 0.0);
  EXPECT_LT(in_contact(found[1].pressure), square.size());
  EXPECT_EQ(in_contact(found[2].pressure), square.size());
}

// The unpreconditioned method, which finishes what stalls, and the active-set
// method, which gathers a small problem.
TEST(SharedFreeContact, GivesTheBitsOfOneProcessToOtherSolvers) {
  const Grid grid{256, 128, 1.0, 0.5};
  std::vector<double> heights(grid.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = -1e-6 * std::pow(static_cast<double>(i % 256) - 100.0, 2) -
                 1e-6 * std::pow(static_cast<double>(i / 256) - 60.0, 2);
  using Solve = std::function<ContactSolution(
      SurfaceOperator&, const ContactProblem&, const mechanics::LoadTarget&)>;
  const std::vector<Solve> solvers{
      [](auto& c, const auto& problem, const auto& target) {
        return polonsky_keer(c, problem, target);
      },
      [](auto& c, const auto& problem, const auto& target) {
        const auto start = polonsky_keer(
            c, {problem.heights, 0.0, 1e3 * problem.gap_tolerance, 50}, target);
        return active_set(c, problem, target, start.pressure);
      }};
  for (const Solve& solver : solvers) {
    const auto solve = [&](SurfaceOperator& elasticity,
                           const SharedRows& rows) {
      return all_rows(solver(elasticity,
                             {rows_in(rows, heights), 0.0, 1e-8, 500},
                             {Kind::nominal_pressure, 1e-5}),
                      rows);
    };
    FreeHalfspace whole(grid, modulus);
    const Solved alone = solve(whole, SharedRows(grid));
    EXPECT_TRUE(alone.converged) << alone.note;
    tests::on_thread_ranks(3, [&](RankGroup& ranks) {
      FreeHalfspace elasticity(grid, ranks, modulus);
      EXPECT_TRUE(solve(elasticity, *elasticity.shared_rows()) == alone);
    });
  }
}

TEST(SharedFreeContact, GivesTheBitsOfOneProcessToTheCertificate) {
  const Grid grid{256, 128, 1.0, 0.5};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  FreeHalfspace whole(grid, modulus);
  const std::vector<double> alone = certificate_of(whole, heights);
  EXPECT_GT(alone[1], 0.0);
  for (const int n : {1, 2, 3})
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      FreeHalfspace elasticity(grid, ranks, modulus);
      EXPECT_EQ(certificate_of(elasticity,
                               rows_in(*elasticity.shared_rows(), heights)),
                alone);
    });
}

TEST(SharedFreeContact, RefusesAPrescribedMeanGap) {
  const Grid grid{128, 128, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    FreeHalfspace elasticity(grid, ranks, modulus);
    EXPECT_THROW(
        solve_contact(elasticity,
                      {rows_in(*elasticity.shared_rows(), heights), 0.0, 1e-9},
                      {Kind::mean_gap, 0.01}),
        std::domain_error);
  });
}

} // namespace asperity::contact::shared_free_test
