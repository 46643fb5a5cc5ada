// Claim: the solver never gives up. Hundreds of random scenes over kernels,
// roughness, penalty and load; every one ends converged, complementary and in
// balance, checked apart from the solver.
#include "contact/solvers/solver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/contact/scenes.hpp"

namespace asperity::contact {
namespace {

constexpr int n_scenes = 600;

struct Scene {
  Grid grid;
  mechanics::ElasticBlock block;
  scenes::Roughness roughness;
  double local_compliance;
  double nominal_pressure;
};

double log_uniform(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> exponent(std::log(low),
                                                  std::log(high));
  return std::exp(exponent(random));
}

Scene scene_number(unsigned number) {
  std::mt19937_64 random(number);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::array<int, 3> sizes{16, 32, 64};
  const int points = sizes[random() % 3];
  Scene scene;
  scene.grid = {points, points, 1.0, 1.0};
  scene.block = {1.0, 0.3, std::numeric_limits<double>::infinity(),
                 mechanics::FarBoundary::clamped};
  if (random() % 2 == 0) {
    scene.block.thickness = log_uniform(random, 0.02, 2.0);
    scene.block.far_boundary = std::array{
        mechanics::FarBoundary::clamped, mechanics::FarBoundary::sliding,
        mechanics::FarBoundary::pressure}[random() % 3];
    // With a free back the thinnest are plates: see solve_contact.
    scene.block.thickness = log_uniform(
        random,
        scene.block.far_boundary == mechanics::FarBoundary::pressure ? 0.01
                                                                     : 0.02,
        2.0);
  }
  scene.roughness.hurst = 0.2 + 0.7 * unit(random);
  scene.roughness.roll_off = 1.0 + 3.0 * unit(random);
  scene.roughness.shortest_wave = log_uniform(random, 2.0, 16.0);
  scene.roughness.seed = number;
  const bool is_hard = random() % 3 == 0;
  // 1/k in units of h/E*, k from 1e-3 to 1e12 E*/h.
  scene.local_compliance =
      is_hard ? 0.0 : scene.grid.spacing_x() / log_uniform(random, 1e-3, 1e12);
  scene.nominal_pressure = log_uniform(random, 1e-6, 5.0); // E* h' = 1
  return scene;
}

TEST(RandomScenes, AllConvergeAndSatisfyTheirConditions) {
  for (unsigned number = 1; number <= n_scenes; ++number) {
    SCOPED_TRACE(number);
    const Scene scene = scene_number(number);
    const std::vector<double> heights =
        scenes::rough_heights(scene.grid, scene.roughness);
    const double rms_height = scenes::rms(heights);
    if (rms_height == 0.0)
      continue; // no wave fits between roll-off and shortest
    FourierOperator elasticity = halfspace_operator(scene.grid, scene.block);
    const ContactProblem problem{heights, scene.local_compliance,
                                 1e-8 * rms_height, 3000};

    const ContactSolution solution = solve_contact(
        elasticity, problem,
        {mechanics::Control::nominal_pressure, scene.nominal_pressure});

    ASSERT_TRUE(solution.converged) << solution.note;
    // Only a block that bends like a plate may need the active set.
    const bool is_plate =
        scene.block.far_boundary == mechanics::FarBoundary::pressure &&
        scene.block.thickness < 0.1;
    EXPECT_TRUE(solution.note.empty() || is_plate) << solution.note;
    // Rounding of C p and c p: 1e-15 of the largest of them.
    const double rounding =
        1e-14 * scene.nominal_pressure *
        (scene.local_compliance + elasticity.short_wave_compliance()) *
        static_cast<double>(heights.size());
    EXPECT_LE(scenes::complementarity_error(elasticity, problem, solution),
              problem.gap_tolerance * 1.01 + rounding);
    EXPECT_NEAR(solution.nominal_pressure / scene.nominal_pressure, 1.0, 1e-12);
  }
}

} // namespace
} // namespace asperity::contact
