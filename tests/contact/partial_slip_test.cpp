// The traction of mechanics/partial_slip.hpp, from two normal contacts, under
// the tangential compliance of a half-space:
//     (2/(E* (1 - nu) |k|)) [1 - nu k k^T/|k|^2].
#include "contact/operators/fourier_operator.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "mechanics/partial_slip.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

namespace asperity::contact::partial_slip_test {
namespace {

constexpr Grid grid{128, 128, 1.0, 1.0};

/// Displacements along and across the traction q, which acts along x.
struct Shear {
  std::vector<double> along, across;
};

Shear shear_of(const std::vector<double>& traction, double poisson) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  fourier.forward(traction, modes);
  for (std::complex<double>& mode : modes)
    mode /= static_cast<double>(grid.size());
  std::vector<std::complex<double>> other = modes;
  std::size_t at = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++at) {
      const double x = wavevector(jx, grid.length_x);
      const double y =
          wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y);
      const double k = std::hypot(x, y);
      const bool is_highest =
          2 * jx == grid.points_x || 2 * jy == grid.points_y;
      const double compliance = k > 0.0 ? 2.0 / (k * (1.0 - poisson)) : 0.0;
      other[at] *=
          is_highest ? 0.0 : -compliance * poisson * x * y / (k * k + 1e-300);
      modes[at] *= compliance * (1.0 - poisson * x * x / (k * k + 1e-300));
    }
  Shear shear{std::vector<double>(grid.size()),
              std::vector<double>(grid.size())};
  fourier.backward(modes, shear.along);
  fourier.backward(other, shear.across);
  return shear;
}

/// How far the displacements are from those of partial slip.
struct Departure {
  double stick = 0.0;    ///< rms of the displacement of nodes that stick, from
                         ///< their mean, over it
  double slip = 0.0;     ///< rms of the slip across the traction, over the mean
                         ///< slip
  double backward = 0.0; ///< share of slipping nodes that go backwards
  double shift = 0.0;    ///< mean displacement of nodes that stick, over kappa
                         ///< times their normal one
};

class RoughSlip : public testing::Test {
protected:
  RoughSlip() {
    LoadSequence path(elasticity.clone(), problems::rough_heights(grid, {}), {},
                      1e-11, 1000);
    eased = path.solve({mechanics::Control::nominal_pressure, 0.05});
    pressed = path.solve({mechanics::Control::nominal_pressure, 0.1});
  }

  Departure departure(double poisson) const {
    std::vector<double> traction(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i)
      traction[i] = pressed.pressure[i] - eased.pressure[i];
    const Shear shear = shear_of(traction, poisson);
    double shift = 0.0, normal = 0.0, n_stick = 0.0, n_slip = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (eased.pressure[i] > 0.0) {
        shift += shear.along[i];
        normal += pressed.displacement[i] - eased.displacement[i];
        n_stick += 1.0;
      }
    shift /= n_stick;
    Departure found;
    double slip = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double own = shift - shear.along[i];
      if (eased.pressure[i] > 0.0) {
        found.stick += own * own + shear.across[i] * shear.across[i];
      } else if (pressed.pressure[i] > 0.0) {
        slip += own;
        found.slip += shear.across[i] * shear.across[i];
        found.backward += own < 0.0 ? 1.0 : 0.0;
        n_slip += 1.0;
      }
    }
    slip /= n_slip;
    found.stick = std::sqrt(found.stick / n_stick) / shift;
    found.slip = std::sqrt(found.slip / n_slip) / slip;
    found.backward /= n_slip;
    found.shift =
        shift / (normal / n_stick) / ((2.0 - poisson) / (2.0 - 2.0 * poisson));
    return found;
  }

  FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
  ContactSolution eased, pressed;
};

} // namespace

// The solution is exact: nothing moves where it sticks, and every other node
// slips along the traction. The pressures are exact to 1e-11 of the slope 1
// times the spacing.
TEST_F(RoughSlip, IsExactWithoutPoissonsEffect) {
  const Departure found = departure(0.0);

  EXPECT_LT(found.stick, 1e-6);
  EXPECT_LT(found.slip, 1e-12);
  EXPECT_EQ(found.backward, 0.0);
  EXPECT_NEAR(found.shift, 1.0, 1e-6);
}

// With nu > 0 it is an approximation. Its errors on this surface are those of
// docs/numerics/friction.md.
TEST_F(RoughSlip, IsApproximateWithPoissonsEffect) {
  const Departure found = departure(0.5);

  EXPECT_NEAR(found.shift, 0.994, 1e-3);
  EXPECT_NEAR(found.stick, 0.190, 1e-3);
  EXPECT_NEAR(found.slip, 0.367, 1e-3);
  EXPECT_NEAR(found.backward, 0.087, 1e-3);
}

} // namespace asperity::contact::partial_slip_test
