// Surfaces with adhesion turned by 90 degrees: the problem is the same, and
// where the answers are not, both are minima of it.
#include "contact/solvers/adhesive.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::contact::turned_adhesion_test {

using Kind = mechanics::Control;

constexpr Grid grid{32, 32, 1.0, 1.0};

/// The field on the surface turned by 90 degrees `times` times.
std::vector<double> turned(std::vector<double> field, int times) {
  const std::size_t n = 32;
  for (int i = 0; i < times; ++i) {
    std::vector<double> from = field;
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x)
        field[y * n + x] = from[x * n + n - 1 - y];
  }
  return field;
}

double largest_difference(const std::vector<double>& one,
                          const std::vector<double>& other) {
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
    largest = std::max(largest, std::abs(one[i] - other[i]));
  return largest;
}

/// Elastic and interface energy per area [J/m^2].
double energy_of(const ContactSolution& found,
                 const mechanics::ContactInterface& law) {
  double energy = 0.0;
  for (std::size_t i = 0; i < found.gap.size(); ++i)
    energy += 0.5 * found.pressure[i] * found.displacement[i] +
              law.energy(found.gap[i]);
  return energy / static_cast<double>(found.gap.size());
}

struct Turned : testing::TestWithParam<mechanics::ContactLaw> {
  FourierOperator elasticity = problems::unit_halfspace(grid);

  std::vector<double> heights_of(unsigned seed) const {
    std::vector<double> heights = problems::rough_heights(grid, {.seed = seed});
    for (double& height : heights)
      height *= 0.1;
    return heights;
  }

  /// w is a share of the energy of conformity.
  mechanics::ContactInterface law_for(const std::vector<double>& heights,
                                      double share, double softness) {
    std::vector<double> pressure(heights.size());
    elasticity.pressure_of(heights, pressure);
    double work = 0.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
      work += share * 0.5 * heights[i] * pressure[i] /
              static_cast<double>(heights.size());
    return mechanics::ContactSettings{
        .law = GetParam(),
        .work_of_adhesion = work,
        .range =
            mechanics::Quantity{std::sqrt(work * grid.spacing_x() / softness),
                                mechanics::ReferenceUnit::si}}
        .in_si({.contact_modulus = 1.0, .spacing = grid.spacing_x()});
  }
};

// Roundoff decides which of several minima a path comes to. Each answer is one:
// begun beside the other's, the same problem ends there again, with its energy.
TEST_P(Turned, AnswersAreEqualOrBothMinima) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const std::vector<double> heights = heights_of(seed);
    const double rms = problems::rms(heights);
    const auto law = law_for(heights, 1.0, 1.0);
    LoadSequence path(elasticity.clone(), heights, law, 1e-8 * rms, 3000);
    LoadSequence other_path(elasticity.clone(), turned(heights, 1), law,
                            1e-8 * rms, 3000);
    for (const double load : {0.005, 0.0}) {
      const mechanics::LoadTarget target{Kind::nominal_pressure, load};
      const ContactSolution one = path.solve(target);
      const ContactSolution other = other_path.solve(target);
      ASSERT_TRUE(one.converged && other.converged);
      std::vector<double> start = turned(other.gap, 3);
      const std::vector<double> expected = start;
      const std::vector<double> beside = problems::random_field(start.size());
      for (std::size_t i = 0; i < start.size(); ++i)
        start[i] += start[i] != 0.0 ? 1e-4 * rms * beside[i] : 0.0;
      if (mechanics::has_wall(GetParam()))
        for (double& gap : start)
          gap = std::max(gap, 0.0);

      const ContactSolution found = solve_adhesive(
          elasticity,
          {heights, law, 1e-8 * rms, 3000, adhesive_scale(elasticity, heights)},
          target, start);

      EXPECT_GT(one.smallest_stiffness, 0.0);
      EXPECT_GT(found.smallest_stiffness, 0.0);
      EXPECT_LT(largest_difference(found.gap, expected), 1e-5 * rms)
          << "seed " << seed << " at " << load;
      EXPECT_NEAR(energy_of(found, law) / energy_of(other, law), 1.0, 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, Turned,
                         testing::Values(mechanics::ContactLaw::exponential,
                                         mechanics::ContactLaw::lennard_jones));

} // namespace asperity::contact::turned_adhesion_test
