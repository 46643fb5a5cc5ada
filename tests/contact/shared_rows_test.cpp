// Tests of the contact solver on rows that several ranks share: every number of
// ranks gives the bits of one process. The ranks are threads.
#include "contact/certificate/certificate.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "ranks/chunked_sum.hpp"
#include "tests/contact/problems.hpp"
#include "tests/contact/solved.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <mutex>
#include <numeric>
#include <string>
#include <vector>

namespace asperity::contact::shared_rows_test {

using Kind = mechanics::Control;

mechanics::ElasticBlock block_of(double thickness) {
  return {1.0, 0.3, thickness, mechanics::FarBoundary::clamped};
}

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Setting {
  Grid grid;
  double thickness = infinite;
  mechanics::ContactInterface interface { mechanics::ContactLaw::hard, 0.0 };
  std::vector<mechanics::LoadTarget> targets;
};

std::vector<Solved> solved(LoadSequence& sequence, const Setting& setting,
                           const SharedRows& rows) {
  std::vector<Solved> all;
  for (const mechanics::LoadTarget& target : setting.targets)
    all.push_back(all_rows(sequence.solve(target), rows));
  return all;
}

/// One process without ranks if n_ranks is 0.
std::vector<Solved> solved_on(int n_ranks, const Setting& setting,
                              int threads = 1) {
  const std::vector<double> heights = problems::rough_heights(setting.grid, {});
  const double tolerance = 1e-6 * problems::rms(heights);
  const mechanics::ElasticBlock block = block_of(setting.thickness);
  std::vector<Solved> found;
  if (n_ranks == 0) {
    LoadSequence sequence(
        halfspace_operator(setting.grid, block, threads).clone(), heights,
        setting.interface, tolerance, 2000);
    return solved(sequence, setting, SharedRows(setting.grid));
  }
  std::mutex mutex;
  tests::on_thread_ranks(n_ranks, [&](RankGroup& ranks) {
    auto elasticity = std::make_unique<FourierOperator>(
        setting.grid, ranks, compliance_column(setting.grid, block), threads);
    const SharedRows rows = *elasticity->shared_rows();
    const auto own = rows_in(rows, heights);
    LoadSequence sequence(std::move(elasticity), {own.begin(), own.end()},
                          setting.interface, tolerance, 2000);
    std::vector<Solved> all = solved(sequence, setting, rows);
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(found.empty() || found == all) << "two ranks differ";
    found = std::move(all);
  });
  return found;
}

void expect_same_on_all_ranks(const Setting& setting,
                              const std::vector<int>& ranks) {
  const std::vector<Solved> alone = solved_on(0, setting);
  for (const Solved& one : alone)
    EXPECT_TRUE(one.converged) << one.note;
  for (const int n : ranks)
    EXPECT_TRUE(solved_on(n, setting) == alone) << n << " ranks";
}

TEST(SharedRows, GiveTheBitsOfOneProcessForALoadingPath) {
  expect_same_on_all_ranks({{256, 256, 1.0, 1.0},
                            infinite,
                            {mechanics::ContactLaw::hard, 0.0},
                            {{Kind::nominal_pressure, 0.01},
                             {Kind::nominal_pressure, 0.02},
                             {Kind::nominal_pressure, 0.04},
                             {Kind::nominal_pressure, 0.03}}},
                           {1, 2, 3, 4});
}

TEST(SharedRows, GiveTheBitsOfOneProcessForOtherLawsAndControls) {
  const Grid square{256, 256, 1.0, 1.0};
  expect_same_on_all_ranks({square,
                            0.3,
                            {mechanics::ContactLaw::penalty, 50.0},
                            {{Kind::nominal_pressure, 0.02}}},
                           {2, 3});
  expect_same_on_all_ranks({square,
                            infinite,
                            {mechanics::ContactLaw::augmented, 500.0},
                            {{Kind::nominal_pressure, 0.05}}},
                           {2, 3});
  expect_same_on_all_ranks({square,
                            infinite,
                            {mechanics::ContactLaw::hard, 0.0},
                            {{Kind::mean_gap, 0.02}, {Kind::mean_gap, 0.002}}},
                           {2, 3});
}

TEST(SharedRows, GiveTheBitsOfOneProcessForAnImprint) {
  expect_same_on_all_ranks(
      {{256, 256, 1.0, 1.0},
       infinite,
       {.law = mechanics::ContactLaw::hard, .hardness = 0.2},
       {{Kind::nominal_pressure, 0.04},
        {Kind::nominal_pressure, 0.1},
        {Kind::nominal_pressure, 0.04},
        {Kind::mean_gap, 0.01}}},
      {2, 3});
}

// Units of 64, 16, 8, 64, 64 and 32 rows; odd numbers of points in one
// direction or both, and last units of one row.
TEST(SharedRows, GiveTheBitsOfOneProcessOnAnyGrid) {
  for (const Grid& grid :
       {Grid{130, 260, 1.0, 2.0}, Grid{600, 100, 6.0, 1.0},
        Grid{1000, 36, 10.0, 0.36}, Grid{131, 257, 1.0, 2.0},
        Grid{1001, 130, 7.7, 1.0}, Grid{250, 129, 2.0, 1.0}}) {
    SCOPED_TRACE(std::to_string(grid.points_x) + " by " +
                 std::to_string(grid.points_y));
    expect_same_on_all_ranks({grid,
                              infinite,
                              {mechanics::ContactLaw::hard, 0.0},
                              {{Kind::nominal_pressure, 0.02}}},
                             {1, 2, 3});
  }
}

TEST(SharedRows, GiveTheBitsOfOneProcessOnSeveralThreads) {
  const Setting setting{{256, 256, 1.0, 1.0},
                        infinite,
                        {mechanics::ContactLaw::hard, 0.0},
                        {{Kind::nominal_pressure, 0.02}}};
  EXPECT_TRUE(solved_on(2, setting, 2) == solved_on(0, setting));
  Setting odd = setting;
  odd.grid = {301, 130, 3.0, 1.3};
  const std::vector<Solved> alone = solved_on(0, odd);
  EXPECT_TRUE(solved_on(0, odd, 3) == alone);
  EXPECT_TRUE(solved_on(2, odd, 2) == alone);
}

// The unpreconditioned method, which finishes what stalls.
TEST(SharedRows, GiveTheBitsOfOneProcessToTheReferenceSolver) {
  const Grid grid{256, 128, 1.0, 0.5};
  std::vector<double> heights(grid.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = 1e-3 * std::sin(0.03 * static_cast<double>(i % 256)) *
                 std::cos(0.05 * static_cast<double>(i / 256));
  const auto solve = [&](SurfaceOperator& elasticity, const SharedRows& rows) {
    return all_rows(polonsky_keer(elasticity,
                                  {rows_in(rows, heights), 0.0, 1e-8, 500},
                                  {Kind::nominal_pressure, 1e-3}),
                    rows);
  };
  FourierOperator whole = halfspace_operator(grid, block_of(infinite));
  const Solved alone = solve(whole, SharedRows(grid));
  EXPECT_TRUE(alone.converged);
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    FourierOperator elasticity(grid, ranks,
                               compliance_column(grid, block_of(infinite)));
    EXPECT_TRUE(solve(elasticity, *elasticity.shared_rows()) == alone);
  });
}

void expect_equal_bits_of_certificate(const Grid& grid) {
  const std::vector<double> heights = problems::rough_heights(grid, {});
  FourierOperator whole = halfspace_operator(grid, block_of(infinite));
  const std::vector<double> alone = certificate_of(whole, heights);
  EXPECT_GT(alone[1], 0.0);
  for (const int n : {1, 2, 3})
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      FourierOperator elasticity(grid, ranks,
                                 compliance_column(grid, block_of(infinite)));
      EXPECT_EQ(certificate_of(elasticity,
                               rows_in(*elasticity.shared_rows(), heights)),
                alone);
    });
}

TEST(SharedRows, GiveTheBitsOfOneProcessToTheCertificate) {
  expect_equal_bits_of_certificate({256, 128, 1.0, 0.5});
  expect_equal_bits_of_certificate({301, 131, 1.0, 0.5});
}

/// What two ranks find for a thin plate that bends and stalls, beside what one
/// process finds.
void expect_equal_bits_of_stalled(double pressure, bool has_few_nodes) {
  const Grid grid{128, 128, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  const double tolerance = 1e-3 * problems::rms(heights);
  const mechanics::ElasticBlock plate{1.0, 0.3, 0.005,
                                      mechanics::FarBoundary::pressure};
  const auto solved = [&](SurfaceOperator& elasticity,
                          std::span<const double> own) {
    return solve_contact(elasticity, {own, 0.0, tolerance, 400},
                         {Kind::nominal_pressure, pressure});
  };
  FourierOperator of_one = halfspace_operator(grid, plate);
  const Solved alone = all_rows(solved(of_one, heights), SharedRows(grid));
  EXPECT_NE(alone.note.find("finished by the active-set method"),
            std::string::npos)
      << alone.note;
  EXPECT_EQ(alone.note.find("too many") == std::string::npos, has_few_nodes)
      << alone.note;
  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    FourierOperator elasticity(grid, ranks, compliance_column(grid, plate));
    const SharedRows& rows = *elasticity.shared_rows();
    const Solved shared =
        all_rows(solved(elasticity, rows_in(rows, heights)), rows);
    EXPECT_TRUE(shared == alone) << shared.note;
  });
}

// A stalled problem is passed to the active-set method, with the bits of one
// process, if it has few nodes in contact, and otherwise to the
// unpreconditioned method.
TEST(SharedRows, FinishWhatStallsAsOneProcess) {
  expect_equal_bits_of_stalled(5e-8, true);
  expect_equal_bits_of_stalled(8e-8, true);
  expect_equal_bits_of_stalled(1e-5, false);
}

TEST(SharedRows, HoldWholeGroupsOfChunks) {
  for (const Grid& grid : {Grid{256, 256, 1.0, 1.0}, Grid{1024, 1024, 1.0, 1.0},
                           Grid{512, 384, 1.0, 1.0}, Grid{4096, 4096, 1.0, 1.0},
                           Grid{16384, 16384, 1.0, 1.0}})
    for (const int n : {1, 2, 3, 4, 6}) {
      const std::vector<int> bounds = row_bounds(grid, n);
      ASSERT_EQ(bounds.size(), static_cast<std::size_t>(n) + 1);
      EXPECT_TRUE(holds_whole_groups(grid, bounds));
      for (std::size_t r = 0; r < bounds.size() - 1; ++r) {
        const std::size_t begin =
            grid.index(0, bounds[r]) %
            (NodeChunks(grid).in_group(grid.size()) * 8192);
        EXPECT_EQ(begin, 0U) << grid.points_x << ", " << n << " ranks";
        EXPECT_EQ(bounds[r] % 2, 0);
      }
    }
  EXPECT_EQ(most_ranks({128, 128, 1.0, 1.0}), 2);
  EXPECT_THROW(row_bounds({128, 128, 1.0, 1.0}, 3), std::domain_error);
}

// Equal shares remain shared on coarser grids as long as these have enough
// chunks.
TEST(SharedRows, StaySharedOnCoarserGrids) {
  const Grid grid{1024, 1024, 1.0, 1.0};
  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    const FourierOperator fine(grid, ranks,
                               compliance_column(grid, block_of(infinite)));
    const auto half = fine.coarsened();
    ASSERT_NE(half->shared_rows(), nullptr);
    EXPECT_EQ(half->shared_rows()->count(), 256);
    const auto quarter = half->coarsened();
    ASSERT_NE(quarter->shared_rows(), nullptr);
    const auto eighth = quarter->coarsened(); // two chunks
    ASSERT_NE(eighth->shared_rows(), nullptr);
    EXPECT_EQ(eighth->coarsened()->shared_rows(), nullptr);
  });
}

// More than most_groups chunks: the sums of a group are added first.
TEST(SharedRows, GiveTheBitsOfOneProcessToSumsOfManyChunks) {
  const Grid grid{4096, 3072, 1.0, 1.0};
  ASSERT_EQ(NodeChunks(grid).in_group(grid.size()), 2U);
  const auto sum_of = [](std::size_t first, std::size_t nodes,
                         const Workers& workers) {
    return chunked_sum<Sum>(nodes, workers,
                            [=](std::size_t begin, std::size_t end) {
                              double sum = 0.0;
                              for (std::size_t i = begin; i < end; ++i)
                                sum += 1.0 / static_cast<double>(1 + first + i);
                              return Sum{sum};
                            })
        .value;
  };
  const double alone = sum_of(0, grid.size(), 1);
  for (const int n : {1, 3, 4})
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const SharedRows rows(grid, ranks, row_bounds(grid, n));
      EXPECT_EQ(sum_of(grid.index(0, rows.first()), rows.size(), {1, rows}),
                alone);
      EXPECT_EQ(total_count({1, rows}, 1), static_cast<std::size_t>(n));
    });
}

} // namespace asperity::contact::shared_rows_test
