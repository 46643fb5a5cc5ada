// A contact law of one object: docs/extending.md. It is in the list while the
// object exists, and cases, solver, energy and loads know it from there.
#include "contact/solvers/load_sequence.hpp"
#include "input/reader/case_schema.hpp"
#include "input/reader/read_case.hpp"
#include "tests/contact/power_law.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity::contact::toy_law_test {

using mechanics::ContactInterface;

mechanics::ContactLawTraits parabolic() {
  return tests::power_law<2>("parabolic");
}

constexpr const char* text = R"(schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 64
seed = 5
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "1 length"
wavelength_short = "8 h"
[material]
youngs_modulus = "1 GPa"
poisson_ratio = 0
[load]
nominal_pressure = ["10 MPa", 0]
[halfspace]
contact = "parabolic"
work_of_adhesion = "20 mJ/m^2"
tolerance = 1e-10
)";

class ToyLaw : public testing::Test {
protected:
  mechanics::RegisteredLaw law_{parabolic()};
};

TEST_F(ToyLaw, IsListedWhileItExists) {
  const std::size_t n = mechanics::contact_laws().size();
  {
    const mechanics::RegisteredLaw second(parabolic());
    EXPECT_EQ(mechanics::contact_laws().size(), n + 1);
  }

  EXPECT_EQ(mechanics::contact_laws().size(), n);
  EXPECT_STREQ(mechanics::contact_law_names().back(), "parabolic");
  EXPECT_STREQ(mechanics::traits_of(law_).name, "parabolic");
  EXPECT_TRUE(mechanics::is_adhesive(law_));
  EXPECT_NE(cases::json_schema().find("\"parabolic\""), std::string::npos);
}

// The conditions of a minimum, with the law of a case: where the gap is open
// the pressure is that of the law, where it is closed at least that. Tolerance:
// that of the gap, times the stiffness of the shortest waves, pi E*/h.
TEST_F(ToyLaw, IsReadAndSolvedLikeAnyOther) {
  const cases::Case read = cases::read_case_text(text, "case.toml");
  const mechanics::ContactSettings& settings = *read.methods.at(0).contact();
  ASSERT_EQ(settings.law, static_cast<mechanics::ContactLaw>(law_));
  const double length = 1e-6, modulus = read.material.contact_modulus;
  const Grid grid{64, 64, length, length};
  std::vector<double> heights = problems::rough_heights(grid, {});
  for (double& height : heights)
    height *= 0.1;
  const double rms = problems::rms(heights);
  const ContactInterface law = settings.in_si({.contact_modulus = modulus,
                                               .length = length,
                                               .spacing = grid.spacing_x(),
                                               .rms_height = rms});
  FourierOperator elasticity =
      halfspace_operator(grid, mechanics::halfspace(modulus));
  LoadSequence path(elasticity.clone(), heights, law, settings.tolerance * rms,
                    settings.max_iterations);
  for (const mechanics::Quantity& load : read.load.targets) {
    const ContactSolution found =
        path.solve({mechanics::Control::nominal_pressure, load.value});

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_GT(found.smallest_stiffness, 0.0);
    EXPECT_NEAR(found.nominal_pressure, load.value, found.load_tolerance);
    const double tolerance =
        10.0 * settings.tolerance * rms * modulus / grid.spacing_x();
    std::size_t closed = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      closed += found.gap[i] <= 0.0 ? 1 : 0;
      if (found.gap[i] > 0.0)
        ASSERT_NEAR(found.pressure[i], law.pressure(found.gap[i]), tolerance);
      else
        ASSERT_GE(found.pressure[i], law.pressure(0.0) - tolerance);
    }
    EXPECT_GT(closed, 0U);
  }
}

} // namespace asperity::contact::toy_law_test
