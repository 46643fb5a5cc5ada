// Tests of theory/persson/height_spectrum.hpp: moments, nodes, cuts, refusals.
#include "tests/message_of.hpp"
#include "tests/theory/spectra.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::theory::height_spectrum_test {

using std::numbers::pi;

double node_sum(const HeightSpectrum& spectrum, auto function) {
  double sum = 0.0;
  for (const RoughnessNode& node : spectrum.nodes())
    sum += node.weight * function(node.root_moment);
  return sum;
}

// Verifies the moments of a self-affine formula against its antiderivatives.
// Tolerance: some 50 eps for a thousand positive terms.
TEST(FormulaSpectrum, HasTheMomentsOfItsAntiderivatives) {
  const SelfAffine shape = surface_of_the_paper();

  const HeightSpectrum spectrum = shape.spectrum();

  const ProfileMoments& moments = spectrum.profile_moments();
  const double end = shape.high;
  EXPECT_NEAR(spectrum.rms_height() / 1e-9, 1.0, 1e-14);
  EXPECT_NEAR(moments.slope / (pi * shape.moment(end, 3)), 1.0, 1e-14);
  EXPECT_NEAR(moments.curvature / (0.75 * pi * shape.moment(end, 5)), 1.0,
              1e-14);
  EXPECT_NEAR(spectrum.full_contact_moment() / shape.moment(end, 2), 1.0,
              1e-14);
  EXPECT_NEAR(spectrum.rms_slope(), std::sqrt(2.0 * moments.slope), 1e-15);
}

// Verifies that the nodes integrate over q for functions as different as those
// of the theory: a power, a logarithm, an essential singularity. Reference:
// tanh-sinh over q with M in closed form. Tolerance: its own.
TEST(FormulaSpectrum, NodesIntegrateSmoothFunctionsOfTheSlope) {
  const SelfAffine shape = surface_of_the_paper();
  const HeightSpectrum spectrum = shape.spectrum();
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto over_wavevectors = [&](auto function) {
    const auto integrand = [&](double t) { // q = q_L + t^2
      const double q = shape.low + t * t;
      const double root = std::sqrt(shape.moment_over(t * t, 3));
      return root > 0.0 ? 2.0 * t * q * q * shape(q) / root * function(root)
                        : 0.0;
    };
    const double kink = std::sqrt(shape.roll_off - shape.low);
    const double end = std::sqrt(shape.high - shape.low);
    return quadrature.integrate(integrand, 0.0, kink, 1e-14) +
           quadrature.integrate(integrand, kink, end, 1e-14);
  };
  const auto agree = [&](auto function) {
    EXPECT_NEAR(node_sum(spectrum, function) / over_wavevectors(function), 1.0,
                1e-13);
  };
  agree([](double m) { return m; });
  agree([](double m) { return m * std::log(m); });
  agree([](double m) { return std::exp(-1e-3 / (m * m)); });
  agree([](double) { return 1.0; });
  agree([](double m) { return std::log(m); });
}

// The steps of 1/q sum to its total decrease, over a gap in the spectrum too,
// and the density is the formula inside q_L..q_1 and 0 outside. Tolerance:
// roundoff of some thousand positive terms.
TEST(FormulaSpectrum, StepsOfInverseWavevectorsSumUp) {
  const HeightSpectrum spectrum(
      SpectrumFormula{[](double q) { return q < 2e7 || q > 5e7 ? 1e-40 : 0.0; },
                      {1e7, 2e7, 5e7, 9e7}});
  double sum = 0.0;
  for (const RoughnessNode& node : spectrum.nodes())
    sum += node.inverse_step;

  EXPECT_NEAR(sum / (1.0 / 1e7 - 1.0 / 9e7), 1.0, 1e-13);
  EXPECT_TRUE(spectrum.has_density());
  EXPECT_EQ(spectrum.density(1.5e7), 1e-40);
  EXPECT_EQ(spectrum.density(3e7), 0.0);
  EXPECT_EQ(spectrum.density(9.1e7), 0.0);
  EXPECT_EQ(spectrum.breaks().size(), 4u);
  EXPECT_TRUE(spectrum.shells().empty());
}

// Shells have no density; they are stored in ascending order without the empty
// ones.
TEST(ShellSpectrum, KeepsItsShellsAndHasNoDensity) {
  const HeightSpectrum spectrum(
      std::vector<SpectrumShell>{{3e7, 1e-18}, {2e7, 0.0}, {1e7, 2e-18}});

  EXPECT_FALSE(spectrum.has_density());
  EXPECT_THROW(spectrum.density(1e7), std::domain_error);
  EXPECT_TRUE(spectrum.breaks().empty());
  ASSERT_EQ(spectrum.shells().size(), 2u);
  EXPECT_EQ(spectrum.shells()[0].wavevector, 1e7);
  EXPECT_EQ(spectrum.shells()[1].mean_square_height, 1e-18);
}

// For shells the nodes integrate the staircase exactly: powers of m are summed
// step by step. Tolerance: cancellation of 20 Legendre moments, measured below
// 5e-15.
TEST(ShellSpectrum, NodesIntegrateTheStaircaseItself) {
  std::vector<SpectrumShell> shells;
  for (int i = 0; i < 300; ++i) // unordered, irregular, some without roughness
    shells.push_back({1e6 * (1.0 + (i * 37) % 300),
                      i % 7 == 0 ? 0.0 : 1e-18 / (1.0 + (i * 11) % 23)});
  const HeightSpectrum spectrum(shells);

  double mean_square = 0.0, mean_square_slope = 0.0;
  for (const SpectrumShell& shell : shells) {
    mean_square += shell.mean_square_height;
    mean_square_slope +=
        shell.mean_square_height * shell.wavevector * shell.wavevector;
  }
  EXPECT_NEAR(spectrum.rms_height() / std::sqrt(mean_square), 1.0, 1e-14);
  EXPECT_NEAR(spectrum.rms_slope() / std::sqrt(mean_square_slope), 1.0, 1e-14);
  for (const int power : {0, 1, 2, 5}) {
    double steps = 0.0, moment = 0.0; // int 2 m^power dm/q
    for (int i = 0; i < 300; ++i) {
      for (const SpectrumShell& shell : shells) {
        if (shell.wavevector != 1e6 * (1.0 + i))
          continue;
        const double before = std::sqrt(moment);
        moment += shell.wavevector * shell.wavevector *
                  shell.mean_square_height / (2.0 * pi);
        steps += 2.0 / shell.wavevector *
                 (std::pow(std::sqrt(moment), power + 1) -
                  std::pow(before, power + 1)) /
                 (power + 1);
      }
    }
    EXPECT_NEAR(
        node_sum(spectrum, [&](double m) { return std::pow(m, power); }) /
            steps,
        1.0, 2e-14)
        << "power " << power;
  }
}

// The roughness below and above a magnification sums to the total, for a
// formula and for shells.
TEST(SpectrumCut, LosesNoRoughness) {
  const SelfAffine shape = surface_of_the_paper();
  const std::vector<SpectrumShell> shells = {
      {1e8, 1e-18}, {2e8, 3e-19}, {4e8, 1e-19}};
  const double inf = std::numeric_limits<double>::infinity();
  for (const HeightSpectrum& whole : {shape.spectrum(), HeightSpectrum(shells)})
    for (const double wavevector : {1.2e8, 1.81e8, 2e8, 3e8}) {
      const HeightSpectrum below = whole.between(0.0, wavevector);
      const HeightSpectrum above = whole.between(wavevector, inf);

      EXPECT_NEAR(std::hypot(below.rms_slope(), above.rms_slope()) /
                      whole.rms_slope(),
                  1.0, 1e-14);
      EXPECT_LE(below.wavevector_high(), wavevector);
      EXPECT_GE(above.wavevector_low(), wavevector);
    }
}

// A formula that is zero up to a break begins there.
TEST(FormulaSpectrum, MayBeginWithoutRoughness) {
  const auto step = [](double q) { return q < 2.0 ? 0.0 : 1.0; };

  const HeightSpectrum spectrum(SpectrumFormula{step, {1.0, 2.0, 3.0}});

  EXPECT_EQ(spectrum.wavevector_low(), 2.0);
  // int_2^3 q^2 C dq by its antiderivative, and by the nodes.
  EXPECT_NEAR(spectrum.full_contact_moment(), 19.0 / 3.0, 1e-13);
  EXPECT_NEAR(node_sum(spectrum, [](double m) { return m; }), 19.0 / 3.0,
              1e-13);
}

// A table that is interpolated linearly in ln q and ln C, with a break at each
// of its rows, reproduces the power law that it samples. Tolerance: roundoff of
// a thousand panels.
TEST(FormulaSpectrum, MayBeATableOfManyRows) {
  const SelfAffine shape{0.7, 1e6, 1e6, 1e8, 1e-30};
  const int n_rows = 500;
  std::vector<double> rows;
  for (int i = 0; i <= n_rows; ++i)
    rows.push_back(shape.low * std::pow(shape.high / shape.low,
                                        static_cast<double>(i) / n_rows));
  const auto joined = [&](double q) {
    const auto after = std::upper_bound(rows.begin() + 1, rows.end() - 1, q);
    const double high = *after, low = *(after - 1);
    const double part = std::log(q / low) / std::log(high / low);
    return std::exp((1.0 - part) * std::log(shape(low)) +
                    part * std::log(shape(high)));
  };

  const HeightSpectrum table(SpectrumFormula{joined, rows});

  const HeightSpectrum formula = shape.spectrum();
  EXPECT_NEAR(table.rms_slope() / formula.rms_slope(), 1.0, 1e-13);
  const auto bump = [](double m) { return std::exp(-1e-3 / (m * m)); };
  EXPECT_NEAR(node_sum(table, bump) / node_sum(formula, bump), 1.0, 1e-13);
}

std::string complaint_about(auto source) {
  return tests::message_of<std::domain_error>(
      [&] { HeightSpectrum spectrum(source); });
}

TEST(SpectrumInput, IsRefusedByName) {
  const auto flat = [](double) { return 1.0; };
  const auto negative = [](double) { return -1.0; };
  const auto empty = [](double) { return 0.0; };
  using Shells = std::vector<SpectrumShell>;

  EXPECT_TRUE(complaint_about(SpectrumFormula{flat, {1.0}})
                  .starts_with("number of breaks = 1"));
  EXPECT_TRUE(complaint_about(SpectrumFormula{flat, {1.0, 3.0, 2.0}})
                  .starts_with("breaks[2] = 2"));
  EXPECT_TRUE(complaint_about(SpectrumFormula{negative, {1.0, 2.0}})
                  .starts_with("height_spectrum = -1"));
  EXPECT_TRUE(complaint_about(SpectrumFormula{empty, {1.0, 2.0}})
                  .starts_with("rms_slope of the spectrum = 0"));
  EXPECT_TRUE(complaint_about(Shells{{0.0, 1.0}})
                  .starts_with("wavevector of a shell = 0"));
  EXPECT_TRUE(complaint_about(Shells{{1.0, -1.0}})
                  .starts_with("mean_square_height of a shell = -1"));
  EXPECT_TRUE(complaint_about(Shells{{1.0, 0.0}})
                  .starts_with("number of shells with roughness = 0"));
}

} // namespace asperity::theory::height_spectrum_test
