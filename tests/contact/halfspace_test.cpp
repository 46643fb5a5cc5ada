// Tests of contact/operators/halfspace.hpp and
// contact/operators/fourier_operator.hpp.
#include "base/maximum.hpp"
#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::contact::halfspace_test {

using std::numbers::pi;

// A pressure cos(q x) gives the displacement 2/(E* q) cos(q x), and a uniform
// pressure gives none. Tolerance: roundoff of sums over 128 nodes.
TEST(HalfspaceOperator, RespondsToAWaveWithAWave) {
  const Grid grid{16, 8, 2.0, 1.0};
  const double contact_modulus = 3.0;
  FourierOperator elasticity =
      halfspace_operator(grid, {contact_modulus, 0.0, infinity, {}});
  const double qx = wavevector(3, grid.length_x);
  const double qy = wavevector(-2, grid.length_y);
  std::vector<double> pressure(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      pressure[grid.index(ix, iy)] = 5.0 + std::cos(qx * ix * grid.spacing_x() +
                                                    qy * iy * grid.spacing_y());
  std::vector<double> displacement(grid.size());

  elasticity.displacement(pressure, displacement);

  const double expected = 2.0 / (contact_modulus * std::hypot(qx, qy));
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_NEAR(displacement[i], expected * (pressure[i] - 5.0), 1e-14);
}

// Verifies that the preconditioner inverts displacement + c pressure except for
// the mean. Tolerance: single precision, 6e-8, of gaps that differ by the ratio
// of the compliances, up to 8 here.
TEST(FourierOperator, EstimateInvertsTheCompliance) {
  const Grid grid{12, 10, 1.0, 1.5};
  FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.3, 0.4, mechanics::FarBoundary::clamped});
  const double local_compliance = 0.02;
  std::vector<double> pressure(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    pressure[i] = std::sin(3.0 * static_cast<double>(i * i));
  double mean = 0.0;
  for (const double value : pressure)
    mean += value / static_cast<double>(grid.size());
  std::vector<double> gap(grid.size());
  std::vector<float> back(grid.size());

  elasticity.displacement(pressure, gap);
  for (std::size_t i = 0; i < grid.size(); ++i)
    gap[i] += local_compliance * (pressure[i] - mean);
  elasticity.pressure_estimate(std::vector<float>(gap.begin(), gap.end()),
                               local_compliance, back);

  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_NEAR(static_cast<double>(back[i]), pressure[i] - mean, 1e-6);
}

// Verifies that a change computed in single precision is the displacement, to
// the roundoff of a transform, some 6e-8 of the maximum.
TEST(FourierOperator, ChangeIsTheDisplacementInSinglePrecision) {
  const Grid grid{12, 10, 1.0, 1.5};
  FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.3, 0.4, mechanics::FarBoundary::clamped});
  std::vector<float> change(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    change[i] = std::sin(3.0F * static_cast<float>(i * i));
  std::vector<double> expected(grid.size());
  std::vector<float> found(grid.size());

  elasticity.displacement(std::vector<double>(change.begin(), change.end()),
                          expected);
  elasticity.displacement_change(change, found);

  const double largest = largest_magnitude(expected);
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < grid.size(); ++i)
    EXPECT_NEAR(static_cast<double>(found[i]), expected[i], 1e-6 * largest);
}

// Verifies that a long wave has the same compliance on the coarse grid.
TEST(FourierOperator, CoarseFormKeepsTheLongWaves) {
  const Grid grid{64, 64, 1.0, 1.0};
  const FourierOperator fine = problems::unit_halfspace(grid);

  const std::unique_ptr<SurfaceOperator> coarse = fine.coarsened();

  ASSERT_NE(coarse, nullptr);
  EXPECT_EQ(coarse->grid(), (Grid{32, 32, 1.0, 1.0}));
  std::vector<double> pressure(coarse->grid().size());
  std::vector<double> displacement(pressure.size());
  for (int iy = 0; iy < 32; ++iy)
    for (int ix = 0; ix < 32; ++ix)
      pressure[coarse->grid().index(ix, iy)] =
          std::cos(2.0 * pi * (2 * ix - 3 * iy) / 32.0);
  coarse->displacement(pressure, displacement);
  const double expected = 2.0 / (2.0 * pi * std::hypot(2.0, 3.0));
  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(displacement[i], expected * pressure[i], 1e-14);
  EXPECT_EQ(coarse->coarsened(), nullptr);
}

TEST(FourierOperator, RefusesAnInvalidSymbol) {
  const Grid grid{4, 4, 1.0, 1.0};
  EXPECT_THROW(FourierOperator(grid, {1.0, 2.0}), std::domain_error);
  std::vector<double> symbol(grid.half_spectrum_size(), 1.0);
  symbol[5] = -1.0;
  EXPECT_THROW(FourierOperator(grid, symbol), std::domain_error);
}

} // namespace asperity::contact::halfspace_test
