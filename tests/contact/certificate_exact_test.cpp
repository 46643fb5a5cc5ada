// Tests of contact/certificate/certificate.hpp with closed forms: Westergaard's
// and Hertz's.
#include "contact/certificate/certificate.hpp"
#include "theory/exact/westergaard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/contact/problems.hpp"

namespace asperity::contact {
namespace {

/// The solution of the discrete problem, to 1e-11 h_rms.
double discrete_gap(FourierOperator& elasticity,
                    const std::vector<double>& heights, double load) {
  const ContactSolution exact = polonsky_keer(
      elasticity, {heights, 0.0, 1e-11 * problems::rms(heights), 50000},
      {mechanics::Control::nominal_pressure, load});
  EXPECT_TRUE(exact.converged) << exact.note;
  return exact.mean_gap;
}

// Verifies the bounds for Westergaard's pressure and mean gap on grids of 64 to
// 512 nodes per wavelength: they are no less than the distance from the
// discrete solution, and exceed it by no more than 1e-6 h_rms. The distance is
// at most 4 D/n^2 on n nodes.
TEST(ClosedForms, CertifyWestergaard) {
  constexpr double amplitude = 0.01;
  const theory::WestergaardContact wave(amplitude, 1.0, 1.0);
  for (const double share : {0.05, 0.4, 0.9}) {
    const double load = share * wave.full_contact_pressure();
    for (const int points : {64, 128, 256, 512}) {
      const Grid grid{points, 4, 1.0, 4.0 / points};
      std::vector<double> heights(grid.size()), pressure(grid.size());
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const double x =
            static_cast<double>(i % static_cast<std::size_t>(points)) / points;
        heights[i] = amplitude * std::cos(2.0 * std::numbers::pi * x);
        pressure[i] = wave.contact_pressure(x, load);
      }
      FourierOperator elasticity = halfspace_operator(
          grid, {1.0, 0.0, std::numeric_limits<double>::infinity()});
      const double rms = problems::rms(heights);
      const double error = std::abs(wave.mean_gap(load) -
                                    discrete_gap(elasticity, heights, load));

      const SubmittedField submitted{heights, 0.0, load, pressure,
                                     wave.mean_gap(load)};
      const SeparationBounds bounds = bound_separation(elasticity, submitted);

      EXPECT_GE(bounds.error, error - 1e-10 * rms) << points << " " << share;
      EXPECT_LE(bounds.error, error + 1e-6 * rms) << points << " " << share;
      EXPECT_GE(check_field(elasticity, submitted).mean_gap_error, error);
      EXPECT_LE(error, 4.0 * amplitude / (points * points)) << points;
    }
  }
}

// Hertz's pressure under a paraboloid in a periodic cell is not the solution,
// because of the periodic images. Verifies that the bounds enclose the
// solution.
TEST(ClosedForms, CertifyHertz) {
  const Grid grid{128, 128, 1.0, 1.0};
  constexpr double radius = 10.0;
  std::vector<double> heights(grid.size()), pressure(grid.size());
  for (const double contact_radius : {0.05, 0.15, 0.3}) {
    const double load = 4.0 * std::pow(contact_radius, 3) / (3.0 * radius);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double r = std::hypot(static_cast<double>(i % 128) / 128.0 - 0.5,
                                  static_cast<double>(i / 128) / 128.0 - 0.5);
      heights[i] = -r * r / (2.0 * radius);
      pressure[i] =
          1.5 * load / (std::numbers::pi * contact_radius * contact_radius) *
          std::sqrt(
              std::max(0.0, 1.0 - r * r / (contact_radius * contact_radius)));
    }
    FourierOperator elasticity = halfspace_operator(
        grid, {1.0, 0.0, std::numeric_limits<double>::infinity()});
    const double rms = problems::rms(heights);
    const double u = discrete_gap(elasticity, heights, load);
    const SubmittedField submitted{heights, 0.0, load, pressure};

    const FieldCheck check = check_field(elasticity, submitted);
    const SeparationBounds bounds = bound_separation(elasticity, submitted);

    EXPECT_LT(std::abs(check.load_error), 0.02);
    EXPECT_GT(check.duality_gap, 1e-6 * load * rms); // not the solution
    EXPECT_LE(bounds.low, u + 1e-10 * rms);
    EXPECT_GE(bounds.high, u - 1e-10 * rms);
    EXPECT_LT(bounds.high - bounds.low, 1e-6 * rms);
    EXPECT_GE(bounds.error, std::abs(check.mean_gap - u) - 1e-10 * rms);
    EXPECT_GE(check.mean_gap_error, std::abs(check.mean_gap - u));
  }
}

} // namespace
} // namespace asperity::contact
