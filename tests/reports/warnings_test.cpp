// Tests of reports/analysis/warnings.hpp: each assumption that a surface
// violates is reported once at the top of the page with its number, and a
// surface that satisfies them has no warning.
#include "reports/analysis/warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::warnings_test {

/// Each warning that a test meets has its line of at most 20 words.
std::vector<std::string> kinds(const std::vector<Warning>& warnings) {
  std::vector<std::string> names;
  for (const Warning& warning : warnings) {
    names.push_back(warning.kind);
    EXPECT_TRUE(warning.line.ends_with('.')) << warning.line;
    EXPECT_LT(std::ranges::count(warning.line, ' '), 20) << warning.line;
  }
  return names;
}

using Names = std::vector<std::string>;

class Warnings : public ReportFolder {
protected:
  results::Result result = synthetic::rough_result(rough, 2);
};

TEST_F(Warnings, AreNoneOfASurfaceThatMeetsTheAssumptions) {
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  rough.surface.kind = mechanics::SurfaceKind::measured;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
}

TEST_F(Warnings, NameTheNumberAndTheLimit) {
  for (results::SurfaceRecord& surface : result.surfaces) {
    surface.skewness = -6.0;
    surface.kurtosis = 59.0;
    surface.rms_slope = 0.9;
  }
  const std::vector<Warning> warnings = warnings_of(result, rough);
  ASSERT_EQ(kinds(warnings), (Names{"not_gaussian", "too_steep"}));
  EXPECT_EQ(warnings[0].headline,
            "The surface is not Gaussian: skewness -6 and kurtosis 59, but a "
            "Gaussian surface has 0 and 3 (limits: -1 to 1, 2 to 5).");
  EXPECT_EQ(warning_lines(result, rough),
            "warning: " + rough.name + ": " + warnings[0].line +
                "\nwarning: " + rough.name + ": " + warnings[1].line + "\n");
  EXPECT_NE(warnings[0].consequence.find("does not describe this surface"),
            std::string::npos);
  EXPECT_EQ(warnings[1].headline, "The surface is too steep for small strain: "
                                  "rms slope 0.9 (limit: 0.5).");
}

// A tilt is that of the user's map, whose images make a roof of it. Tolerance:
// the digits that are printed.
TEST_F(Warnings, NameATiltOfAMirroredMap) {
  rough.surface.kind = mechanics::SurfaceKind::measured;
  results::SurfaceRecord& surface = result.surfaces.front();
  const Grid grid = surface.grid;
  const int columns = grid.points_x / 2, rows = grid.points_y / 2;
  surface.map = {columns, rows};
  double square = 0.0;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const int x = std::min(ix, grid.points_x - 1 - ix);
      const int y = std::min(iy, grid.points_y - 1 - iy);
      const double height = 1e-8 * (x - 0.5 * (columns - 1)) + 1e-9 * (y % 2);
      surface.heights[grid.index(ix, iy)] = height;
      square += height * height / static_cast<double>(grid.size());
    }
  surface.rms_height = std::sqrt(square);

  const Names found = kinds(warnings_of(result, rough));

  EXPECT_NE(std::ranges::find(found, "tilted"), found.end());
}

// Curves without any contact are a warning and not a failure of a figure; if
// one step has a load or a tension, or none converged, there is no such
// warning.
TEST_F(Warnings, NameCurvesWithoutContact) {
  std::erase_if(result.methods, [](const results::MethodRecord& method) {
    return method.kind == "theory";
  });
  for (results::MethodRecord& method : result.methods)
    for (results::Curve& curve : method.realizations) {
      curve.fields.clear();
      for (results::CurvePoint& point : curve.points) {
        point.nominal_pressure = point.area_fraction = 0.0;
        point.mean_gap = 5.0 * result.surfaces[0].rms_height;
      }
    }
  const std::vector<Warning> warnings = warnings_of(result, rough);
  ASSERT_EQ(kinds(warnings), Names{"no_contact"});
  EXPECT_NE(warnings[0].headline.find("the smallest mean gap is 5 h_rms"),
            std::string::npos);
  EXPECT_EQ(write(result), std::vector<std::string>{});
  const std::string html = text_of(folder / "report.html");
  EXPECT_NE(html.find("No load step reaches contact"), std::string::npos);
  EXPECT_EQ(html.find("could not be drawn"), std::string::npos);

  results::Result loaded = result;
  for (const double pressure : {1e5, -1e5}) {
    loaded.methods[0].realizations[0].points[3].nominal_pressure = pressure;
    EXPECT_EQ(kinds(warnings_of(loaded, rough)), Names{}) << pressure;
  }
  for (results::MethodRecord& method : result.methods)
    for (results::Curve& curve : method.realizations)
      for (results::CurvePoint& point : curve.points)
        point.status = results::StepStatus::not_converged;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
}

// Finite elements that lock are named if the result contains them.
TEST_F(Warnings, NameElementsThatLock) {
  rough.material.poisson_ratio = 0.4999;
  cases::MethodSpec fem{.name = "fem", .settings = mechanics::FemSettings{}};
  std::get<mechanics::FemSettings>(fem.settings).block.element =
      mechanics::Element::q1;
  rough.methods = {fem};
  result.methods.clear();
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  result.methods.push_back({"fem", "fem", "", {}});
  const std::vector<Warning> warnings = warnings_of(result, rough);
  ASSERT_EQ(kinds(warnings), Names{"locking"});
  EXPECT_NE(warnings[0].headline.find("fem: Q1 elements lock at a Poisson's "
                                      "ratio of 0.4999"),
            std::string::npos);
}

// The moments are means over the realisations: one unusual realisation of two
// causes no warning, and a realisation without the number is not in the mean.
TEST_F(Warnings, AreOfTheMeanOverRealizations) {
  result.surfaces[0].skewness = 1.2;
  result.surfaces[1].skewness = -1.2;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  result.surfaces[1].skewness = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{"not_gaussian"});
}

// A checkerboard of nodes is not resolved; pairs of shifted lines are scan
// lines on a measured map, but not on a random surface.
TEST_F(Warnings, DetectUnresolvedSlopesAndScanLines) {
  results::SurfaceRecord& surface = result.surfaces[0];
  const Grid& grid = surface.grid;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      surface.heights[grid.index(ix, iy)] +=
          (ix + iy) % 2 == 0 ? 3.0 * surface.rms_height : 0.0;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{"not_resolved"});

  surface = synthetic::rough_result(rough, 1).surfaces[0];
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      surface.heights[grid.index(ix, iy)] +=
          (iy % 4 < 2 ? 0.3 : 0.0) * surface.rms_height;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  rough.surface.kind = mechanics::SurfaceKind::measured;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{"scan_lines"});
}

// A flat end of the spectrum is noise in a measured map: from the wavelength at
// which the surface has its density, with its share of the slope.
TEST_F(Warnings, DetectTheNoiseOfAMap) {
  results::SurfaceRecord& surface = result.surfaces[0];
  const double last = surface.spectrum.back().wavevector;
  double share = 0.0, whole = 0.0;
  const auto density = [&](double q) {
    return std::ranges::find_if(
               surface.spectrum,
               [&](const auto& row) { return row.wavevector >= q; })
        ->spectrum;
  };
  const double noise = density(last / 2.5);
  for (std::size_t i = 1; i < surface.spectrum.size(); ++i) {
    results::SpectrumPoint& row = surface.spectrum[i];
    row.spectrum += noise;
    const double square = std::pow(row.wavevector, 3) * row.spectrum *
                          (row.wavevector - surface.spectrum[i - 1].wavevector);
    whole += square;
    share += row.wavevector > last / 2.5 ? square : 0.0;
  }
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  rough.surface.kind = mechanics::SurfaceKind::measured;

  const std::vector<Warning> warnings = warnings_of(result, rough);

  ASSERT_EQ(kinds(warnings), Names{"noise"});
  double wavelength = 0.0, percent = 0.0;
  ASSERT_EQ(std::sscanf(warnings[0].headline.c_str(),
                        "The map contains noise of its instrument: beyond a "
                        "wavelength of %lf nm its spectrum is flat, and %lf %%",
                        &wavelength, &percent),
            2)
      << warnings[0].headline;
  EXPECT_NEAR(wavelength * last / (5e9 * std::numbers::pi), 1.0, 0.15);
  EXPECT_NEAR(percent, 100.0 * share / whole, 5.0);
}

TEST_F(Warnings, AreNoneOfExactShapesOrWithoutASurface) {
  result.surfaces[0].kurtosis = result.surfaces[1].kurtosis = 1.5;
  rough.surface.kind = mechanics::SurfaceKind::wave_1d;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
  rough.surface.kind = mechanics::SurfaceKind::measured;
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{"not_gaussian"});
  result.surfaces.clear();
  EXPECT_EQ(kinds(warnings_of(result, rough)), Names{});
}

// Page, summary.json and the facts of the run contain them.
TEST_F(Warnings, AreAtTheTopOfThePageAndInTheSummary) {
  result.provenance.emplace_back("window", "rms height 8 nm became 3 nm");
  for (results::SurfaceRecord& surface : result.surfaces)
    surface.kurtosis = 59.0;

  write(result, "no-such-gnuplot");

  const std::string html = text_of(folder / "report.html");
  const std::size_t window =
      html.find("The map was windowed before the contact was computed: rms "
                "height 8 nm became 3 nm.");
  const std::size_t moments = html.find("The surface is not Gaussian");
  EXPECT_LT(window, moments);
  EXPECT_LT(moments, html.find("expectations are"));
  const std::string json = text_of(folder / "summary.json");
  EXPECT_NE(json.find("\"kind\": \"windowed\""), std::string::npos);
  EXPECT_NE(json.find("\"kind\": \"not_gaussian\""), std::string::npos);
}

} // namespace asperity::reports::warnings_test
