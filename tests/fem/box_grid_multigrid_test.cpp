// Tests of the convergence rate of conjugate gradients with the multigrid of
// fem/multigrid, for any grid of boxes, moduli and contact. The stiffness
// itself is compared with deal.II's in box_grid_block_test.cpp.
#include "fem/multigrid/box_grid_levels.hpp"
#include "fem/multigrid/box_grid_multigrid.hpp"
#include "fem/multigrid/chebyshev.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::fem::box_grid_multigrid_test {

/// A graded block with cubes at the surface, as deep as it is wide.
BoxGrid graded_box_grid(int degree, int cells, double growth) {
  BoxGrid box_grid;
  box_grid.degree = degree;
  box_grid.cells_x = box_grid.cells_y = cells;
  box_grid.length_x = box_grid.length_y = 1.0;
  box_grid.thickness = meshes::graded_layers(1.0 / cells, growth, 1.0);
  box_grid.moduli.assign(box_grid.thickness.size(), {1.5, 1.0}); // nu = 0.3
  return box_grid;
}

/// Moduli from 10^-decades to 10^decades, evenly distributed in the exponent.
void make_heterogeneous(BoxGrid& box_grid, double decades) {
  const std::size_t cells = box_grid.thickness.size() *
                            static_cast<std::size_t>(box_grid.cells_x) *
                            static_cast<std::size_t>(box_grid.cells_y);
  box_grid.moduli.clear();
  for (const double chance : random_field(cells, 4)) {
    const double factor = std::pow(10.0, decades * (2.0 * chance - 1.0));
    box_grid.moduli.push_back({1.5 * factor, factor});
  }
}

/// The nodes in contact with the highest fifth of a wavy surface.
std::vector<bool> touched(const NodeLayout& layout) {
  std::vector<bool> nodes;
  const double turn = 2.0 * std::numbers::pi;
  for (int y = 0; y < layout.nodes_y(); ++y)
    for (int x = 0; x < layout.nodes_x(); ++x) {
      const double u = turn * x / layout.nodes_x();
      const double v = turn * y / layout.nodes_y();
      nodes.push_back(std::cos(u) + std::cos(2.0 * v + 1.0) +
                          0.7 * std::cos(3.0 * u + 2.0 * v) +
                          0.5 * std::cos(5.0 * u - 4.0 * v + 0.5) >
                      1.1);
    }
  return nodes;
}

/// The u_z of these nodes.
std::vector<std::size_t> touched_unknowns(const NodeLayout& layout) {
  const std::vector<bool> nodes = touched(layout);
  std::vector<std::size_t> unknowns;
  for (int y = 0; y < layout.nodes_y(); ++y)
    for (int x = 0; x < layout.nodes_x(); ++x)
      if (nodes[static_cast<std::size_t>(y * layout.nodes_x() + x)])
        unknowns.push_back(layout.index(x, y, 0, 2));
  return unknowns;
}

MeshContact held_nodes(const NodeLayout& layout) {
  MeshContact contact;
  contact.held = touched_unknowns(layout);
  return contact;
}

MeshContact nodal_springs(const NodeLayout& layout, double stiffness) {
  MeshContact contact;
  contact.has_springs = true;
  contact.unknowns = touched_unknowns(layout);
  for (std::size_t node = 0; node < contact.unknowns.size(); ++node) {
    contact.springs.column.push_back(node);
    contact.springs.weight.push_back(stiffness);
    contact.springs.start.push_back(node + 1);
  }
  return contact;
}

/// Random forces below the contact surface, which are zero at the far boundary.
std::vector<double> random_forces(const NodeLayout& layout) {
  std::vector<double> force(layout.size(), 0.0);
  const std::vector<double> numbers = random_field(layout.size(), 6);
  std::size_t number = 0;
  for (int k = 1; k + 1 < static_cast<int>(layout.planes()); ++k)
    for (int y = 0; y < layout.nodes_y(); ++y)
      for (int x = 0; x < layout.nodes_x(); ++x)
        for (int c = 0; c < 3; ++c)
          force[layout.index(x, y, k, c)] = numbers[number++] - 0.5;
  return force;
}

/// Iterations to a given residual relative to the force; 1000 if it is not
/// reached.
int iterations(const BoxGrid& box_grid, const MeshContact& contact,
               double tolerance = 1e-8) {
  BoxGridMultigrid multigrid(box_grid);
  multigrid.set_contact(contact);
  const std::vector<double> force = random_forces(multigrid.layout());
  double square = 0.0;
  for (const double value : force)
    square += value * value;
  std::vector<double> displacement(force.size(), 0.0);
  multigrid.force() = force;
  const LinearSolution solution =
      multigrid.solve(displacement, tolerance * std::sqrt(square), 300);
  return solution.has_converged ? solution.iterations : 1000;
}

class BoxGridDegrees : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Both, BoxGridDegrees, ::testing::Values(1, 2));

// Verifies that the number of iterations does not depend on the number of
// cells, the grading ratio or the conditions at the sides.
TEST_P(BoxGridDegrees, NeedAsManyIterationsAtEverySize) {
  for (const int cells : {6, 12, 24})
    for (const double growth : {1.0, 1.2, 1.5})
      for (const bool is_periodic : {true, false}) {
        if (cells * growth > 24.0 / GetParam())
          continue;
        BoxGrid box_grid = graded_box_grid(GetParam(), cells, growth);
        box_grid.is_periodic = is_periodic;
        EXPECT_LE(iterations(box_grid, {}), 8)
            << cells << " cells, growth " << growth;
      }
}

// Verifies that cells with unequal sides and an odd number of cells need no
// more iterations.
TEST_P(BoxGridDegrees, NeedFewIterationsOnAnyBoxGrid) {
  BoxGrid odd = graded_box_grid(GetParam(), 13, 1.3);
  BoxGrid oblong = graded_box_grid(GetParam(), 12, 1.3);
  oblong.cells_y = 3;
  BoxGrid narrow = graded_box_grid(GetParam(), 12, 1.3);
  narrow.length_y = 0.2;
  BoxGrid coated = graded_box_grid(GetParam(), 12, 1.3);
  coated.thickness.insert(coated.thickness.begin(), 2, 0.01);
  coated.moduli.insert(coated.moduli.begin(), 2, {15.0, 10.0});
  BoxGrid single = graded_box_grid(GetParam(), 1, 1.3);

  EXPECT_LE(iterations(odd, {}), 9);
  EXPECT_LE(iterations(oblong, {}), 9);
  EXPECT_LE(iterations(narrow, {}), 12);
  EXPECT_LE(iterations(coated, {}), 20);
  EXPECT_LE(iterations(single, {}), 2);
}

// Verifies that nodes in hard contact and springs of any stiffness are
// represented well enough on the coarse grids.
TEST_P(BoxGridDegrees, NeedFewIterationsInContact) {
  const BoxGrid box_grid = graded_box_grid(GetParam(), 24 / GetParam(), 1.2);
  const NodeLayout layout(box_grid);

  EXPECT_LE(iterations(box_grid, held_nodes(layout)), 8);
  for (const double stiffness : {1e-4, 1.0, 1e2, 1e4}) {
    const double own = stiffness / box_grid.cells_x; // times mu h
    EXPECT_LE(iterations(box_grid, nodal_springs(layout, own)), 14)
        << stiffness;
  }
}

// Verifies that heterogeneous moduli need a few more iterations, and contrasts
// of six decades between neighbours some tens.
TEST_P(BoxGridDegrees, NeedMoreIterationsForHeterogeneousModuli) {
  BoxGrid box_grid = graded_box_grid(GetParam(), 24 / GetParam(), 1.2);
  const NodeLayout layout(box_grid);

  make_heterogeneous(box_grid, 0.2); // a factor of 2.5
  EXPECT_LE(iterations(box_grid, held_nodes(layout), 1e-12), 15);
  make_heterogeneous(box_grid, 1.0);
  EXPECT_LE(iterations(box_grid, held_nodes(layout)), 24);
  make_heterogeneous(box_grid, 3.0);
  EXPECT_LE(iterations(box_grid, held_nodes(layout)), 100);
}

// States the limit of the method near incompressibility, where a smoother of
// single nodes is a poor one: the iterations grow approximately as 1 / (1 - 2
// nu)^0.5.
TEST_P(BoxGridDegrees, NeedManyIterationsNearIncompressibility) {
  BoxGrid box_grid = graded_box_grid(GetParam(), 24 / GetParam(), 1.2);
  const auto at = [&](double poisson_ratio) {
    const double ratio = 2.0 * poisson_ratio / (1.0 - 2.0 * poisson_ratio);
    box_grid.moduli.assign(box_grid.thickness.size(), {ratio, 1.0});
    return iterations(box_grid, {});
  };

  EXPECT_LE(at(0.45), 16);
  EXPECT_LE(at(0.49), 40);
  EXPECT_LE(at(0.499), 140);
}

// Verifies that the units do not change the iterations, although the cycle
// works in single precision.
TEST_P(BoxGridDegrees, NeedAsManyIterationsInAnyUnit) {
  BoxGrid box_grid = graded_box_grid(GetParam(), 8, 1.2);
  const int expected = iterations(box_grid, {});
  box_grid.length_x = box_grid.length_y = 1e-25;
  for (double& thickness : box_grid.thickness)
    thickness *= 1e-25;
  for (CellModuli& moduli : box_grid.moduli)
    moduli = {1e-20 * moduli.lame, 1e-20 * moduli.shear};

  EXPECT_EQ(iterations(box_grid, {}), expected);
}

// The cycle is symmetric and positive, as conjugate gradients require.
// Tolerance: single precision.
TEST_P(BoxGridDegrees, HaveASymmetricCycle) {
  const BoxGrid box_grid = graded_box_grid(GetParam(), 8, 1.3);
  const NodeLayout layout(box_grid);
  BoxGridMultigrid multigrid(box_grid);
  multigrid.set_contact(nodal_springs(layout, multigrid.unit()));
  const std::vector<double> a = random_forces(layout);
  std::vector<double> b(a.size(), 0.0);
  for (int y = 0; y < layout.nodes_y(); ++y)
    b[layout.index(0, y, 0, 2)] = 1.0 + y;
  const auto run = [&](const std::vector<double>& force) {
    std::transform(force.begin(), force.end(), multigrid.cycle_force().begin(),
                   [](double value) { return static_cast<float>(value); });
    multigrid.run_cycle();
    return multigrid.cycle_displacement();
  };
  const auto inner_product = [](const auto& x, const auto& y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += x[i] * static_cast<double>(y[i]);
    return sum;
  };

  const std::vector<float> by_a = run(a), by_b = run(b);

  const double a_a = inner_product(a, by_a), b_b = inner_product(b, by_b);
  EXPECT_GT(a_a, 0.0);
  EXPECT_GT(b_b, 0.0);
  EXPECT_NEAR(inner_product(a, by_b), inner_product(b, by_a),
              1e-5 * std::sqrt(a_a * b_b));
}

// Verifies that merged layers stay below three times the smallest side of a
// cell while there are layers to merge, and that moduli are averaged over the
// volume.
TEST(BoxGridLevels, MergeShortCellsOnly) {
  BoxGrid box_grid = graded_box_grid(1, 16, 1.5);
  box_grid.moduli.front() = {4.0, 3.0};
  const BoxGrid next = coarser(box_grid);

  EXPECT_EQ(next.cells_x, 8);
  ASSERT_LT(next.thickness.size(), box_grid.thickness.size());
  EXPECT_LE(next.thickness.front(), 3.0 / 16.0);
  EXPECT_EQ(next.thickness.back(), box_grid.thickness.back());
  const double share = box_grid.thickness[0] / next.thickness[0];
  EXPECT_NEAR(next.moduli[0].shear, 1.0 + 2.0 * share, 1e-12);
}

// Verifies that invalid grids are refused.
TEST(BoxGrid, IsRefusedOutsideOfItsRange) {
  BoxGrid box_grid = graded_box_grid(1, 4, 1.2);
  box_grid.moduli.pop_back();
  EXPECT_THROW(BoxGridMultigrid{box_grid}, std::domain_error);
  box_grid = graded_box_grid(3, 4, 1.2);
  EXPECT_THROW(BoxGridMultigrid{box_grid}, std::domain_error);
  box_grid = graded_box_grid(1, 4, 1.2);
  box_grid.is_periodic = box_grid.holds_normal = false;
  EXPECT_THROW(BoxGridMultigrid{box_grid}, std::domain_error);
}

// Verifies that the memory of a rank falls with the number of ranks. A quarter
// of the rows takes a quarter of the memory. The image row adds a sixteenth of
// it, and the coarse grids of boxes that every rank has some per cent.
TEST_P(BoxGridDegrees, DivideTheirMemoryAmongRanks) {
  BoxGrid box_grid = graded_box_grid(GetParam(), 8, 1.3);
  box_grid.cells_y = 64;
  box_grid.length_y = 8.0;
  const std::size_t alone = BoxGridMultigrid(box_grid).bytes();
  tests::on_thread_ranks(4, [&](RankGroup& ranks) {
    EXPECT_LT(BoxGridMultigrid(box_grid, &ranks).bytes(), 35 * alone / 100);
  });
}

// Verifies that every rank solves a grid of boxes of few rows alone, and that
// boundaries between ranks are those of coarser rows.
TEST(BoxGridRows, AreSharedIfThereAreMany) {
  BoxGrid box_grid = graded_box_grid(1, 8, 1.3);
  box_grid.cells_y = 6;
  tests::on_thread_ranks(4, [&](RankGroup& ranks) {
    EXPECT_FALSE(BoxGridMultigrid(box_grid, &ranks).slab().is_shared());
  });
  box_grid.cells_y = 64;
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    EXPECT_EQ(divided(box_grid, &ranks).bounds(),
              std::vector<int>({0, 16, 40, 64}));
  });
}

// Verifies the estimate by a few steps of Lanczos' method.
TEST(Smoother, EigenvalueEstimateIsAnUpperBound) {
  // The string of n + 1 springs has the eigenvalues 2 - 2 cos(pi k/(n + 1)).
  constexpr std::size_t size = 300;
  const std::vector<float> diagonal(size, 2.0F);
  const double estimate =
      eigenvalue_estimate(diagonal, [](const float* from, float* to) {
        for (std::size_t i = 0; i < size; ++i)
          to[i] = 2.0F * from[i] - (i > 0 ? from[i - 1] : 0.0F) -
                  (i + 1 < size ? from[i + 1] : 0.0F);
      });
  const double exact = 1.0 + std::cos(std::numbers::pi / (size + 1));
  EXPECT_GE(estimate, exact);
  EXPECT_LE(estimate, 1.1 * exact * (1.0 + 1e-5));
}

} // namespace asperity::fem::box_grid_multigrid_test
