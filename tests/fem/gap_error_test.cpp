// Tests of fem/solution/gap_error.hpp: the estimate is of the size of the error
// that the mesh makes in the mean gap, and zero where it makes none.
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/solver.hpp"
#include "fem/waves/elastic_layers.hpp"
#include "meshes/layers/halvable_layers.hpp"
#include "tests/fem/adaptive_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace asperity::fem::gap_error_test {

const Grid grid{32, 32, length, length};
const mechanics::ElasticBlock bare{.contact_modulus = contact_modulus,
                                   .poisson_ratio = 0.3,
                                   .thickness = length};

std::vector<double> wave() {
  std::vector<double> heights(grid.size());
  const double unit = 2.0 * std::numbers::pi / grid.points_x;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] =
          0.02 * length * std::cos(unit * ix) * std::cos(unit * iy);
  return heights;
}

/// The mean gap by the exact compliance of the block between the same points
/// [m].
double exact_gap(const mechanics::ElasticBlock& block,
                 const std::vector<double>& heights, double reduced_pressure) {
  contact::FourierOperator exact = contact::halfspace_operator(grid, block);
  const contact::ContactSolution found = contact::solve_contact(
      exact, {heights, 0.0, 1e-9 * length, 2000}, pressed(reduced_pressure));
  EXPECT_TRUE(found.converged) << found.note;
  return found.mean_gap;
}

/// The sums of the estimated and of the true errors. The error changes its sign
/// with the nodes that are in contact, so that single loads say little.
struct Errors {
  double estimated = 0.0, true_error = 0.0;

  void add(const BlockSolution& found, double exact) {
    EXPECT_TRUE(found.converged) << found.note;
    estimated += found.estimated_gap_error;
    true_error += std::abs(found.mean_gap - exact);
  }
};

// Uniform meshes of both orders, under a smooth surface.
TEST(GapError, IsOfTheSizeOfTheError) {
  const std::vector<double> heights = wave();
  for (const int degree : {1, 2}) {
    const auto block = uniform_block(grid, degree);
    Errors errors;
    for (const double pressure : {1e-3, 1e-2, 3e-2, 5e-2})
      errors.add(block->solve(heights, pressed(pressure), contact_of(grid)),
                 exact_gap(bare, heights, pressure));

    EXPECT_GT(errors.estimated, 0.5 * errors.true_error) << degree;
    EXPECT_LT(errors.estimated, 10.0 * errors.true_error) << degree;
  }
}

// An adaptive mesh under a coating a thousand times stiffer, whose coarse cells
// take part in its bending.
TEST(GapError, IsLargeOnAnAdaptiveMeshUnderAStiffCoating) {
  constexpr double coating = 0.05 * length;
  const mechanics::BodyModuli hard{1000.0 * soft_modulus, 0.2};
  constexpr int halvings = 2;
  const Grid coarse{grid.points_x >> (halvings + 1),
                    grid.points_y >> (halvings + 1), length, length};
  ModuliField coated(moduli(body));
  coated.add_layer(coating, moduli(hard));
  const std::vector<double> interfaces = coated.interfaces();
  const auto block = make_adaptive_block(
      {.grid = grid,
       .mesh = meshes::layered_mesh(
           coarse, meshes::halvable_layers(coarse.spacing_x(), halvings,
                                           interfaces, length)),
       .degree = 2,
       .moduli = coated,
       .adaptive = AdaptiveMesh{halvings}});
  mechanics::ElasticBlock exact = bare;
  exact.layers = {{coating, hard.youngs_modulus, hard.poisson_ratio}};
  const std::vector<double> heights = self_affine_heights(grid);
  Errors errors;
  for (const double pressure : {0.01, 0.03, 0.1})
    errors.add(block->solve(heights, pressed(pressure), contact_of(grid)),
               exact_gap(exact, heights, pressure));

  EXPECT_GT(errors.estimated, 0.5 * errors.true_error);
  EXPECT_LT(errors.estimated, 10.0 * errors.true_error);
}

// In full contact the mean gap is zero on any mesh; tolerance: roundoff of the
// response. Without contact there is nothing to estimate.
TEST(GapError, IsNoneInFullContactAndWithoutContact) {
  const std::vector<double> heights = wave();
  const auto block = uniform_block(grid, 2);

  const BlockSolution full =
      block->solve(heights, pressed(0.3), contact_of(grid));
  const BlockSolution open = block->solve(
      heights, {Control::mean_gap, 0.1 * length}, contact_of(grid));

  EXPECT_EQ(full.area_by_points, 1.0);
  EXPECT_LT(full.estimated_gap_error, 1e-8 * length);
  EXPECT_TRUE(open.converged);
  EXPECT_TRUE(std::isnan(open.estimated_gap_error));
}

// A load on the far boundary has no response of its own to an approach; the
// estimate then takes the displacement itself. At a depth of one length the
// boundary hardly matters to the contact.
TEST(GapError, IsGivenForEveryFarBoundary) {
  for (const FarBoundary top : {FarBoundary::sliding, FarBoundary::pressure}) {
    const auto block = make_full_block(
        grid, 2,
        homogeneous_block(
            meshes::graded_layers(2.0 * grid.spacing_x(), 1.2, length),
            body.youngs_modulus, body.poisson_ratio, top));
    const auto clamped = uniform_block(grid, 2);
    const double expected =
        clamped->solve(wave(), pressed(1e-2), contact_of(grid))
            .estimated_gap_error;

    const BlockSolution found =
        block->solve(wave(), pressed(1e-2), contact_of(grid));

    EXPECT_GT(found.estimated_gap_error, 0.3 * expected);
    EXPECT_LT(found.estimated_gap_error, 3.0 * expected);
  }
}

} // namespace asperity::fem::gap_error_test
