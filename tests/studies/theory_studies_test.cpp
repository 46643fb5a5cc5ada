// Tests of the report on the tables of a study: the named numbers, from tables
// of power laws, and the drawn figures.
#include "reports/figures/figures.hpp"
#include "studies/adhesion/adhesion.hpp"
#include "studies/magnification/magnification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity::studies::theory_studies_test {

using namespace reports;

constexpr double rms_height = 2e-8;
constexpr double none = not_a_number;

/// A = p/zeta (p in MPa/100), u = 1e-8 (1 + p)/zeta^2 at zeta = 1, 2, 4, 8: at
/// 1 and 3 MPa, u/u' differs from 1 by the same at each zeta.
results::Table seen(int load, double megapascal) {
  results::Table table{"magnification-" + std::to_string(load), "", {}};
  table.columns = {{"magnification", "1", {}},
                   {"area_fraction", "1", {}},
                   {"rms_height", "m", {}},
                   {"mean_gap", "m", {}},
                   {"opening_gap", "m", {}}};
  for (const double zeta : {1.0, 2.0, 4.0, 8.0}) {
    const double gap = 1e-8 * (1.0 + megapascal) / (zeta * zeta);
    table.columns[0].values.push_back(zeta);
    table.columns[1].values.push_back(0.01 * megapascal / zeta);
    table.columns[2].values.push_back(rms_height / zeta);
    table.columns[3].values.push_back(gap);
    table.columns[4].values.push_back(2.0 * gap);
  }
  return table;
}

results::Table gaps(int load) {
  return {"gap-distribution-" + std::to_string(load),
          "",
          {{"cumulative", "1", {0.2, 0.9}},
           {"gap", "m", {1e-8, 3e-8}},
           {"density", "1/m", {2e7, 1e6}}}};
}

/// The loads are in descending order.
results::Result studied_result() {
  results::Result result;
  result.contact_modulus = 2e9;
  result.methods.push_back({"theory", "theory", "", {results::Curve{}}});
  result.tables = {{"magnification",
                    "",
                    {{"nominal_pressure", "Pa", {3e6, 1e6}},
                     {"contact_weight", "1", {0.1, 0.05}},
                     {"mean_gap", "m", {4e-8, 2e-8}},
                     {"rms_height", "m", {rms_height, rms_height}},
                     {"lowest_magnification", "1", {1.0, 1.0}}}},
                   seen(1, 3.0),
                   seen(2, 1.0),
                   gaps(1),
                   gaps(2),
                   {"adhesion",
                    "",
                    {{"height_ratio", "1", {0.5, 1.0}},
                     {"binding_partial", "1", {0.5, 0.1}},
                     {"binding_complete", "1", {0.7, none}}}},
                   {"adhesion-flip",
                    "",
                    {{"height_ratio", "1", {0.8}},
                     {"area_fraction", "1", {none}},
                     {"complete_contact_binding", "1", {-0.25}}}}};
  return result;
}

cases::Case studied_case() {
  cases::Case studied;
  studied.methods.push_back(
      {"theory", mechanics::TheorySettings{.gamma = 1.0}});
  studied.studies.ask(MagnificationStudy{});
  studied.studies.ask(AdhesionStudy{});
  return studied;
}

MethodSummary summary_of(const results::Result& result,
                         const std::vector<std::string>& names = {}) {
  MethodSummary summary;
  for (const StudyPages* const study : study_pages())
    if (study->add_quantities != nullptr)
      study->add_quantities(result, studied_case(), result.methods.front(),
                            names, summary);
  return summary;
}

// Tolerance: a few roundings of a power. zeta = 3 lies between rows: a power
// law is linear there.
TEST(StudyQuantities, AreReadAtAMagnification) {
  const std::string area = "area_fraction@p=1 MPa@zeta=3";
  const std::string gap = "reduced_mean_gap@p=0.0015 E*@zeta=3";
  const std::string ratio = "mean_gap_ratio@p=3 MPa@zeta=8";

  const auto quantities =
      summary_of(studied_result(), {area, gap, ratio}).quantities;

  EXPECT_NEAR(quantities.at(area).value, 0.01 / 3.0, 1e-17);
  EXPECT_NEAR(quantities.at(gap).value, 4e-8 / 9.0 / rms_height, 1e-15);
  EXPECT_NEAR(quantities.at(ratio).value, 1.0 / 64.0, 1e-16);
}

TEST(StudyQuantities, StateWhyThereIsNone) {
  const std::string load = "area_fraction@p=2 MPa@zeta=3";
  const std::string beyond = "area_fraction@p=1 MPa@zeta=9";

  const auto quantities =
      summary_of(studied_result(), {load, beyond}).quantities;

  EXPECT_FALSE(quantities.at(load).has_value());
  EXPECT_EQ(quantities.at(load).remark,
            "p = 2 MPa is not a load of [magnification]");
  EXPECT_EQ(quantities.at(beyond).remark,
            "zeta = 9 lies outside the computed range");
  EXPECT_EQ(quantities.at("adhesion_flip_area").remark,
            "no flip between two ratios of the study");
  results::Result bare = studied_result();
  bare.tables.clear();
  EXPECT_EQ(summary_of(bare).quantities.at("adhesion_flip").remark,
            "the study of adhesion was not run");
}

// u(1 MPa)/u(3 MPa) = 2/4. eps(1) = e^{-gamma_Euler/2}, printed in the
// reference numbers to 12 digits.
TEST(StudyQuantities, HaveNamesOfTheirOwn) {
  const auto quantities = summary_of(studied_result()).quantities;

  EXPECT_DOUBLE_EQ(quantities.at("gap_pressure_dependence").value, 0.5);
  EXPECT_EQ(quantities.at("adhesion_flip").value, 0.8);
  EXPECT_EQ(quantities.at("complete_contact_binding").value, -0.25);
  const Summary all = summarize(studied_result(), studied_case());
  EXPECT_NEAR(all.methods.front().quantities.at("epsilon").value,
              0.749306001288, 1e-12);
}

// A = 0.5 at zeta = p/50 MPa; u falls as 1/zeta^2.
TEST(StudyAnswers, SayWhatTouchesAtAMagnification) {
  results::Result result = studied_result();
  const cases::Case studied = studied_case();
  const ReportEntry entry{&result, &studied, {}};

  EXPECT_EQ(magnification_pages().answer(entry),
            "Under 3 MPa the theory has 10 % of the area in contact with all "
            "roughness.");
  for (double& share : result.tables[1].columns[1].values)
    share *= 50.0; // 1.5 at zeta = 1, 0.5 at zeta = 3
  result.tables.push_back({"leak",
                           "",
                           {{"nominal_pressure", "Pa", {3e6, 1e6}},
                            {"mass_flow", "kg/s", {none, 2e-9}},
                            {"pore_gap", "m", {none, 3e-9}}}});

  EXPECT_EQ(magnification_pages().answer(entry),
            "Under 3 MPa the theory has 10 % of the area in contact with all "
            "roughness, and half of it at the magnification 3, where the faces "
            "are 4.44 nm apart. It does not leak: the open area does not "
            "percolate.");
  result.tables.back().columns[1].values.front() = 2.5e-9;
  result.tables.back().columns[2].values.front() = 3e-9;
  EXPECT_TRUE(magnification_pages().answer(entry).ends_with(
      "apart. 2.5e-09 kg/s leaks through its critical pore, 3 nm high."))
      << magnification_pages().answer(entry);
}

TEST(StudyAnswers, SayWhatAdhesionHolds) {
  results::Result result = studied_result();
  const cases::Case studied = studied_case();
  const ReportEntry entry{&result, &studied, {}};
  results::Table& rows = result.tables[5];
  rows.columns.push_back({"rms_height", "m", {1e-8, 2e-8}});
  rows.columns.push_back({"binding_equilibrium", "1", {0.7, 0.1}});
  rows.columns.push_back({"area_fraction_equilibrium", "1", {1.0, 0.4}});
  rows.columns.push_back({"pull_off_force", "N", {3e-3, 1e-3}});

  EXPECT_EQ(adhesion_pages().answer(entry),
            "By the theory of rough adhesion: at an rms height of 20 nm and "
            "without load, 40 % of the area touches, with 10 % of the binding "
            "energy of flat faces; the ball comes off at 1 mN; contact is "
            "complete up to 16 nm.");
  rows.columns[4].values.back() = none; // no contact at this roughness
  rows.columns.pop_back();
  EXPECT_EQ(adhesion_pages().answer(entry),
            "By the theory of rough adhesion: contact is complete up to 16 "
            "nm.");
}

TEST(StudyFigures, AreDrawnWhereTheTablesAre) {
  const results::Result result = studied_result();
  const results::Result bare;
  const cases::Case studied = studied_case();
  const ReportEntry drawn{&result, &studied, {}}, empty{&bare, &studied, {}};

  std::vector<std::string> names;
  for (const StudyPages& pages : {magnification_pages(), adhesion_pages()}) {
    for (const Figure& figure : pages.figures({{&drawn, 1}}))
      names.push_back(figure.name);
    EXPECT_TRUE(pages.figures({{&empty, 1}}).empty());
  }

  EXPECT_EQ(names, (std::vector<std::string>{
                       "magnification-separation", "magnification-parts",
                       "magnification-opening", "separation-distributions-1",
                       "separation-distributions-2", "adhesion-branches",
                       "adhesion-equilibrium", "adhesion-height"}));
}

} // namespace asperity::studies::theory_studies_test
