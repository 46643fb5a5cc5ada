// Tests of contact/certificate/certificate.hpp with closed forms:
// Westergaard's, and full contact, whose heights are the displacement of its
// pressure.
#include "contact/certificate/certificate.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "tests/contact/problems.hpp"
#include "theory/exact/westergaard.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace asperity::contact::certificate_exact_test {

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
      FourierOperator elasticity = problems::unit_halfspace(grid);
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

/// Surfaces that are in full contact at load 1 under a pressure that is 0 at
/// one node: the least one of full contact, where neither the pressure nor the
/// gap tells which nodes are in contact.
struct FullContact {
  const char* name;
  std::unique_ptr<SurfaceOperator> elasticity;
  std::vector<double> pressure{}, heights{};
};

std::vector<FullContact> full_contacts() {
  const auto half_space = [](const Grid& grid, double thickness) {
    return std::make_unique<FourierOperator>(
        halfspace_operator(grid, {1.0, 0.3, thickness}));
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Grid strip{64, 4, 1.0, 1.0 / 16.0}, square{32, 32, 1.0, 1.0};
  std::vector<FullContact> all;
  all.push_back({"wave-1d 16", half_space({16, 4, 1.0, 0.25}, infinity)});
  all.push_back({"wave-1d 64", half_space(strip, infinity)});
  all.push_back(
      {"wave-1d 512", half_space({512, 4, 1.0, 1 / 128.0}, infinity)});
  all.push_back({"wave-2d", half_space(square, infinity)});
  all.push_back({"thin slab", half_space(square, 0.05)});
  all.push_back({"free", free_halfspace(square, 1.0).clone()});
  for (FullContact& one : all) {
    const Grid& grid = one.elasticity->grid();
    for (int y = 0; y < grid.points_y; ++y)
      for (int x = 0; x < grid.points_x; ++x)
        one.pressure.push_back(
            1.0 + std::cos(2.0 * std::numbers::pi * x / grid.points_x) *
                      (grid.points_y == 4 ? 1.0
                                          : std::cos(2.0 * std::numbers::pi *
                                                     y / grid.points_y)));
    one.heights.resize(grid.size());
    one.elasticity->displacement(one.pressure, one.heights);
  }
  return all;
}

/// The pressure itself, and wrong ones.
std::vector<std::vector<double>> submissions(const std::vector<double>& exact) {
  const std::vector<double> random = problems::random_field(exact.size());
  std::vector<std::vector<double>> all(6, exact);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    all[1][i] *= 1.0 + 1e-6 * random[i];
    all[2][i] += 0.3 * random[i]; // with tension
    all[3][i] = exact[(i + 1) % exact.size()];
    all[4][i] = 1.0;
    all[5][i] = i == 0 ? 1.0 : 0.0;
  }
  return all;
}

// Verifies the bounds about the load of first full contact: they enclose the
// mean gap, which is 0 from there on, for the exact pressure and for wrong
// ones, and are closer than 1e-6 h_rms. Tolerance: that of the reference
// solution.
TEST(ClosedForms, CertifyFullContactAndLessThanThat) {
  for (FullContact& one : full_contacts()) {
    const double rms = problems::rms(one.heights);
    for (const double load : {0.9, 0.99, 0.999, 1.0 - 1e-5, 1.0 - 1e-8, 1.0,
                              1.0 + 1e-12, 1.0 + 1e-6, 1.01, 3.0}) {
      ContactSolution exact;
      exact.pressure = one.pressure;
      if (load > 1.0 && one.elasticity->is_periodic())
        for (double& value : exact.pressure)
          value += load - 1.0;
      else if (load != 1.0)
        exact = polonsky_keer(*one.elasticity,
                              {one.heights, 0.0, 1e-12 * rms, 50000},
                              {mechanics::Control::nominal_pressure, load});
      const double u = exact.mean_gap;
      for (const std::vector<double>& pressure : submissions(exact.pressure)) {
        SCOPED_TRACE(fmt::format("{} {} {}", one.name, load, pressure[1]));
        const SubmittedField field{one.heights, 0.0, load, pressure};

        const FieldCheck check = check_field(*one.elasticity, field);
        const SeparationBounds bounds =
            bound_separation(*one.elasticity, field);

        EXPECT_LE(std::abs(check.mean_gap - u),
                  check.mean_gap_error + 1e-11 * rms);
        EXPECT_LE(bounds.low, u + 1e-11 * rms);
        EXPECT_GE(bounds.high, u - 1e-11 * rms);
        EXPECT_LT(bounds.high - bounds.low, 1e-6 * rms);
      }
    }
  }
}

} // namespace asperity::contact::certificate_exact_test
