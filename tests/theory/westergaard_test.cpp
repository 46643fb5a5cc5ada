// Tests of theory/exact/westergaard.hpp: pressure and gap must solve the
// contact problem, and every mean must be the mean of one of them.
#include "tests/message_of.hpp"
#include "theory/exact/westergaard.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace asperity::theory::westergaard_test {

using std::numbers::pi;

constexpr double amplitude = 2e-6, wavelength = 3e-4, modulus = 1.5e9;
const WestergaardContact wave(amplitude, wavelength, modulus);

// Mean over a period of f(x) cos(2 pi n x/lambda), on either side of the
// contact edge; x = end sin(angle) removes the square root at the edge.
template <class Function>
double mode(Function f, int n, double nominal_pressure) {
  const double half = 0.5 * wavelength;
  const double edge = half * wave.area_fraction(nominal_pressure);
  const auto integral_from = [&](double start, double to_edge) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double angle) {
          const double x = start + to_edge * std::sin(angle);
          return f(x) * std::cos(2.0 * pi * n * x / wavelength) *
                 std::abs(to_edge) * std::cos(angle);
        },
        0.0, 0.5 * pi, 6, 1e-13);
  };
  return (integral_from(0.0, edge) + integral_from(half, edge - half)) / half;
}

class WestergaardLoad : public ::testing::TestWithParam<double> {
protected:
  double pressure() const { return GetParam() * wave.full_contact_pressure(); }

  double pressure_mode(int n) const {
    return mode([&](double x) { return wave.contact_pressure(x, pressure()); },
                n, pressure());
  }

  double gap_mode(int n) const {
    return mode([&](double x) { return wave.gap(x, pressure()); }, n,
                pressure());
  }
};

// Pressure and gap solve the elastic problem: gap = const + u - h, and for the
// half-space u_n = 2 p_n/(E* q_n) in each mode. With p >= 0, gap >= 0 and p gap
// = 0 this is the entire contact problem. Tolerance: quadrature, 1e-10 of the
// amplitude (square roots at the edge).
TEST_P(WestergaardLoad, PressureAndGapSolveTheElasticProblem) {
  for (int n = 1; n <= 6; ++n) {
    const double q = 2.0 * pi * n / wavelength;
    const double displacement = 2.0 * pressure_mode(n) / (modulus * q);
    const double height = n == 1 ? 0.5 * amplitude : 0.0;

    EXPECT_NEAR(gap_mode(n), displacement - height, 1e-10 * amplitude)
        << "mode " << n;
  }
  for (int i = 0; i <= 50; ++i) {
    const double x = wavelength * i / 50.0;
    const double force = wave.contact_pressure(x, pressure());
    const double gap = wave.gap(x, pressure());
    EXPECT_GE(force, 0.0);
    EXPECT_GE(gap, 0.0);
    EXPECT_EQ(force * gap, 0.0);
  }
}

// The closed means are the means of the profiles.
TEST_P(WestergaardLoad, MeansAreThoseOfTheProfiles) {
  EXPECT_NEAR(pressure_mode(0) / pressure(), 1.0, 1e-10);
  EXPECT_NEAR(gap_mode(0), wave.mean_gap(pressure()), 1e-10 * amplitude);
}

// Verifies -dU/dg = p, which with U(0) = 0 defines the energy, and the
// stiffness -dp/dg. Reference: central differences of relative step 1e-4, error
// of order 1e-8.
TEST_P(WestergaardLoad, StiffnessAndEnergyAreDerivatives) {
  const double low = pressure() * (1.0 - 1e-4);
  const double high = pressure() * (1.0 + 1e-4);
  if (high >= wave.full_contact_pressure())
    GTEST_SKIP() << "the gap is 0 on one side";

  const double fall = wave.mean_gap(low) - wave.mean_gap(high);

  EXPECT_NEAR((wave.elastic_energy(high) - wave.elastic_energy(low)) / fall /
                  pressure(),
              1.0, 1e-6);
  EXPECT_NEAR((high - low) / fall / wave.contact_stiffness(pressure()), 1.0,
              1e-6);
}

INSTANTIATE_TEST_SUITE_P(Sweep, WestergaardLoad,
                         ::testing::Values(0.02, 0.3, 0.7, 0.95, 1.0, 1.5));

// The series near full contact continues the closed form. Tolerance: the closed
// form's roundoff, eps D, where they meet, and D 1e-15/12 from there.
TEST(Westergaard, MeanGapIsContinuous) {
  for (const double ratio : {0.899999, 0.9, 0.900001, 0.97}) {
    const double closed = 1.0 - ratio + ratio * std::log(ratio);
    const double gap = wave.mean_gap(ratio * wave.full_contact_pressure());

    EXPECT_NEAR(gap / amplitude, closed, 4e-16);
  }
}

TEST(Westergaard, HasItsLimitsAtZeroAndFullContact) {
  const double full = wave.full_contact_pressure();
  EXPECT_EQ(wave.area_fraction(0.0), 0.0);
  EXPECT_EQ(wave.mean_gap(0.0), amplitude);
  EXPECT_EQ(wave.elastic_energy(0.0), 0.0);
  EXPECT_EQ(wave.contact_stiffness(0.0), 0.0);
  EXPECT_NEAR(wave.gap(0.25 * wavelength, 0.0), amplitude, 1e-20);
  EXPECT_EQ(wave.area_fraction(full), 1.0);
  EXPECT_EQ(wave.mean_gap(2.0 * full), 0.0);
  EXPECT_GT(wave.contact_stiffness(2.0 * full),
            std::numeric_limits<double>::max());
}

TEST(WestergaardInput, RefusesBadArgumentsByName) {
  EXPECT_TRUE(tests::message_of<std::domain_error>([] {
                wave.mean_gap(-1.0);
              }).starts_with("nominal_pressure = -1"));
  EXPECT_THROW(WestergaardContact(0.0, 1.0, 1.0), std::domain_error);
  EXPECT_THROW(WestergaardContact(1.0, 0.0, 1.0), std::domain_error);
  EXPECT_THROW(WestergaardContact(1.0, 1.0, -1.0), std::domain_error);
}

} // namespace asperity::theory::westergaard_test
