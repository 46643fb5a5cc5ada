// The traction of mechanics/partial_slip.hpp, from two normal contacts, under
// the tangential compliance of a half-space:
//     (2/(E* (1 - nu) |k|)) [1 - nu k k^T/|k|^2].
#include "contact/operators/fourier_operator.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/operators/wave_directions.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/punch_stiffness.hpp"
#include "mechanics/partial_slip.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

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

  FourierOperator elasticity = problems::unit_halfspace(grid);
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

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// kappa along x and y of a block on a rigid surface, of a contact that sticks.
mechanics::Directions ratios_of(SurfaceOperator& elasticity,
                                const std::vector<std::uint8_t>& contact,
                                double poisson) {
  const mechanics::MaterialSpec material{.contact_modulus = 1.0,
                                         .poisson_ratio = poisson};
  const PunchStiffness punch = punch_stiffness(elasticity, contact);
  EXPECT_TRUE(punch.converged);
  const double along = energy_along_x(elasticity.grid(), punch.pressure,
                                      elasticity.is_periodic());
  const double turned =
      mechanics::tangential_anisotropy(material) * (along - 0.5);
  const double mean = mechanics::tangential_ratio(material);
  return {mean - turned, mean + turned};
}

template <class IsInside>
std::vector<std::uint8_t> set_of(const Grid& of, const IsInside& is_inside) {
  std::vector<std::uint8_t> set(of.size());
  for (int iy = 0; iy < of.points_y; ++iy)
    for (int ix = 0; ix < of.points_x; ++ix)
      set[of.index(ix, iy)] =
          is_inside((ix + 0.5) * of.spacing_x() - 0.5 * of.length_x,
                    (iy + 0.5) * of.spacing_y() - 0.5 * of.length_y)
              ? 1
              : 0;
  return set;
}

/// Two tractions, along x and along y.
using Tractions = std::pair<std::vector<double>, std::vector<double>>;

/// The complete compliance: displacements along x and y of both tractions.
Tractions displacements_of(const Tractions& tractions, double poisson) {
  const Shear of_x = shear_of(tractions.first, poisson);
  std::vector<double> turned(grid.size());
  const auto turn = [&](const std::vector<double>& field) {
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix)
        turned[grid.index(ix, iy)] = field[grid.index(iy, ix)];
    return turned;
  };
  const Shear of_y = shear_of(turn(tractions.second), poisson);
  Tractions found{of_x.along, of_x.across};
  turn(of_y.across);
  for (std::size_t i = 0; i < grid.size(); ++i)
    found.first[i] += turned[i];
  turn(of_y.along);
  for (std::size_t i = 0; i < grid.size(); ++i)
    found.second[i] += turned[i];
  return found;
}

/// The tangential compliance along x of nodes that stick, over their normal
/// one, by conjugate gradients for both components of their traction, of which
/// the mean is (1, 0).
double complete_ratio(SurfaceOperator& elasticity,
                      const std::vector<std::uint8_t>& contact,
                      double poisson) {
  const auto count =
      static_cast<double>(std::ranges::count(contact, std::uint8_t{1}));
  const auto project = [&](std::vector<double>& field) {
    double mean = 0.0;
    for (std::size_t i = 0; i < field.size(); ++i)
      mean += contact[i] != 0 ? field[i] / count : 0.0;
    for (std::size_t i = 0; i < field.size(); ++i)
      field[i] = contact[i] != 0 ? field[i] - mean : 0.0;
  };
  const auto dot = [](const Tractions& a, const Tractions& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.first.size(); ++i)
      sum += a.first[i] * b.first[i] + a.second[i] * b.second[i];
    return sum / static_cast<double>(a.first.size());
  };
  const auto add = [](Tractions& to, double factor, const Tractions& field) {
    for (std::size_t i = 0; i < to.first.size(); ++i) {
      to.first[i] += factor * field.first[i];
      to.second[i] += factor * field.second[i];
    }
  };
  Tractions q{std::vector<double>(grid.size()),
              std::vector<double>(grid.size())};
  for (std::size_t i = 0; i < grid.size(); ++i)
    q.first[i] =
        contact[i] != 0 ? static_cast<double>(grid.size()) / count : 0.0;
  const auto residual_of = [&](Tractions field) {
    project(field.first);
    project(field.second);
    return field;
  };
  Tractions residual = residual_of(displacements_of(q, poisson));
  for (auto* part : {&residual.first, &residual.second})
    for (double& value : *part)
      value = -value;
  Tractions direction = residual;
  double square = dot(residual, residual);
  const double first = square;
  for (int n = 0; n < 400 && square > 1e-16 * first; ++n) {
    const Tractions product = residual_of(displacements_of(direction, poisson));
    const double length = square / dot(direction, product);
    add(q, length, direction);
    add(residual, -length, product);
    const double next = dot(residual, residual);
    Tractions old = std::exchange(direction, residual);
    add(direction, next / square, old);
    square = next;
  }
  EXPECT_LE(square, 1e-16 * first);
  const PunchStiffness punch = punch_stiffness(elasticity, contact);
  return dot(q, displacements_of(q, poisson)) * punch.stiffness;
}

} // namespace

// Strips, and an ellipse of 1:2 on a free surface, have tractions of the form
// of the normal pressure and thus kappa of a closed form: 1 across strips and
// 1/(1 - nu) along them for any nu; for an ellipse by the mean of the
// directions of its waves, with weights 1/sqrt(a^2 cos^2 + b^2 sin^2).
TEST(StickingContact, HasTheRatiosOfItsShape) {
  FourierOperator periodic = problems::unit_halfspace(grid);
  const auto strips =
      set_of(grid, [](double x, double) { return std::abs(x) < 0.2; });
  for (const double nu : {0.0, 0.3, 0.5}) {
    const mechanics::Directions of_strips = ratios_of(periodic, strips, nu);
    EXPECT_NEAR(of_strips.x, 1.0, 1e-12);
    EXPECT_NEAR(of_strips.y, 1.0 / (1.0 - nu), 1e-12);
  }
  FourierOperator free = free_halfspace(grid, 1.0);
  for (const double aspect : {1.0, 2.0}) {
    const auto ellipse = set_of(grid, [aspect](double x, double y) {
      return std::hypot(aspect * x, y) < 0.4;
    });
    double weights = 0.0, along = 0.0;
    for (int n = 0; n < 1000; ++n) {
      const double angle = std::numbers::pi * (n + 0.5) / 1000.0;
      const double cosine = std::cos(angle), sine = std::sin(angle);
      const double weight = 1.0 / std::hypot(cosine / aspect, sine);
      weights += weight;
      along += weight * cosine * cosine;
    }
    for (const double nu : {0.0, 0.3, 0.5}) {
      const mechanics::Directions found = ratios_of(free, ellipse, nu);
      const double exact = (1.0 - nu * along / weights) / (1.0 - nu);
      EXPECT_NEAR(found.x, exact, aspect == 1.0 ? 1e-12 : 2e-3) << aspect << nu;
      EXPECT_NEAR(found.x + found.y, (2.0 - nu) / (1.0 - nu), 1e-12);
    }
  }
}

// What remains: the traction of nodes that stick is that of a normal punch,
// without one across, and the true ones have less energy. The errors are those
// of docs/numerics/friction.md, beside those of Mindlin's ratio.
TEST(StickingContact, RemainsWithoutTheTractionAcross) {
  FourierOperator elasticity = problems::unit_halfspace(grid);
  LoadSequence path(elasticity.clone(), problems::rough_heights(grid, {}), {},
                    1e-9, 1000);

  struct Errors {
    double load, area, poisson, own, mean;
  };

  for (const Errors& expected : {Errors{0.06, 0.138, 0.3, 0.007, 0.009},
                                 Errors{0.06, 0.138, 0.5, 0.026, 0.030},
                                 Errors{0.2, 0.406, 0.3, 0.013, 0.028},
                                 Errors{0.2, 0.406, 0.5, 0.051, 0.080},
                                 Errors{0.4, 0.664, 0.3, 0.018, 0.028},
                                 Errors{0.4, 0.664, 0.5, 0.070, 0.089}}) {
    const ContactSolution found =
        path.solve({mechanics::Control::nominal_pressure, expected.load});
    std::vector<std::uint8_t> contact(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i)
      contact[i] = found.pressure[i] > 0.0 ? 1 : 0;
    EXPECT_NEAR(
        static_cast<double>(std::ranges::count(contact, std::uint8_t{1})) /
            static_cast<double>(grid.size()),
        expected.area, 5e-4);
    const double nu = expected.poisson;
    const double own = ratios_of(elasticity, contact, nu).x;
    const double exact = complete_ratio(elasticity, contact, nu);
    EXPECT_GE(own, exact); // it is an upper bound
    EXPECT_NEAR(own / exact - 1.0, expected.own, 1e-3);
    EXPECT_NEAR((2.0 - nu) / (2.0 - 2.0 * nu) / exact - 1.0, expected.mean,
                1e-3);
  }
}

} // namespace asperity::contact::partial_slip_test
