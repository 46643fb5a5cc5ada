// Tests of the numbers of the cases in cases/: exact references follow from the
// numbers of their case.
#include "input/reader/read_case.hpp"
#include "input/types/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace asperity::cases::shipped_references_test {

constexpr double pi = std::numbers::pi;

Case shipped_case(const std::string& name) {
  return read_case("cases/" + name + "/case.toml");
}

double reference_of(const std::string& name, const std::string& quantity) {
  for (const ReferenceValue& reference :
       read_reference("cases/" + name + "/reference.csv"))
    if (reference.quantity == quantity)
      return reference.value;
  ADD_FAILURE() << name << " has no reference " << quantity;
  return NAN;
}

double pressure_of(const Case& read, std::size_t step) {
  return read.load.targets.at(step).in_si(
      {.contact_modulus = read.material.contact_modulus});
}

// The cut-offs of the polymer are 2, 4.5 and 128 times 2 pi / 10 um, those of
// the nominal one 1, 5.88 and 128. Tolerance: the 16 digits written.
TEST(ShippedReferences, HaveThePolymersSpectra) {
  const double unit = 2.0 * pi / 10e-6;
  const mechanics::SurfaceSpec surrogate = shipped_case("polymer").surface;
  const mechanics::SurfaceSpec nominal =
      shipped_case("polymer-nominal").surface;

  EXPECT_NEAR(surrogate.wavevector_low / unit, 2.0, 1e-14);
  EXPECT_NEAR(surrogate.wavevector_roll_off / unit, 4.5, 1e-14);
  EXPECT_NEAR(surrogate.wavevector_high / unit, 128.0, 1e-12);
  EXPECT_NEAR(nominal.wavevector_low / unit, 1.0, 1e-14);
  EXPECT_NEAR(nominal.wavevector_roll_off / unit, 5.88, 1e-14);
  EXPECT_NEAR(nominal.wavevector_high / unit, 128.0, 1e-12);
}

// a^3 = 3 F R / (4 E*) at the loads of the case. Tolerance: roundoff.
TEST(ShippedReferences, GiveHertzsReferences) {
  const Case hertz = shipped_case("hertz");
  const double area = *hertz.surface.length * *hertz.surface.length;
  const std::size_t last = hertz.load.targets.size() - 1;
  for (const auto& [step, name] :
       {std::pair<std::size_t, std::string>{0, "first_step"},
        std::pair<std::size_t, std::string>{last, "last_step"}}) {
    const double radius =
        std::cbrt(0.75 * pressure_of(hertz, step) * area *
                  hertz.surface.radius / hertz.material.contact_modulus);

    EXPECT_NEAR(reference_of("hertz", "contact_radius_" + name) / radius, 1.0,
                1e-14);
    EXPECT_NEAR(reference_of("hertz", "approach_" + name) /
                    (radius * radius / hertz.surface.radius),
                1.0, 1e-14);
  }
}

// The mean gaps of board/hertz are those of a paraboloid in a square array,
// crest minus a^2/R' - F/(pi E* L) (S - T a^2/(10 L^2)), with the crest and the
// rms height of the case's nodes and 1/R' = 1/R + T F/(2 pi E* L^3). Tolerance:
// the six decimals written.
TEST(ShippedReferences, GiveTheMeanGapsOfTheSquareArray) {
  const Case read = shipped_case("board/hertz");
  const mechanics::SurfaceSpec& surface = read.surface;
  const double side = *surface.length, modulus = read.material.contact_modulus;
  double square = 0.0, fourth = 0.0; // means of x^2 and x^4
  const int n = *surface.points;
  for (int i = 0; i < n; ++i) {
    const double x = side * (static_cast<double>(i) / n - 0.5);
    square += x * x / n;
    fourth += x * x * x * x / n;
  }
  const double crest = square / surface.radius;
  const double rms_height =
      std::sqrt((fourth - square * square) / 2.0) / surface.radius;
  constexpr double s = 3.9002649200019564, t = 9.03362168310095;

  for (const auto& [step, load] :
       {std::pair<std::size_t, std::string>{1, "10 kPa"},
        std::pair<std::size_t, std::string>{3, "300 kPa"}}) {
    const double displacement = // F/(pi E* L)
        pressure_of(read, step) * side / (pi * modulus);
    const double radius =
        1.0 / (1.0 / surface.radius + 0.5 * t * displacement / (side * side));
    const double a = std::cbrt(0.75 * pi * displacement * side * radius);
    const double approach =
        a * a / radius - displacement * (s - t * a * a / (10.0 * side * side));

    EXPECT_NEAR(reference_of("board/hertz", "reduced_mean_gap@p=" + load),
                (crest - approach) / rms_height, 1e-6);
  }
}

// The loads of the waves are P = 0.01 to 0.95 of the pressure of full contact.
TEST(ShippedReferences, LoadTheWavesFromOneToNinetyFivePerCent) {
  for (const std::string name : {"wave-1d", "wave-2d"}) {
    const Case wave = shipped_case(name);
    const double full_contact = (name == "wave-1d" ? 1.0 : std::sqrt(2.0)) *
                                pi * wave.material.contact_modulus *
                                wave.surface.amplitude /
                                wave.surface.wavelength;

    EXPECT_NEAR(pressure_of(wave, 0) / full_contact, 0.01, 1e-15);
    EXPECT_NEAR(pressure_of(wave, 11) / full_contact, 0.95, 1e-13);
  }
}

TEST(ShippedReferences, GiveTheWavesReferences) {
  for (const auto& [reduced_pressure, digits] :
       {std::pair<double, std::string>{0.01, "0.01"},
        std::pair<double, std::string>{0.5, "0.5"},
        std::pair<double, std::string>{0.95, "0.95"}}) {
    const std::string end = "_at_reduced_pressure_" + digits;

    // sin^2 of a quarter turn times the fraction is P: the formula inverted.
    const double fraction = reference_of("wave-1d", "area_fraction" + end);
    EXPECT_NEAR(std::pow(std::sin(pi / 2.0 * fraction), 2), reduced_pressure,
                1e-15);
    // The gap is the integral of -ln from P to 1: -dg/dP = -ln P, g(1) = 0.
    const double gap = reference_of("wave-1d", "mean_gap_over_amplitude" + end);
    double sum = 0.0;
    const int n_steps = 20000; // midpoint rule: error 1e-6 at P = 0.01
    const double step = (1.0 - reduced_pressure) / n_steps;
    for (int i = 0; i < n_steps; ++i)
      sum -= std::log(reduced_pressure + (i + 0.5) * step) * step;
    EXPECT_NEAR(gap, sum, 1e-6);
  }
}

} // namespace asperity::cases::shipped_references_test
