// Tests of contact/operators/layered_compliance.hpp against closed forms of
// slabs and of a coating in fifty digits, against limits, and against the
// monotonicity in the moduli of the layers.
#include "base/special_numbers.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/operators/layered_compliance.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::contact::layered_compliance_test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

constexpr std::array far_boundaries{mechanics::FarBoundary::clamped,
                                    mechanics::FarBoundary::sliding,
                                    mechanics::FarBoundary::pressure};

double plane_strain(double youngs_modulus, double poisson_ratio) {
  return youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);
}

/// A block of one material whose upper part is cut into layers.
mechanics::ElasticBlock cut_block(double modulus, double nu, double thickness,
                                  mechanics::FarBoundary far_boundary) {
  mechanics::ElasticBlock block{plane_strain(modulus, nu), nu, thickness,
                                far_boundary};
  const double upper = std::isinf(thickness) ? 1.0 : thickness;
  for (const double share : {0.1, 0.45, 0.05})
    block.layers.push_back({share * upper, modulus, nu});
  return block;
}

mechanics::ElasticBlock coated_halfspace(double coating, double coating_nu,
                                         double substrate, double substrate_nu,
                                         double thickness) {
  return {plane_strain(substrate, substrate_nu),
          substrate_nu,
          infinity,
          mechanics::FarBoundary::clamped,
          {{thickness, coating, coating_nu}}};
}

/// The compliance of a slab relative to the half-space, x = q d, in a precision
/// in which cancellation does no harm. See K. L. Johnson, Contact Mechanics
/// (1985), ch. 5; G. Carbone et al., J. Mech. Phys. Solids 56, 684 (2008).
Digits50 slab_factor(Digits50 x, mechanics::FarBoundary far_boundary,
                     Digits50 nu) {
  const Digits50 twice = 2 * x;
  switch (far_boundary) {
  case mechanics::FarBoundary::clamped:
    return ((3 - 4 * nu) * sinh(twice) - twice) /
           ((3 - 4 * nu) * cosh(twice) + 2 * x * x + 5 - 12 * nu + 8 * nu * nu);
  case mechanics::FarBoundary::sliding:
    return (cosh(twice) - 1) / (sinh(twice) + twice);
  case mechanics::FarBoundary::pressure:
    break;
  }
  return (sinh(twice) + twice) / (cosh(twice) - 1 - 2 * x * x);
}

/// A coating bonded to a half-space, with a frictionless surface, relative to
/// 2/(E*_1 q); mu = mu_1/mu_2. See E. J. O'Sullivan and R. B. King, J. Tribol.
/// 110, 235 (1988).
Digits50 coating_factor(Digits50 x, Digits50 mu, Digits50 nu_1, Digits50 nu_2) {
  const Digits50 lambda = 1 - 4 * (1 - nu_1) / (1 + mu * (3 - 4 * nu_2));
  const Digits50 kappa = (mu - 1) / (mu + 3 - 4 * nu_1);
  const Digits50 theta = exp(-2 * x);
  return (1 + 4 * x * kappa * theta - lambda * kappa * theta * theta) /
         (1 - (lambda + kappa + 4 * kappa * x * x) * theta +
          lambda * kappa * theta * theta);
}

constexpr std::array reduced_wavevectors{1e-8, 1e-5, 1e-3, 0.03, 0.4,
                                         1.3,  2.2,  4.5,  9.0,  12.5,
                                         30.0, 55.0, 90.0, 1e3,  1e4};

// Verifies the closed forms of a slab, whole and cut into layers of its
// material, for every far boundary and every wave. Tolerance: some ten
// roundings in each of four layers.
TEST(LayeredCompliance, OfASlabAndOfEqualLayersIsItsClosedForm) {
  for (const double nu : {-0.3, 0.0, 0.3, 0.45, 0.4999, 0.5})
    for (const mechanics::FarBoundary boundary : far_boundaries)
      for (const double x : reduced_wavevectors) {
        const double thickness = 0.7;
        const double q = x / thickness;
        mechanics::ElasticBlock block = cut_block(3.0, nu, thickness, boundary);
        const double cut = layered_compliance(q, block);
        block.layers.clear();
        const double whole = compliance_function(block)(q);

        const Digits50 exact =
            2 * slab_factor(Digits50(q) * thickness, boundary, nu) /
            (Digits50(block.contact_modulus) * q);
        for (const double found : {cut, whole})
          EXPECT_NEAR(static_cast<double>(found / exact), 1.0, 1e-14)
              << nu << " " << static_cast<int>(boundary) << " " << x;
      }
}

TEST(LayeredCompliance, OfEqualLayersEqualsTheHalfspace) {
  for (const double nu : {-0.3, 0.0, 0.3, 0.5})
    for (const double q : reduced_wavevectors) {
      const mechanics::ElasticBlock block =
          cut_block(3.0, nu, infinity, mechanics::FarBoundary::clamped);
      EXPECT_NEAR(layered_compliance(q, block) * block.contact_modulus * q, 2.0,
                  1e-14)
          << nu << " " << q;
    }
}

// Verifies O'Sullivan and King's solution for a coating on a half-space, from a
// million times softer to a million times stiffer. Tolerance: ten roundings in
// each of two layers, and more where one carries a millionth of the load of the
// other.
TEST(LayeredCompliance, OfACoatingHasItsClosedForm) {
  for (const double ratio : {1e-6, 1e-3, 0.1, 1.0, 7.0, 1e3, 1e6})
    for (const double nu_1 : {0.0, 0.25, 0.4999})
      for (const double nu_2 : {0.1, 0.4999})
        for (const double x : reduced_wavevectors) {
          const double thickness = 3e-6;
          const double q = x / thickness;
          const mechanics::ElasticBlock block =
              coated_halfspace(ratio * 2e9, nu_1, 2e9, nu_2, thickness);

          const double found = layered_compliance(q, block);

          const Digits50 mu =
              Digits50(ratio) * (1 + Digits50(nu_2)) / (1 + Digits50(nu_1));
          const Digits50 exact =
              2 * coating_factor(Digits50(q) * thickness, mu, nu_1, nu_2) *
              (1 - Digits50(nu_1) * nu_1) / (Digits50(ratio) * 2e9 * q);
          EXPECT_NEAR(static_cast<double>(found / exact), 1.0, 4e-14)
              << ratio << " " << nu_1 << " " << nu_2 << " " << x;
        }
}

// A short wave has the compliance of the coating, a long one that of the
// substrate. Tolerances: the coating's lower boundary changes the former by x^2
// exp(-2x) = 1e-11; the coating changes the latter by x times the ratio of the
// moduli.
TEST(LayeredCompliance, TendsToTheSubstrateAndToTheCoating) {
  const mechanics::ElasticBlock block =
      coated_halfspace(20e9, 0.2, 2e9, 0.4, 1e-6);

  EXPECT_NEAR(layered_compliance(16e6, block) * plane_strain(20e9, 0.2) * 16e6,
              2.0, 1e-10);
  EXPECT_NEAR(layered_compliance(1.0, block) * plane_strain(2e9, 0.4) * 1.0,
              2.0, 3e-5);
}

// A thin free stack is a plate of the bending stiffness D = int E* (z - z_0)^2
// dz about the neutral axis: C = 1/(D q^4). Tolerance: the next order is (q
// d)^2 = 1e-6.
TEST(LayeredCompliance, OfAThinFreeStackEqualsAPlate) {
  const std::array<mechanics::BondedLayer, 3> layers{
      {{0.2, 5.0, 0.3}, {0.1, 0.5, 0.1}, {0.4, 2.0, 0.45}}};
  const double q = 1e-3 / 0.7;
  double stretching = 0.0, first_moment = 0.0, second_moment = 0.0, z = 0.0;
  for (const mechanics::BondedLayer& layer : layers) {
    const double modulus =
        plane_strain(layer.youngs_modulus, layer.poisson_ratio);
    const double end = z + layer.thickness;
    stretching += modulus * (end - z);
    first_moment += modulus * (end * end - z * z) / 2.0;
    second_moment += modulus * (end * end * end - z * z * z) / 3.0;
    z = end;
  }
  const double bending =
      second_moment - first_moment * first_moment / stretching;

  const double found = layered_compliance(q, {plane_strain(2.0, 0.45),
                                              0.45,
                                              0.7,
                                              mechanics::FarBoundary::pressure,
                                              {layers[0], layers[1]}});

  EXPECT_NEAR(found * bending * std::pow(q, 4), 1.0, 3e-6);
}

/// A random stack: up to five layers, moduli over four decades.
struct RandomStack {
  mechanics::ElasticBlock block;
  double wavevector;
};

RandomStack any_stack() {
  const auto between = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100001) / 100000.0;
  };
  RandomStack stack;
  const int n_layers = *rc::gen::inRange(1, 6);
  double depth = 0.0;
  for (int i = 0; i < n_layers; ++i) {
    const mechanics::BondedLayer layer{std::pow(10.0, between(-6.0, 1.0)),
                                       std::pow(10.0, between(-2.0, 2.0)),
                                       between(-0.5, 0.499)};
    stack.block.layers.push_back(layer);
    depth += layer.thickness;
  }
  stack.block.contact_modulus = std::pow(10.0, between(-2.0, 2.0));
  stack.block.poisson_ratio = between(-0.5, 0.499);
  stack.block.thickness = *rc::gen::inRange(0, 4) == 0 ? infinity : 1.2 * depth;
  stack.block.far_boundary =
      *rc::gen::elementOf(std::vector<mechanics::FarBoundary>(
          far_boundaries.begin(), far_boundaries.end()));
  stack.wavevector = std::pow(10.0, between(-3.0, 4.0)) / depth;
  return stack;
}

// Under the same displacement the minimum energy of a stiffer solid is no
// smaller, so that a stiffer layer increases the compliance of no wave, nor
// does a constraint of more components at the far boundary. Tolerance:
// roundoff, 1e-11 for plates of very unequal layers.
RC_GTEST_PROP(LayeredCompliance, DecreasesWithEveryModulusAndConstraint, ()) {
  const RandomStack stack = any_stack();
  const double softer = layered_compliance(stack.wavevector, stack.block);
  RC_ASSERT(std::isfinite(softer) && softer > 0.0);
  mechanics::ElasticBlock stiffer = stack.block;
  double last = softer;

  for (mechanics::BondedLayer& layer : stiffer.layers) {
    layer.youngs_modulus *= 1.5;
    const double harder = layered_compliance(stack.wavevector, stiffer);
    RC_ASSERT(harder <= last * (1.0 + 1e-11));
    last = harder;
  }
  mechanics::ElasticBlock held = stack.block;
  last = 0.0;
  for (const mechanics::FarBoundary boundary : far_boundaries) {
    held.far_boundary = boundary;
    const double now = layered_compliance(stack.wavevector, held);
    RC_ASSERT(now >= last * (1.0 - 1e-11));
    last = now;
  }
}

// A cut through a layer changes nothing, wherever it is. Tolerance as above.
RC_GTEST_PROP(LayeredCompliance, IsUnchangedByACut, ()) {
  const RandomStack stack = any_stack();
  mechanics::ElasticBlock cut = stack.block;
  const auto which =
      static_cast<long>(*rc::gen::inRange(std::size_t{0}, cut.layers.size()));
  const double share = *rc::gen::inRange(1, 1000) / 1000.0;
  mechanics::BondedLayer lower = cut.layers[static_cast<std::size_t>(which)];
  cut.layers[static_cast<std::size_t>(which)].thickness *= share;
  lower.thickness -= cut.layers[static_cast<std::size_t>(which)].thickness;
  cut.layers.insert(cut.layers.begin() + which + 1, lower);

  const double whole = layered_compliance(stack.wavevector, stack.block);

  RC_ASSERT(std::abs(layered_compliance(stack.wavevector, cut) / whole - 1.0) <
            1e-11);
}

// Verifies that the symbol of the operator is C(|q|) for each wavevector.
TEST(LayeredCompliance, IsTheSymbolOfALayeredBlock) {
  const Grid grid{8, 6, 1.0, 2.0};
  const mechanics::ElasticBlock block =
      coated_halfspace(3.0, 0.2, 1.0, 0.4, 0.05);

  std::vector<double> symbol(4); // jx = 3
  compliance_column(grid, block)(3, symbol);

  EXPECT_EQ(symbol[2],
            layered_compliance(
                std::hypot(wavevector(3, 1.0), wavevector(2, 2.0)), block));
}

TEST(LayeredCompliance, RefusesAnInvalidStack) {
  const mechanics::ElasticBlock good =
      coated_halfspace(3.0, 0.2, 1.0, 0.4, 0.05);
  EXPECT_THROW(layered_compliance(0.0, good), std::domain_error);
  mechanics::ElasticBlock bad = good;
  bad.thickness = 0.05;
  EXPECT_THROW(layered_compliance(1.0, bad), std::domain_error);
  bad = good;
  bad.layers[0].poisson_ratio = 0.6;
  EXPECT_THROW(layered_compliance(1.0, bad), std::domain_error);
  bad = good;
  bad.layers[0].youngs_modulus = 0.0;
  EXPECT_THROW(layered_compliance(1.0, bad), std::domain_error);
  bad = good;
  bad.layers[0].thickness = infinity;
  EXPECT_THROW(layered_compliance(1.0, bad), std::domain_error);
}

} // namespace asperity::contact::layered_compliance_test
