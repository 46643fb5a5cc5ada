// Tests of theory/exact/asperity_models.hpp: printed numbers, and the limit
// that the paper states.
#include "tests/theory/spectra.hpp"
#include "theory/exact/asperity_models.hpp"
#include "theory/persson/persson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::theory::asperity_models_test {

using std::numbers::pi;

ProfileMoments moments_of_the_paper() {
  return surface_of_the_paper().spectrum().profile_moments();
}

// p/E* on the paper's surface, computed by another program, together with
// Persson's (14). Tolerance: half a unit of the fourth digit.
TEST(BushGibsonThomas, HasItsPrintedNumbers) {
  const ProfileMoments moments = moments_of_the_paper();
  const PerssonContact persson(surface_of_the_paper().spectrum(), 1.0, 0.42);

  struct Row {
    double gap, bgt, persson;
  };

  for (const Row& row :
       {Row{1.0, 7.700e-3, 1.2633e-2}, Row{2.0, 1.086e-3, 1.585e-3},
        Row{3.0, 6.589e-5, 1.781e-4}, Row{4.0, 1.583e-6, 1.932e-5}}) {
    const double gap = row.gap * 1e-9;
    EXPECT_NEAR(bush_gibson_thomas(moments, 1.0, gap).nominal_pressure /
                    row.bgt,
                1.0, 5e-4);
    EXPECT_NEAR(persson.nominal_pressure(gap) / row.persson, 1.0, 5e-4);
  }
}

// The full model tends to its asymptote as 1 - O(m_0/u^2), in pressure and in
// area: p ~ u^-1 e^{-u^2/2 m_0}, the exponent 1 of the paper. The limit is
// extrapolated from 20 and 30 sqrt(m_0). Tolerance: the remaining order x^-4,
// 10/20^4.
TEST(BushGibsonThomas, TendsToItsAsymptote) {
  const ProfileMoments moments = moments_of_the_paper();
  const auto ratio = [&](double x, auto member) {
    const double area = 0.25 * std::erfc(x / std::sqrt(2.0));
    const AsperityLoad asymptote{5.0 * std::sqrt(moments.slope / pi) * area,
                                 area};
    return (bush_gibson_thomas(moments, 5.0, x * std::sqrt(moments.height)).*
            member) /
           (asymptote.*member);
  };
  for (const auto member :
       {&AsperityLoad::nominal_pressure, &AsperityLoad::area_fraction}) {
    const double at_20 = ratio(20.0, member), at_30 = ratio(30.0, member);

    EXPECT_NEAR(at_20, 1.0, 2.0 / 400.0);
    EXPECT_NEAR((900.0 * at_30 - 400.0 * at_20) / 500.0, 1.0, 6e-5);
  }
}

TEST(BushGibsonThomas, RefusesWhatIsOutsideItsRange) {
  const ProfileMoments moments = moments_of_the_paper();
  EXPECT_THROW(bush_gibson_thomas(moments, 0.0, 1e-9), std::domain_error);
  EXPECT_THROW(bush_gibson_thomas(moments, 1.0, NAN), std::domain_error);
  try {
    bush_gibson_thomas({1.0, 1.0, 1.5}, 1.0, 1e-9);
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("nayak = 1.5"), std::string::npos);
  }
}

} // namespace asperity::theory::asperity_models_test
