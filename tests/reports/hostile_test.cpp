// Tests of reports with degenerate results: no curve, map, surface or table of
// a result ends a report, and what cannot be determined has a reason.
#include "base/special_numbers.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/pages/report.hpp"
#include "studies/adhesion/adhesion.hpp"
#include "studies/magnification/magnification.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::hostile_test {

using results::CurvePoint;
using results::Result;

struct Hostile {
  std::string name;
  std::function<void(Result&)> change;
};

/// Changes every row of every method except the theory.
std::function<void(Result&)> of_rows(std::function<void(CurvePoint&)> change) {
  return [change](Result& result) {
    for (results::Curve& curve : result.methods.at(1).realizations)
      for (CurvePoint& point : curve.points)
        change(point);
  };
}

/// Changes every saved map.
std::function<void(Result&)>
of_maps(std::function<void(results::Fields&)> change) {
  return [change](Result& result) {
    for (results::Fields& fields : result.methods.at(1).realizations[0].fields)
      change(fields);
  };
}

/// Changes every surface and states its statistics as they would be measured.
std::function<void(Result&)>
of_surfaces(std::function<void(results::SurfaceRecord&)> change) {
  return [change](Result& result) {
    for (results::SurfaceRecord& surface : result.surfaces)
      change(surface);
  };
}

void fill(std::vector<double>& numbers, double number) {
  std::fill(numbers.begin(), numbers.end(), number);
}

std::vector<Hostile> hostile_curves() {
  return {
      {"no rows", [](Result& r) { r.methods[1].realizations[0].points = {}; }},
      {"one row",
       [](Result& r) { r.methods[1].realizations[0].points.resize(1); }},
      {"two rows",
       [](Result& r) { r.methods[1].realizations[0].points.resize(2); }},
      {"a theory of one row",
       [](Result& r) { r.methods[0].realizations[0].points.resize(1); }},
      {"no theory", [](Result& r) { r.methods.erase(r.methods.begin()); }},
      {"no realisations", [](Result& r) { r.methods[1].realizations = {}; }},
      {"no theory rows",
       [](Result& r) { r.methods[0].realizations[0].points = {}; }},
      {"no methods", [](Result& r) { r.methods = {}; }},
      {"flat", of_rows([](CurvePoint& p) { p.mean_gap = 1e-8; })},
      {"one load", of_rows([](CurvePoint& p) { p.nominal_pressure = 1e6; })},
      {"full contact", of_rows([](CurvePoint& p) {
         p.mean_gap = 0.0;
         p.area_fraction = p.area_fraction_corrected = 1.0;
       })},
      {"no contact", of_rows([](CurvePoint& p) {
         p.area_fraction = p.area_fraction_corrected = 0.0;
       })},
      {"NaN gaps", of_rows([](CurvePoint& p) { p.mean_gap = not_a_number; })},
      {"NaN areas", of_rows([](CurvePoint& p) {
         p.area_fraction = p.area_fraction_corrected = not_a_number;
       })},
      {"NaN loads",
       of_rows([](CurvePoint& p) { p.nominal_pressure = not_a_number; })},
      {"infinite loads",
       of_rows([](CurvePoint& p) { p.nominal_pressure = infinity; })},
      {"infinite areas",
       of_rows([](CurvePoint& p) { p.area_fraction = infinity; })},
      {"pulled", of_rows([](CurvePoint& p) { p.nominal_pressure *= -1.0; })},
      {"tiny loads",
       of_rows([](CurvePoint& p) { p.nominal_pressure *= 1e-300; })},
      {"not converged", of_rows([](CurvePoint& p) {
         p.status = results::StepStatus::not_converged;
       })},
      {"rising gaps", of_rows([](CurvePoint& p) {
         p.mean_gap = 1e-14 * p.nominal_pressure;
       })}};
}

std::vector<Hostile> hostile_maps() {
  return {{"no pixels", of_maps([](results::Fields& f) {
             f.pressure = {};
             f.gap = {};
           })},
          {"an open map",
           of_maps([](results::Fields& f) { fill(f.pressure, 0.0); })},
          {"a closed map", of_maps([](results::Fields& f) {
             fill(f.pressure, 1e6);
             fill(f.gap, 0.0);
           })},
          {"one node in contact", of_maps([](results::Fields& f) {
             fill(f.pressure, 0.0);
             f.pressure[7] = 1e9;
           })},
          {"a NaN pressure",
           of_maps([](results::Fields& f) { f.pressure[7] = not_a_number; })},
          {"an infinite pressure",
           of_maps([](results::Fields& f) { f.pressure[7] = infinity; })},
          {"a NaN gap",
           of_maps([](results::Fields& f) { f.gap[7] = not_a_number; })},
          {"a map of one node", of_maps([](results::Fields& f) {
             f.grid = {1, 1, 1e-6, 1e-6};
             f.pressure = {1e6};
             f.gap = {0.0};
           })},
          {"a grid that is not the map's",
           of_maps([](results::Fields& f) { f.grid.points_x = 3; })}};
}

std::vector<Hostile> hostile_surfaces() {
  using Surface = results::SurfaceRecord;
  return {
      {"no surface", [](Result& r) { r.surfaces = {}; }},
      {"no heights", of_surfaces([](Surface& s) { s.heights = {}; })},
      {"a flat surface", of_surfaces([](Surface& s) {
         fill(s.heights, 0.0);
         s.rms_height = s.rms_slope = s.highest = 0.0;
       })},
      {"flat heights", of_surfaces([](Surface& s) { fill(s.heights, 0.0); })},
      {"NaN heights",
       of_surfaces([](Surface& s) { s.heights[3] = not_a_number; })},
      {"infinite heights",
       of_surfaces([](Surface& s) { s.heights[3] = infinity; })},
      {"NaN statistics", of_surfaces([](Surface& s) {
         s.rms_height = s.rms_slope = s.highest = not_a_number;
       })},
      {"an infinite rms height",
       of_surfaces([](Surface& s) { s.rms_height = infinity; })},
      {"a tiny rms height",
       of_surfaces([](Surface& s) { s.rms_height = 1e-300; })},
      {"no spectrum", of_surfaces([](Surface& s) { s.spectrum = {}; })},
      {"a NaN spectrum", of_surfaces([](Surface& s) {
         for (results::SpectrumPoint& point : s.spectrum)
           point.spectrum = not_a_number;
       })},
      {"one node", of_surfaces([](Surface& s) {
         s.grid = {1, 1, 1e-6, 1e-6};
         s.heights = {0.0};
       })}};
}

std::vector<Hostile> hostile_tables() {
  const auto with = [](std::vector<results::Table> tables) {
    return [tables](Result& result) { result.tables = tables; };
  };
  const results::Column two{"nominal_pressure", "Pa", {1e6, 2e6}};
  const results::Column none{"von_mises", "Pa", {}};
  return {{"a table of stresses without them",
           with({{"stress-inside-fem", "", {two, none}},
                 {"stress-section-fem", "", {none}}})},
          {"magnifications without columns",
           with({{"magnification",
                  "",
                  {two,
                   {"contact_weight", "1", {0.1, 0.2}},
                   {"rms_height", "m", {}}}},
                 {"magnification-1", "", {{"magnification", "1", {1.0, 2.0}}}},
                 {"gap-distribution-1", "", {{"gap", "m", {1e-9}}}}})},
          {"adhesion without columns",
           with({{"adhesion", "", {two}}, {"adhesion-flip", "", {}}})}};
}

class HostileResult : public ReportFolder {
protected:
  HostileResult() {
    rough.expectations.push_back({"kappa_counted", 0.0, 9.0, {"fem"}});
    rough.studies.ask(studies::MagnificationStudy{});
    rough.studies.ask(studies::AdhesionStudy{});
  }

  /// Writes a report of each; its summary is JSON.
  void write_all(const std::vector<Hostile>& all) {
    const Result whole = synthetic::rough_result(rough, 2);
    for (const Hostile& hostile : all) {
      SCOPED_TRACE(hostile.name);
      Result result = whole;
      hostile.change(result);
      EXPECT_NO_THROW(write(result, "no-such-gnuplot"));
      const auto json = nlohmann::json::parse(text_of(folder / "summary.json"),
                                              nullptr, false);
      EXPECT_FALSE(json.is_discarded());
      std::filesystem::remove_all(folder);
    }
  }
};

TEST_F(HostileResult, OfCurvesIsReported) {
  write_all(hostile_curves());
}

TEST_F(HostileResult, OfMapsIsReported) {
  write_all(hostile_maps());
}

TEST_F(HostileResult, OfSurfacesIsReported) {
  write_all(hostile_surfaces());
}

TEST_F(HostileResult, OfTablesIsReported) {
  write_all(hostile_tables());
}

// Shapes with exact solutions have quantities and figures of their own.
TEST_F(HostileResult, OfExactShapesIsReported) {
  for (const mechanics::SurfaceKind kind :
       {mechanics::SurfaceKind::sphere, mechanics::SurfaceKind::wave_1d,
        mechanics::SurfaceKind::wave_2d}) {
    rough.surface.kind = kind;
    rough.surface.radius = 1e-3;
    rough.surface.amplitude = 1e-9;
    rough.surface.wavelength = rough.surface.length.value();
    rough.material.poisson_ratio = 0.3;
    rough.expectations = {};
    rough.surface.kind = mechanics::SurfaceKind::self_affine;
    const Result whole = synthetic::rough_result(rough, 1);
    rough.surface.kind = kind;
    for (const auto& all : {hostile_curves(), hostile_tables()})
      for (const Hostile& hostile : all) {
        SCOPED_TRACE(hostile.name);
        Result result = whole;
        hostile.change(result);
        EXPECT_NO_THROW(write(result, "no-such-gnuplot"));
      }
  }
}

// Verifies that the reason of a missing number is stated where a reader looks
// for it.
TEST_F(HostileResult, ReportsWhatIsNotDetermined) {
  Result result = synthetic::rough_result(rough, 1);
  for (CurvePoint& point : result.methods[1].realizations[0].points)
    point.mean_gap = 0.0; // complete contact at every load
  result.tables = {};

  const Summary summary = summarize(result, rough);

  for (const char* name : {"gamma_slope", "gamma_curve", "beta"}) {
    const Estimate& estimate = summary.methods[1].quantities.at(name);
    EXPECT_FALSE(estimate.has_value()) << name;
    EXPECT_FALSE(estimate.remark.empty()) << name;
  }
  EXPECT_TRUE(summary.methods[1].problems.empty());
}

} // namespace asperity::reports::hostile_test
