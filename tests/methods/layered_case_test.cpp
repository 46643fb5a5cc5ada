// Tests of cases/layered and cases/board/layered: their references are the two
// classical slopes of the area at light load, with the effective modulus of the
// layers at each wavevector.
#include "contact/operators/layered_compliance.hpp"
#include "input/reader/read_case.hpp"
#include "input/types/reference.hpp"
#include "run/methods/continuum_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace asperity::methods::layered_case_test {

double reference_of(const std::string& folder, const std::string& quantity) {
  for (const cases::ReferenceValue& reference :
       cases::read_reference(folder + "/reference.csv"))
    if (reference.quantity == quantity)
      return reference.value;
  return std::numeric_limits<double>::quiet_NaN();
}

// The pressure that flattens the surface has the variance sum |h(q)|^2/ C(q)^2,
// whose root over that of the uniform block is the root mean square of E*(q)/E*
// = 2/(C(q) q E*), weighted by slope. Persson's A/A_0 = erf(p/sqrt(2 variance))
// then begins with sqrt(8/pi) over it; Bush, Gibson and Thomas have sqrt(2 pi)
// for sqrt(8/pi). Tolerance: the five digits written, 5e-6/0.2, times 2.5; the
// error of the midpoint rule is below them.
class LayeredCase : public testing::TestWithParam<std::string> {};

TEST_P(LayeredCase, HasTheSlopesOfItsLayers) {
  const cases::Case read = cases::read_case(GetParam() + "/case.toml");
  const mechanics::SurfaceSpec& surface = read.surface;
  const mechanics::Scales scales{read.material.contact_modulus, *surface.length,
                                 *surface.length / *surface.points, 0.0};
  const auto halfspace =
      std::ranges::find(read.methods, "halfspace", &cases::MethodSpec::name);
  ASSERT_NE(halfspace, read.methods.end());
  const mechanics::ElasticBlock block =
      continuum_of(*halfspace, read.material, scales);
  double slope = 0.0, stiffness = 0.0;
  const int n = 4000;
  const double span =
      std::log(surface.wavevector_high / surface.wavevector_low);
  for (int i = 0; i < n; ++i) {
    const double q = surface.wavevector_low * std::exp((i + 0.5) / n * span);
    const double weight =
        std::pow(q, 4) * std::pow(std::max(q, surface.wavevector_roll_off),
                                  -2.0 - 2.0 * surface.hurst);
    slope += weight;
    stiffness +=
        weight * std::pow(2.0 / (contact::layered_compliance(q, block) * q *
                                 read.material.contact_modulus),
                          2);
  }
  const double root = std::sqrt(stiffness / slope);

  EXPECT_NEAR(reference_of(GetParam(), "kappa_persson") * root,
              std::sqrt(8.0 / std::numbers::pi), 7e-5);
  EXPECT_NEAR(reference_of(GetParam(), "kappa_bush_gibson_thomas") * root,
              std::sqrt(2.0 * std::numbers::pi), 7e-5);
}

INSTANTIATE_TEST_SUITE_P(ShippedCases, LayeredCase,
                         testing::Values("cases/layered",
                                         "cases/board/layered"));

// At the contact boundary the coating determines the modulus where it is many
// spacings thick, and the substrate where it is far thinner than one.
// Tolerances: at q t = 39 the influence of the substrate is below roundoff; at
// q t = 1.6e-4 that of the coating is some q t times the ratio of the moduli.
TEST(LayeredBlock, HasTheModulusOfItsCoatingAtContactBoundaries) {
  mechanics::ElasticBlock block{2e9,
                                0.3,
                                std::numeric_limits<double>::infinity(),
                                {},
                                {{0.05, 2e10, 0.2}}};
  EXPECT_NEAR(boundary_modulus(block, 0.002) / (2e10 / (1.0 - 0.04)), 1.0,
              1e-9);
  EXPECT_NEAR(boundary_modulus(block, 500.0) / 2e9, 1.0, 0.003);
  block.layers.clear();
  EXPECT_EQ(boundary_modulus(block, 0.002), 2e9);
}

} // namespace asperity::methods::layered_case_test
