// Properties of pairs that the table of combinations_test.cpp names: limits of
// laws, two ways to the same load, and two ways to the same map.
#include "input/reader/read_case.hpp"
#include "results/result_reader.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/method_columns.hpp"
#include "run/run_case.hpp"
#include "studies/flow/flow.hpp"
#include "studies/friction/partial_slip.hpp"
#include "studies/spots/spots.hpp"
#include "tests/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::run::combined_studies_test {

using Entries = std::vector<std::string>;
using results::CurvePoint;
using results::MethodRecord;
using results::Result;

constexpr const char* rough = R"(schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 32
seed = 5
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "1 length"
wavelength_short = "4 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["4 MPa", "10 MPa", "30 MPa"]
[halfspace]
tolerance = 1e-11
[flow]
viscosity = 1e-3
pressure_drop = 1e5
[spots]
[conductance]
thermal_conductivity = 50.0
counter_thermal_conductivity = 16.0
gap_conductivity = 0.026
smallest_gap = 70e-9
[friction]
coefficient = 0.3
[report]
stress_inside = true
fields = "all"
)";

/// Columns of contact and of the studies that do not depend on the size of the
/// map.
const std::vector<const char*> contact_columns{
    "area_fraction",        "spots_percolate_x",        "spots_percolate_y",
    "gap_percolates_x",     "gap_percolates_y",         "spot_radii",
    "relative_conductance", "relative_gap_conductance", "thermal_conductance"};
const std::vector<const char*> flow_columns{
    "flow_factor_x",  "flow_factor_y",  "flow_conductance_x",
    "critical_gap_x", "critical_gap_y", "effective_medium"};

std::vector<const char*> all_columns() {
  std::vector<const char*> all = contact_columns;
  all.insert(all.end(), flow_columns.begin(), flow_columns.end());
  return all;
}

class CombinedStudies : public tests::FolderTest {
protected:
  Result run(const Entries& entries) {
    const std::filesystem::path out = folder / fmt::format("out-{}", n_runs_++);
    case_ =
        cases::read_case_text(rough, (folder / "case.toml").string(), entries);
    run_case(case_, {out, {}, false, 1});
    return results::read_result(out);
  }

  void write_map(const std::string& name, const Grid& grid,
                 const std::vector<double>& heights) const {
    std::ofstream map(folder / name);
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix)
        map << fmt::format("{:.17e}{}", heights[grid.index(ix, iy)],
                           ix + 1 == grid.points_x ? '\n' : ' ');
  }

  /// Expects the same rows of the only method of a problem on the way back, by
  /// a list that falls, and, if it can be, by the mean gap.
  void expect_no_path(const Entries& problem, bool has_gaps);

  cases::Case case_; ///< of the last run

private:
  int n_runs_ = 0;
};

const MethodRecord& method_of(const Result& result, const std::string& name) {
  return *std::ranges::find(result.methods, name, &MethodRecord::name);
}

const std::vector<CurvePoint>& rows_of(const Result& result,
                                       const std::string& name) {
  return method_of(result, name).realizations.front().points;
}

bool are_same(const std::vector<double>& one,
              const std::vector<double>& other) {
  return std::ranges::equal(one, other, [](double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
  });
}

void expect_same(const CurvePoint& found, const CurvePoint& expected,
                 const std::vector<const char*>& columns, double tolerance) {
  for (const char* const name : columns) {
    const results::CurveColumn& column = results::curve_column(name);
    const double own = column.get(expected);
    ASSERT_TRUE(std::isfinite(own)) << name << ": " << expected.note;
    EXPECT_NEAR(column.get(found), own, tolerance * std::abs(own))
        << name << " of step " << found.step << ": " << found.note;
  }
}

/// Entries that make a variant of [halfspace] nearly hard contact.
Entries nearly_hard(const mechanics::ContactLawTraits& law) {
  const std::string variant = fmt::format("halfspace.like-{}", law.name);
  Entries entries{fmt::format("{}.contact={}", variant, law.name)};
  if (law.needs_penalty)
    entries.push_back(variant + ".penalty=1e6 E*/h");
  if (mechanics::is_adhesive(law.law)) {
    entries.push_back(variant + ".work_of_adhesion=1e-10");
    entries.push_back(variant + ".range=2e-13");
  }
  return entries;
}

void expect_stress(const Result& result, const std::string& method) {
  const results::Table* const hard = result.table("stress-inside-halfspace");
  const results::Table* const own = result.table("stress-inside-" + method);
  ASSERT_NE(hard, nullptr);
  ASSERT_NE(own, nullptr);
  const std::vector<double> expected = hard->values("von_mises");
  const std::vector<double> found = own->values("von_mises");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-3);
}

void expect_slip(const Result& result, const cases::Case& read,
                 const std::string& method) {
  const auto hard =
      studies::partial_slips(result, read, method_of(result, "halfspace"));
  const auto own =
      studies::partial_slips(result, read, method_of(result, method));
  ASSERT_EQ(own.size(), 1U);
  ASSERT_EQ(own.front().size(), hard.front().size());
  for (std::size_t i = 0; i < own.front().size(); ++i)
    EXPECT_NEAR(own.front()[i].slip.displacement.x /
                    hard.front()[i].slip.displacement.x,
                1.0, 1e-3);
}

/// Tables of [magnification] and of the largest stresses, but for their places:
/// images have several. `tolerance` is relative.
void expect_same_tables(const Result& result, const Result& other,
                        double tolerance) {
  ASSERT_EQ(result.tables.size(), other.tables.size());
  for (const results::Table& table : other.tables)
    for (const results::Column& column : table.columns) {
      if (!(table.name.starts_with("stress-inside") ||
            table.name == "magnification") ||
          column.name == "x" || column.name == "y")
        continue;
      const std::vector<double> found =
          result.table(table.name)->values(column.name);
      ASSERT_EQ(found.size(), column.values.size())
          << table.name << ", " << column.name;
      const double scale = std::abs(*std::ranges::max_element(
          column.values, {}, [](double x) { return std::abs(x); }));
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], column.values[i], tolerance * scale)
            << table.name << ", " << column.name << " " << i;
    }
}

/// Compares the methods of two cases. One step of `other` is on a map that is
/// `n_maps` times as large.
void expect_same_methods(const Result& result, const Result& other,
                         double n_maps) {
  for (const MethodRecord& method : other.methods) {
    SCOPED_TRACE(method.name);
    CurvePoint expected = method.realizations.front().points.front();
    const CurvePoint& found = rows_of(result, method.name).front();
    if (method.name == "theory") {
      expect_same(found, expected, {"area_fraction", "mean_gap"}, 1e-8);
      continue;
    }
    const bool is_iterated = method.name.find("like-") != method.name.npos;
    expect_same(found, expected, all_columns(), is_iterated ? 1e-5 : 1e-8);
    expected[columns::normal_stiffness] /= n_maps;
    for (const char* const stiffness :
         {"normal_stiffness", "stick_stiffness_x"})
      if (std::isfinite(results::curve_column(stiffness).get(expected)))
        expect_same(found, expected, {stiffness}, 1e-6);
  }
  expect_same_tables(result, other, 1e-6);
}

/// Compares every method of a case with [halfspace].
void expect_hard_contact(const Result& result, const cases::Case& read) {
  const std::vector<CurvePoint>& hard = rows_of(result, "halfspace");
  for (const cases::MethodSpec& method : read.methods) {
    SCOPED_TRACE(method.name);
    const std::vector<CurvePoint>& rows = rows_of(result, method.name);
    ASSERT_EQ(rows.size(), hard.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      expect_same(rows[i], hard[i], contact_columns, 1e-3);
      // Faces that attract each other without a wall penetrate by their range.
      if (!method.is_adhesive() || mechanics::has_wall(method.contact()->law))
        expect_same(rows[i], hard[i], flow_columns, 1e-3);
    }
    if (read.report.stress_inside)
      expect_stress(result, method.name);
    if (cases::has_partial_slip(method, read.material))
      expect_slip(result, read, method.name);
  }
}

/// [halfspace] with hard contact, and beside it a method with each other law.
Entries with_every_law() {
  Entries entries{"halfspace.like-hardness.hardness=1e3 E*"};
  for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
    if (law.law != mechanics::ContactLaw::hard)
      for (const std::string& entry : nearly_hard(law))
        entries.push_back(entry);
  return entries;
}

// A law that tends to hard contact has its contact, conductance, flow, stress
// and slip. Tolerance: the penetration and the range of the law are 1e-5 h_rms.
TEST_F(CombinedStudies, OfEveryLawInItsLimitAreThoseOfHardContact) {
  Entries entries = with_every_law();
  expect_hard_contact(run(entries), case_);
  entries.emplace_back("surface.edges=free");
  entries.emplace_back("report.stress_inside=false"); // of a periodic block
  expect_hard_contact(run(entries), case_);
}

// Without memory, a load has one answer: on the way back, and by the mean gap
// that it was found to have.
TEST_F(CombinedStudies, OfALoadDoNotDependOnThePath) {
  for (const Entries& law :
       {Entries{},
        Entries{"halfspace.contact=penalty", "halfspace.penalty=10 E*/h"},
        Entries{"halfspace.contact=augmented", "halfspace.penalty=10 E*/h"}}) {
    Entries entries = law;
    entries.emplace_back("load.cycle=load-unload");
    const Result cycle = run(entries);
    const std::vector<CurvePoint>& rows = rows_of(cycle, "halfspace");
    ASSERT_EQ(rows.size(), 5U);
    for (std::size_t i = 0; i < 2; ++i)
      expect_same(rows[4 - i], rows[i], all_columns(), 1e-6);

    entries = law;
    entries.push_back(fmt::format("load={{ mean_gap = [{:.17e}, {:.17e}] }}",
                                  rows[1].mean_gap, rows[2].mean_gap));
    const Result by_gap = run(entries);
    for (std::size_t i = 0; i < 2; ++i) {
      const CurvePoint& found = rows_of(by_gap, "halfspace")[i];
      EXPECT_NEAR(found.nominal_pressure / rows[i + 1].nominal_pressure, 1.0,
                  1e-6);
      expect_same(found, rows[i + 1], all_columns(), 1e-5);
    }
  }
}

// A map that is continued is the periodic map of the heights of its cell, by
// every law and with every study: a window changes them, mirror images are four
// times as many.
TEST_F(CombinedStudies, OfAContinuedMapAreThoseOfItsCell) {
  Entries methods = with_every_law();
  methods.emplace_back("load.nominal_pressure=10 MPa");
  const Result periodic = run(methods);
  const results::SurfaceRecord& surface = periodic.surfaces.front();
  write_map("map.txt", surface.grid, surface.heights);
  const auto pressed = [&](const std::string& file, const std::string& edges,
                           double length) {
    Entries entries = methods;
    entries.push_back(
        fmt::format("surface={{ kind = \"measured\", file = \"{}\", "
                    "length = {:.17e}, height_unit = 1.0, level = "
                    "\"none\", edges = \"{}\"{} }}",
                    file, length, edges,
                    edges == "window" ? ", press_windowed_map = true" : ""));
    return run(entries);
  };
  const Grid& grid = surface.grid;

  const Result same = pressed("map.txt", "periodic", grid.length_x);
  const Result window = pressed("map.txt", "window", grid.length_x);
  const results::SurfaceRecord& windowed = window.surfaces.front();
  write_map("windowed.txt", windowed.grid, windowed.heights);
  const Result of_windowed =
      pressed("windowed.txt", "periodic", windowed.grid.length_x);

  expect_same_methods(same, periodic, 1.0);
  expect_same_methods(of_windowed, window, 1.0);

  // The spectrum of a window is corrected for it; that of images is not.
  methods.emplace_back("theory.gamma=0.4");
  methods.emplace_back(
      "magnification={ reference_wavelength = 1e-6, nominal_pressure = 1e6, "
      "from = 1.0, to = 8.0, points = 2 }");
  const Result mirrored = pressed("map.txt", "mirror", grid.length_x);
  const Grid images{2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
                    2.0 * grid.length_y};
  std::vector<double> heights(images.size());
  for (int iy = 0; iy < images.points_y; ++iy)
    for (int ix = 0; ix < images.points_x; ++ix)
      heights[images.index(ix, iy)] =
          surface.heights[grid.index(std::min(ix, images.points_x - 1 - ix),
                                     std::min(iy, images.points_y - 1 - iy))];
  write_map("images.txt", images, heights);
  const Result cell = pressed("images.txt", "periodic", images.length_x);
  expect_same_methods(mirrored, cell, 4.0);
}

void CombinedStudies::expect_no_path(const Entries& problem, bool has_gaps) {
  constexpr double tolerance = 1e-5; // of full blocks; atoms: 1e-8 of forces
  const auto by = [&](const std::string& load) {
    Entries entries = problem;
    entries.push_back("load={ " + load + " }");
    return run(entries).methods.front().realizations.front().points;
  };
  const std::vector<CurvePoint> rows =
      by("nominal_pressure = [\"2e-3 E*\", \"1e-2 E*\"], cycle = "
         "\"load-unload\"");
  const std::vector<CurvePoint> list =
      by("nominal_pressure = [\"2e-3 E*\", \"1e-2 E*\", \"2e-3 E*\"]");
  ASSERT_EQ(rows.size(), 3U);
  ASSERT_EQ(list.size(), 3U);
  const std::vector<const char*> columns{"area_fraction", "mean_gap"};
  expect_same(rows[2], rows[0], columns, tolerance);
  for (std::size_t i = 0; i < 3; ++i)
    expect_same(list[i], rows[i], columns, tolerance);
  if (!has_gaps)
    return;
  const std::vector<CurvePoint> gaps =
      by(fmt::format("mean_gap = [{:.17e}, {:.17e}], cycle = \"load-unload\"",
                     rows[0].mean_gap, rows[1].mean_gap));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(gaps[i].nominal_pressure / rows[i].nominal_pressure, 1.0,
                10.0 * tolerance)
        << i;
}

/// A surface of 16 x 16 atoms.
const std::string of_atoms =
    "kind = \"self-affine\", length = \"4.16 nm\", points = 16, seed = 5, "
    "rms_slope = 0.1, hurst = 0.8, wavelength_long = \"1 length\", "
    "wavelength_roll_off = \"1 length\", wavelength_short = \"4 h\"";

/// What every method can press, atoms too.
const Entries of_any_method{"flow=",
                            "friction=",
                            "conductance=",
                            "spots=",
                            "report.stress_inside=false",
                            "material.youngs_modulus=77.2 GPa"};

std::vector<Entries> each_method() {
  const Entries fem{"halfspace=", "fem.element=Q1", "fem.growth=2.0",
                    "fem.tolerance=1e-11"};
  Entries full = fem;
  full.back() = "fem.tolerance=1e-9";
  full.emplace_back("fem.solver=full");
  return {{},
          {"halfspace=", "theory.gamma=0.4"},
          {"halfspace=", "winkler.stiffness=1 E*/h"},
          {"halfspace=", "md.atoms=16", "md.interaction_energy=74.4 meV",
           "md.interaction_distance=3.28 angstrom", "md.cutoff=10 angstrom",
           "md.contact_distance=4.3615 angstrom", "md.tolerance=1e-8"},
          fem,
          full};
}

/// Mirror images of the first half of the columns and rows of a periodic map.
std::vector<double> mirrored_quarter(const Grid& grid,
                                     const std::vector<double>& heights) {
  std::vector<double> images(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      images[grid.index(ix, iy)] =
          heights[grid.index(std::min(ix, grid.points_x - 1 - ix),
                             std::min(iy, grid.points_y - 1 - iy))];
  return images;
}

// So does every method, on a problem that atoms can have, too. Without images
// on a free surface, the methods without free boundaries have mirror images.
TEST_F(CombinedStudies, OfEveryMethodOfAContinuedMapAreThoseOfItsCell) {
  Entries methods = of_any_method;
  for (const Entries& method : each_method())
    for (const std::string& entry : method)
      if (entry != "halfspace=" && !entry.starts_with("fem."))
        methods.push_back(entry);
  methods.insert(methods.end(),
                 {"halfspace=", "fem.element=Q1", "fem.growth=2.0",
                  "fem.tolerance=1e-11", "fem.full.solver=full",
                  "fem.full.tolerance=1e-9",
                  "load.nominal_pressure=[\"2e-3 E*\", \"1e-2 E*\"]"});
  const auto pressed = [&](const std::string& surface) {
    Entries entries = methods;
    entries.push_back("surface={ " + surface + " }");
    return run(entries);
  };
  const auto map = [&](const std::string& file, const Grid& grid,
                       const std::vector<double>& heights,
                       const std::string& edges) {
    write_map(file, grid, heights);
    return pressed(fmt::format(
        "kind = \"measured\", file = \"{}\", length = {:.17e}, height_unit = "
        "1.0, level = \"none\", edges = \"{}\"{}",
        file, grid.length_x, edges,
        edges == "window" ? ", press_windowed_map = true" : ""));
  };
  const Result periodic = pressed(of_atoms);
  const results::SurfaceRecord& surface = periodic.surfaces.front();
  const Grid& grid = surface.grid;
  const Grid quarter{grid.points_x / 2, grid.points_y / 2, 0.5 * grid.length_x,
                     0.5 * grid.length_y};
  std::vector<double> corner(quarter.size());
  for (int iy = 0; iy < quarter.points_y; ++iy)
    for (int ix = 0; ix < quarter.points_x; ++ix)
      corner[quarter.index(ix, iy)] = surface.heights[grid.index(ix, iy)];

  const auto expect_same_contact = [](const Result& one, const Result& other) {
    ASSERT_EQ(one.methods.size(), 5U);
    for (const MethodRecord& method : one.methods)
      for (std::size_t i = 0; i < 2; ++i) {
        SCOPED_TRACE(method.name);
        expect_same(rows_of(other, method.name)[i],
                    method.realizations.front().points[i],
                    {"area_fraction", "mean_gap"}, 1e-6);
      }
  };
  const Result window = map("map.txt", grid, surface.heights, "window");
  expect_same_contact(map("windowed.txt", window.surfaces.front().grid,
                          window.surfaces.front().heights, "periodic"),
                      window);
  const Result cell = map("cell.txt", grid,
                          mirrored_quarter(grid, surface.heights), "periodic");
  for (const char* edges : {"mirror", "free"})
    expect_same_contact(map("corner.txt", quarter, corner, edges), cell);
}

TEST_F(CombinedStudies, OfEveryMethodDoNotDependOnThePath) {
  for (const Entries& method : each_method()) {
    SCOPED_TRACE(method.empty() ? "halfspace" : method[1]);
    Entries entries = of_any_method;
    entries.insert(entries.end(), method.begin(), method.end());
    entries.push_back("surface={ " + of_atoms + " }");
    expect_no_path(entries, true);
  }
}

TEST_F(CombinedStudies, OfEveryEdgesDoNotDependOnThePath) {
  const Result made = run({"report.stress_inside=false"});
  write_map("map.txt", made.surfaces.front().grid,
            made.surfaces.front().heights);
  for (const std::string edges : {"periodic", "window", "mirror", "free"}) {
    SCOPED_TRACE(edges);
    Entries entries = of_any_method;
    entries.push_back(
        "surface={ kind = \"measured\", file = \"map.txt\", length = \"1 um\", "
        "height_unit = 1.0, level = \"none\", edges = \"" +
        edges + "\"" +
        (edges == "window" ? ", press_windowed_map = true }" : " }"));
    expect_no_path(entries, edges != "free");
  }
}

// A surface that has yielded is stiff as in its elastic unloading, because
// nodes at the hardness carry no more: K is the slope of a small step back.
TEST_F(CombinedStudies, OfAYieldedContactHaveTheStiffnessOfItsUnloading) {
  const Result result =
      run({"halfspace.hardness=100 MPa", "halfspace.tolerance=1e-12",
           "friction=", "load.nominal_pressure=[10e6, 9.9999e6]"});
  const std::vector<CurvePoint>& rows = rows_of(result, "halfspace");
  ASSERT_GT(rows[0][columns::plastic_area], 0.01);
  ASSERT_EQ(rows[0].area_fraction, rows[1].area_fraction);
  EXPECT_FALSE(rows[0].is_unloading);
  EXPECT_TRUE(rows[1].is_unloading);
  const double slope = (rows[0].nominal_pressure - rows[1].nominal_pressure) /
                       (rows[1].mean_gap - rows[0].mean_gap);
  const double area = 1e-12;
  EXPECT_NEAR(rows[0][columns::normal_stiffness] / (slope * area), 1.0, 1e-4);
}

// The theory of yielding contact is that of first load.
TEST_F(CombinedStudies, OfATheoryWithAHardnessEndAtTheLargestLoad) {
  const Result result =
      run({"theory.gamma=0.4", "theory.hardness=200 MPa",
           "load.cycle=load-unload", "report.stress_inside=false", "flow="});
  const std::vector<CurvePoint>& rows = rows_of(result, "theory");
  ASSERT_EQ(rows.size(), 5U);
  for (const CurvePoint& row : rows) {
    EXPECT_EQ(std::isnan(row.area_fraction), row.is_unloading);
    EXPECT_EQ(std::isnan(row[columns::plastic_area]), row.is_unloading);
    EXPECT_EQ(row.note.find("the theory knows no imprint") != row.note.npos,
              row.is_unloading)
        << row.note;
  }
}

// A wave is one shell of its spectrum: where it is resolved, 1 - A opens to
// u_1 = u/(1 - A), and the effective medium has K = u_1^3 (1 - 2A).
TEST_F(CombinedStudies, OfTheTheoryOfAWaveAreThoseOfItsOneGap) {
  const Result result =
      run({"theory.gamma=0.4", "report.stress_inside=false",
           "load.nominal_pressure=[\"1 MPa\", \"10 MPa\"]",
           "surface={ kind = \"wave-2d\", length = 1e-6, points = 16, "
           "amplitude = 1e-8, wavelength = 1e-6 }"});
  for (const CurvePoint& row : rows_of(result, "theory")) {
    const double open = 1.0 - row.area_fraction;
    EXPECT_NEAR(row[columns::effective_medium] /
                    (std::pow(row.mean_gap / open, 3.0) * (2.0 * open - 1.0)),
                1.0, 1e-9);
  }
}

// A gap that is smaller than the smallest number leaves no flow factor.
TEST_F(CombinedStudies, OfATheoryWithoutAGapSayThatItHasNoFlowFactor) {
  const Result result = run({"theory.gamma=0.4", "report.stress_inside=false",
                             "load.nominal_pressure=46 E* h'"});
  const CurvePoint& row = rows_of(result, "theory").front();
  EXPECT_EQ(row[columns::flow_conductance.x], 0.0);
  EXPECT_TRUE(std::isnan(row[columns::flow_factor.x]));
  EXPECT_NE(row.note.find("flow_factor_x is not determined: the mean gap is "
                          "too small"),
            std::string::npos)
      << row.note;
}

// Loads in a list that falls are on the way back, as those of a cycle; where
// the answer does not depend on the path, neither kind of law tells them apart.
TEST_F(CombinedStudies, OfAListThatFallsAreThoseOfACycle) {
  for (const Entries& law :
       {Entries{"halfspace.contact=exponential",
                "halfspace.work_of_adhesion=2 mJ/m^2", "friction="},
        Entries{},
        Entries{"halfspace.contact=penalty", "halfspace.penalty=10 E*/h"},
        Entries{"halfspace.contact=augmented", "halfspace.penalty=10 E*/h"}}) {
    Entries entries = law;
    entries.emplace_back("load.cycle=load-unload");
    const Result cycle = run(entries);
    entries = law;
    entries.emplace_back("load.nominal_pressure=[4e6, 1e7, 3e7, 1e7, 4e6]");
    const Result list = run(entries);
    const std::vector<CurvePoint>& expected = rows_of(cycle, "halfspace");
    ASSERT_EQ(expected.size(), 5U);
    const bool has_memory = law.size() == 3;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const CurvePoint& found = rows_of(list, "halfspace")[i];
      EXPECT_EQ(found.is_unloading, has_memory && expected[i].is_unloading);
      EXPECT_EQ(found.mean_gap, expected[i].mean_gap) << i;
      expect_same(found, expected[i], all_columns(), 0.0);
    }
  }
}

// A map that is turned by a quarter has the numbers of x along y, by every
// method whose block has no direction of its own.
TEST_F(CombinedStudies, OfATurnedMapAreTurned) {
  const Result made = run({"report.stress_inside=false"});
  const results::SurfaceRecord& surface = made.surfaces.front();
  const Grid& grid = surface.grid;
  std::vector<double> turned(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      turned[grid.index(iy, ix)] = surface.heights[grid.index(ix, iy)];
  write_map("map.txt", grid, surface.heights);
  write_map("turned.txt", grid, turned);
  const auto pressed = [&](const std::string& file) {
    return run({"surface={ kind = \"measured\", file = \"" + file +
                    "\", length = 1e-6, height_unit = 1.0, level = \"none\", "
                    "edges = \"periodic\" }",
                "halfspace.slab.thickness=0.5 length",
                "halfspace.island.boundaries=free", "winkler.stiffness=1 E*/h",
                "fem.element=Q1", "fem.growth=2.0", "fem.tolerance=1e-11",
                "fem.second.element=Q2", "fem.full.solver=full",
                "fem.full.tolerance=1e-9", "report.stress_inside=false"});
  };
  const Result along_x = pressed("map.txt");
  const Result along_y = pressed("turned.txt");
  for (const MethodRecord& method : along_x.methods)
    for (std::size_t i = 0; i < 3; ++i) {
      SCOPED_TRACE(method.name);
      CurvePoint back = rows_of(along_y, method.name)[i];
      std::swap(back[columns::flow_factor.x], back[columns::flow_factor.y]);
      std::swap(back[columns::flow_conductance.x],
                back[columns::flow_conductance.y]);
      std::swap(back[columns::critical_gap.x], back[columns::critical_gap.y]);
      std::swap(back[columns::spots_percolate.x],
                back[columns::spots_percolate.y]);
      std::swap(back[columns::gap_percolates.x],
                back[columns::gap_percolates.y]);
      expect_same(back, method.realizations.front().points[i], all_columns(),
                  1e-5);
    }
}

// With adhesion the larger side of a pixel decides what the grid resolves, so
// that the range, which is not stated here, is the same for a turned map.
TEST_F(CombinedStudies, OfATurnedMapWithAdhesionAndLongPixelsAreTurned) {
  const Entries common{"friction=", "report.stress_inside=false"};
  const Result made = run(common);
  const results::SurfaceRecord& surface = made.surfaces.front();
  const Grid& grid = surface.grid;
  std::vector<double> turned(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      turned[grid.index(iy, ix)] = surface.heights[grid.index(ix, iy)];
  write_map("map.txt", grid, surface.heights);
  write_map("turned.txt", grid, turned);
  const auto pressed = [&](const std::string& file, double x, double y) {
    Entries entries = common;
    entries.insert(
        entries.end(),
        {fmt::format("surface={{ kind = \"measured\", file = \"{}\", length = "
                     "{}, length_y = {}, height_unit = 1.0, level = \"none\", "
                     "edges = \"periodic\" }}",
                     file, x, y),
         "halfspace.contact=dugdale", "halfspace.work_of_adhesion=1e-4"});
    return run(entries);
  };
  const Result along_x = pressed("map.txt", 1e-6, 3e-6);
  const Result along_y = pressed("turned.txt", 3e-6, 1e-6);
  for (std::size_t i = 0; i < 3; ++i) {
    const CurvePoint& back = rows_of(along_y, "halfspace")[i];
    expect_same(back, rows_of(along_x, "halfspace")[i],
                {"area_fraction", "mean_gap", "adhesive_energy",
                 "attractive_load", "thermal_conductance"},
                1e-5);
  }
}

// The tables of the theory are those of the surface, whatever presses it.
TEST_F(CombinedStudies, OfTheTheoryDoNotDependOnTheMethods) {
  const Entries studies{
      "theory.gamma=0.4", "report.stress_inside=false", "flow=",
      "magnification={ nominal_pressure = 1e6, from = 1.0, to = 8.0, points = "
      "2 }",
      "adhesion={ work_of_adhesion = 0.1, from = 0.5, to = 1.5, points = 2, "
      "steps = 20 }"};
  const Result alone = run(studies);
  ASSERT_EQ(alone.tables.size(), 5U);
  for (const Entries& other :
       {Entries{"halfspace.contact=exponential",
                "halfspace.work_of_adhesion=2 mJ/m^2"},
        Entries{"halfspace.hardness=100 MPa"}, Entries{"surface.edges=free"},
        Entries{"winkler.stiffness=1 E*/h", "fem.element=Q1"}}) {
    Entries entries = studies;
    entries.insert(entries.end(), other.begin(), other.end());
    const Result beside = run(entries);
    for (const results::Table& table : alone.tables) {
      const results::Table* const found = beside.table(table.name);
      ASSERT_NE(found, nullptr) << table.name;
      for (const results::Column& column : table.columns)
        EXPECT_TRUE(are_same(found->values(column.name), column.values))
            << table.name << ", " << column.name;
    }
  }
}

} // namespace asperity::run::combined_studies_test
