// Tests of the tables of the theory's studies: the columns have the properties
// that the paper proves.
#include "studies/adhesion/adhesion_tables.hpp"
#include "studies/magnification/magnification_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::studies::study_tables_test {

/// A self-affine surface without roll-off, C ~ q^{-3.6}.
theory::HeightSpectrum self_affine(double low, double high, double rms_height) {
  const auto shape = [](double q) { return std::pow(q, -3.6); };
  const theory::HeightSpectrum unit({shape, {low, high}});
  const double scale = std::pow(rms_height / unit.rms_height(), 2);
  return theory::HeightSpectrum(theory::SpectrumFormula{
      [=](double q) { return scale * shape(q); }, {low, high}});
}

theory::PerssonContact rough_contact() {
  return {self_affine(1e6, 3e7, 2e-8), 2e9, 0.4};
}

MagnificationStudy study() {
  MagnificationStudy study;
  study.nominal_pressures = {{1e7},
                             {0.02, mechanics::ReferenceUnit::contact_modulus}};
  study.from = 0.5;
  study.to = 30.0;
  study.points = 13;
  study.reference_wavevector = 1e6;
  return study;
}

// Exact: A = A_0 below zeta_0, and no roughness is unresolved at zeta_1.
// Tolerance of the gap: both sums are accurate to some 1e-13.
TEST(StudyTables, OfMagnificationsEndAtCompleteContactAndFullResolution) {
  const auto contacts = magnified_contacts(rough_contact(), study());
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[1].nominal_pressure(), 4e7);

  const results::Table table = magnification_table("x", contacts[0], study());

  EXPECT_EQ(table.values("magnification").front(), 0.5);
  EXPECT_EQ(table.values("magnification").back(), 30.0);
  EXPECT_EQ(table.values("area_fraction").front(), 1.0);
  EXPECT_NEAR(table.values("area_fraction").back() /
                  rough_contact().area_fraction(1e7),
              1.0, 1e-12);
  EXPECT_NEAR(table.values("mean_gap").front() / rough_contact().mean_gap(1e7),
              1.0, 1e-12);
  EXPECT_EQ(table.values("mean_gap").back(), 0.0);
  EXPECT_EQ(table.values("rms_height").back(), 0.0);
}

// Between two quantiles a = A(zeta) the separating volume is the difference of
// A u, (25) integrated. No tolerance: u_1 increases with a, so that the sums
// with its value at the lower and at the upper end of each step enclose the
// volume.
TEST(StudyTables, OfTheDistributionEncloseTheSeparatingVolume) {
  const auto contacts = magnified_contacts(rough_contact(), study());
  const auto volume = [&](double part) {
    return part * contacts[0].mean_gap(
                      contacts[0].magnification_of_area(part).value());
  };

  const results::Table table = gap_distribution_table("x", contacts[0]);

  const std::vector<double> part = table.values("cumulative");
  const std::vector<double> gap = table.values("gap");
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 1; i < gap.size(); ++i) {
    ASSERT_GT(gap[i], gap[i - 1]);
    low += gap[i - 1] * (part[i] - part[i - 1]);
    high += gap[i] * (part[i] - part[i - 1]);
  }
  const double opened = volume(part.back()) - volume(part.front());
  EXPECT_GT(opened, low);
  EXPECT_LT(opened, high);
  EXPECT_LT(high, 1.03 * low); // a step is at most pi/400 of the area
}

// Where the open area never percolates there is no leakage; where it does, the
// area at the magnification of the constriction is the critical one.
TEST(StudyTables, OfLeakageFindWhereTheOpenAreaPercolates) {
  MagnificationStudy loads = study();
  loads.nominal_pressures = {{1e7}, {2e9}};
  const auto contacts = magnified_contacts(rough_contact(), loads);

  const results::Table table = leak_table(contacts, {1000.0, 1e-3, 1e4, 0.42});

  const double zeta = table.values("magnification").at(0);
  EXPECT_NEAR(contacts[0].area_fraction(zeta), 0.42, 1e-9);
  const double gap = table.values("pore_gap").at(0);
  EXPECT_DOUBLE_EQ(table.values("mass_flow").at(0),
                   1000.0 * gap * gap * gap * 1e4 / (12.0 * 1e-3));
  EXPECT_TRUE(std::isnan(table.values("mass_flow").at(1)));
}

/// The surrogate of the paper's rubber.
theory::RoughAdhesion rubber(int steps) {
  return {
      self_affine(7.944e5, 7.944e7, 2e-7),
      {.contact_modulus = 5e6 / 0.75, .work_of_adhesion = 0.1, .gamma = 0.42},
      steps};
}

// At the transition both branches have the same binding energy (tolerance:
// bisection to 1e-9 of the ratio, binding energy decreases by some 3 per unit
// of the ratio). -0.1 of complete contact is the value for which the surrogate
// was made, to the printed digits of its q_0.
TEST(StudyTables, OfAdhesionFindTheTransition) {
  AdhesionStudy ratios;
  ratios.work_of_adhesion = 0.1;
  ratios.from = 0.7;
  ratios.to = 1.0;
  ratios.points = 3;
  ratios.sphere_radius = 1e-3;
  const theory::RoughAdhesion adhesion = rubber(60);

  const results::Table rows = adhesion_table(adhesion, ratios, 2e-7);
  const results::Table flip = adhesion_flip_table(adhesion, ratios, rows);

  const double at = flip.values("height_ratio").front();
  EXPECT_NEAR(adhesion.complete_contact(at).effective_work,
              adhesion.partial_contact(at).effective_work, 1e-8 * 0.1);
  EXPECT_NEAR(flip.values("complete_contact_binding").front(), -0.1, 1e-3);
  EXPECT_EQ(rows.values("area_fraction_equilibrium").front(), 1.0);
  EXPECT_LT(rows.values("area_fraction_equilibrium").back(), 0.5);
  EXPECT_EQ(rows.values("rms_height").back(), 2e-7);
  EXPECT_NEAR(rows.values("pull_off_force").front(),
              1.5 * M_PI * 1e-3 * 0.1 * rows.values("binding_complete").front(),
              1e-15);
  ratios.to = 0.75;
  EXPECT_TRUE(
      std::isnan(adhesion_flip_table(adhesion, ratios,
                                     adhesion_table(adhesion, ratios, 2e-7))
                     .values("height_ratio")
                     .front()));
}

} // namespace asperity::studies::study_tables_test
