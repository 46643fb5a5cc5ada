// Tests of mechanics/contact_law.hpp, which hold for every law of its list.
#include "mechanics/adhesion_scales.hpp"
#include "mechanics/contact_law.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asperity::mechanics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Law : public testing::TestWithParam<ContactLawTraits> {
protected:
  ContactInterface interface { GetParam().law, 3.0, 0.8, 1.3 };

  /// Gaps on both sides of 0 and of the range, in units of which the parameters
  /// above are of order 1. None lies at a jump of a derivative.
  std::vector<double> gaps() const {
    const double range = std::isfinite(interface.range()) ? interface.range()
                         : GetParam().has_wall            ? 10.0
                                               : interface.adhesion_range;
    std::vector<double> all;
    for (const double gap : {-1.1, -0.3, 0.07, 0.4, 0.93, 1.3})
      if (gap * range > interface.least_gap() || gap > 0.0)
        all.push_back(gap * (range > 0.0 ? range : 1.0));
    return all;
  }
};

// Central differences with steps of 1e-5 of the gaps: an error of 1e-10 of the
// third derivative, which is of order 1 but in repulsion, and roundoff of
// 1e-16 / 1e-5.
constexpr double step = 1e-5;

/// By the third and fourth derivatives of the energy.
double accuracy_at(const ContactInterface& interface, double gap) {
  const double wide = 1e-3;
  const double before = interface.stiffness(gap - wide);
  const double after = interface.stiffness(gap + wide);
  return 1e-9 *
         std::max({1.0, std::abs(after - before) / (2.0 * wide),
                   std::abs(before - 2.0 * interface.stiffness(gap) + after) /
                       (wide * wide)});
}

TEST_P(Law, PressureIsMinusTheSlopeOfTheEnergy) {
  for (const double gap : gaps())
    EXPECT_NEAR((interface.energy(gap - step) - interface.energy(gap + step)) /
                    (2.0 * step),
                interface.pressure(gap), accuracy_at(interface, gap))
        << gap;
}

TEST_P(Law, StiffnessIsMinusTheSlopeOfThePressure) {
  for (const double gap : gaps())
    EXPECT_NEAR(
        (interface.pressure(gap - step) - interface.pressure(gap + step)) /
            (2.0 * step),
        interface.stiffness(gap), accuracy_at(interface, gap))
        << gap;
}

TEST_P(Law, PressuresLieWithinTheirBounds) {
  const PressureBounds bounds = interface.pressure_bounds();

  for (const double gap : gaps()) {
    EXPECT_GE(interface.pressure(gap), bounds.smallest) << gap;
    EXPECT_LE(interface.pressure(gap), bounds.largest) << gap;
  }
}

TEST_P(Law, DoesNotActBeyondItsRange) {
  ASSERT_GE(interface.range(), 0.0);
  if (!std::isfinite(interface.range()))
    return;
  const double gap = std::nextafter(interface.range(), infinity);

  EXPECT_EQ(interface.energy(gap), 0.0);
  EXPECT_EQ(interface.pressure(gap), 0.0);
}

TEST_P(Law, AdmitsPenetrationOnlyWithoutAWall) {
  EXPECT_EQ(std::isfinite(interface.energy(-0.1)), !GetParam().has_wall);
  EXPECT_EQ(interface.local_compliance() > 0.0,
            GetParam().law == ContactLaw::penalty);
}

// Within a third of the distance to the core, where numbers are of order 1.
TEST_P(Law, HasItsLargestTensionAndIsInfiniteBehindItsLeastGap) {
  const double strongest = interface.strongest_gap();
  const PressureBounds bounds = interface.pressure_bounds();
  EXPECT_EQ(interface.pressure(strongest), bounds.smallest);
  for (const double gap : {0.5, 1.5, 3.0})
    EXPECT_GE(interface.pressure(gap), bounds.smallest);
  if (std::isfinite(interface.least_gap())) {
    EXPECT_EQ(interface.energy(interface.least_gap() - 0.1), infinity);
  }
}

// Flat faces are in equilibrium at W(0) = -w, also without a wall.
TEST_P(Law, HasItsWorkOfAdhesionAtTheGapZero) {
  if (!is_adhesive(GetParam().law))
    return;
  EXPECT_NEAR(interface.energy(0.0), -interface.work_of_adhesion, 1e-15);
  if (!GetParam().has_wall) {
    EXPECT_NEAR(interface.pressure(0.0), 0.0, 1e-15);
  }
}

// The list is indexed by the enumeration.
TEST_P(Law, IsFoundByItsName) {
  const auto place = static_cast<std::size_t>(GetParam().law);

  EXPECT_EQ(contact_laws()[place].law, GetParam().law);
  EXPECT_STREQ(contact_law_names()[place], GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(All, Law,
                         testing::ValuesIn(contact_laws().begin(),
                                           contact_laws().end()),
                         [](const auto& law) {
                           std::string name = law.param.name;
                           std::erase(name, '-');
                           return name;
                         });

// w h/(rho^2 E*) of the exponential law and Dugdale's, nine times that of the
// cubic one.
TEST(Adhesion, HasTheShortestRangeThatTheGridResolves) {
  const Scales scales{.contact_modulus = 2e9, .spacing = 5e-9};
  ContactSettings settings{.law = ContactLaw::dugdale,
                           .work_of_adhesion = 0.05};
  EXPECT_NEAR(settings.in_si(scales).adhesion_range,
              std::sqrt(0.05 * 5e-9 / (0.25 * 2e9)), 1e-22);
  settings.law = ContactLaw::cubic;
  const ContactInterface cubic = settings.in_si(scales);
  EXPECT_NEAR(cubic.adhesion_range, 3.0 * std::sqrt(0.05 * 5e-9 / (0.25 * 2e9)),
              1e-22);
  EXPECT_NEAR(cubic.grid_number(2e9, 5e-9), 0.25, 1e-14);
  settings.range = Quantity{2.0, ReferenceUnit::spacing};
  EXPECT_NEAR(settings.in_si(scales).adhesion_range, 1e-8, 1e-22);
}

TEST(Adhesion, IsResolvedByTheLargerSideOfAPixel) {
  const Scales along_x{.contact_modulus = 2e9, .spacing = 5e-9};
  EXPECT_EQ(adhesion_scales(along_x, {4, 4, 2e-8, 8e-8}).spacing, 2e-8);
  EXPECT_EQ(adhesion_scales(along_x, {4, 4, 8e-8, 2e-8}).spacing, 2e-8);
}

// Over gaps from 0.6 to 1.4; the work and the largest tension stay.
TEST(Adhesion, DugdalesTensionEndsOverTheGapsThatItChangesItself) {
  ContactInterface law{ContactLaw::dugdale, 0.0, 2.0, 1.0};
  law.edge = 0.4;
  EXPECT_EQ(law.energy(0.0), -2.0);
  EXPECT_NEAR(law.pressure(0.6), -2.0, 1e-15);
  EXPECT_NEAR(law.energy(0.6), -0.8, 1e-15);
  EXPECT_NEAR(law.pressure(1.0), -1.0, 1e-15);
  EXPECT_NEAR(law.energy(1.0), -0.2, 1e-15);
  EXPECT_EQ(law.pressure(1.4), 0.0);
  EXPECT_EQ(law.energy(1.4), 0.0);
  EXPECT_EQ(law.range(), 1.4);
  for (const double gap : {0.3, 0.7, 1.2, 1.5}) {
    EXPECT_NEAR(
        law.pressure(gap),
        (law.energy(gap - step) - law.energy(gap + step)) / (2.0 * step), 1e-9);
    EXPECT_NEAR(law.stiffness(gap),
                (law.pressure(gap - step) - law.pressure(gap + step)) /
                    (2.0 * step),
                1e-9);
  }

  // s h/E*
  const ContactSettings settings{.law = ContactLaw::dugdale,
                                 .work_of_adhesion = 0.05,
                                 .range = Quantity{1e-8, ReferenceUnit::si}};
  EXPECT_NEAR(settings.in_si({.contact_modulus = 2e9, .spacing = 5e-9}).edge,
              0.05 / 1e-8 * 5e-9 / 2e9, 1e-22);
}

// Scales of a sphere of radius R, kappa = 1/R, whose parameters are 2 and 3.
TEST(Adhesion, IsJudgedByTheRoughness) {
  const ContactInterface law{ContactLaw::exponential, 0.0, 8.0, 2.0};
  EXPECT_NEAR(tabor_parameter(law, 1.0, {0.3, 1.0}), 2.0, 1e-14);
  EXPECT_NEAR(stickiness(law, 10.0, {0.2, 0.01}), 0.2 * 10.0 * 2.0 / 16.0 * 1.0,
              1e-14);
}

ContactLawTraits with_tension() {
  ContactLawTraits traits = traits_of(ContactLaw::hard);
  traits.name = "sticky";
  traits.pressure_bounds = [](const ContactInterface&) {
    return PressureBounds{-5e6, infinity};
  };
  return traits;
}

TEST(SolversOfLaws, RefuseTensionWhereTheyAssumeNone) {
  EXPECT_EQ(tests::message_of<std::domain_error>(
                [] { surface_solver_of(with_tension(), {}); }),
            "contact = sticky: pressures from -5e+06 to inf Pa, but the solver "
            "of this law assumes that they are >= 0 without an upper bound");
}

TEST(SolversOfLaws, RefuseALawThatNoneServes) {
  ContactLawTraits traits = with_tension();
  traits.surface_solver = SurfaceSolver::none;
  traits.block_solver = BlockSolver::none;

  EXPECT_EQ(tests::message_of<std::domain_error>(
                [&] { surface_solver_of(traits, {}); }),
            "contact = sticky: this law is not available for a half-space, a "
            "slab or a condensed block");
  EXPECT_EQ(
      tests::message_of<std::domain_error>([&] { block_solver_of(traits); }),
      "contact = sticky: this law is not available for a meshed block");
}

} // namespace
} // namespace asperity::mechanics
