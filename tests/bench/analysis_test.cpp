// Tests of the analysis of a benchmark against runs from a formula: an error c
// h^p of a known limit, a cost c n^e.
#include "base/json.hpp"
#include "input/reader/read_case.hpp"
#include "suite/bench/analysis/bench_analysis.hpp"
#include "suite/bench/analysis/bench_answer.hpp"
#include "suite/bench/pages/bench_report.hpp"
#include "tests/bench/rough_case.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace asperity::bench::analysis_test {

constexpr double gap_order = 2.0;
constexpr double area_order = 1.0;
constexpr double cost_exponent = 2.2;
constexpr double stiff = 0.01; ///< of the "fem": error of its own limit

const std::string rough = rough_case("[halfspace]\n[fem]\n");

BenchPoint point_on(const std::string& method, int points, double bias) {
  const double h = 1.0 / points;
  BenchPoint point;
  point.method = point.kind = method;
  point.label = std::to_string(points) + " points";
  point.points = points;
  point.answer.pressure = {1e6, 2e6};
  point.answer.rms_height = 1.0;
  point.answer.values["mean_gap"] = {1.0 + bias + 3.0 * std::pow(h, gap_order),
                                     0.5 + bias + 2.0 * std::pow(h, gap_order)};
  const double area = 1.0 + 5.0 * std::pow(h, area_order);
  point.answer.values["area_fraction"] = {0.1 * area, 0.2 * area};
  point.answer.values["area_fraction_corrected"] = {0.1, 0.2};
  point.cpu = {1e-5 * std::pow(points, cost_exponent), 0.0, 0.0};
  point.phases.solving = point.cpu.median;
  point.repeats = 1;
  return point;
}

Bench made_up() {
  Bench bench;
  bench.case_name = "rough, \"quoted\"";
  bench.case_hash = std::string(64, 'a');
  for (const char* method : {"halfspace", "fem"}) {
    BenchSeries series{
        .method = method, .axis = "surface.points", .title = "points"};
    for (const int points : {64, 128, 256, 512}) {
      const bool is_fem = std::string(method) == "fem";
      if (is_fem && points == 512)
        continue;
      series.points.push_back(bench.points.size());
      series.coordinates.push_back(1.0 / points);
      bench.points.push_back(point_on(method, points, is_fem ? stiff : 0.0));
      bench.points.back().is_own = points == 256;
      bench.points.back().is_reference = points == 512;
    }
    bench.series.push_back(series);
  }
  bench.reference.series = 0;
  return bench;
}

class BenchAnalysis : public ::testing::Test {
protected:
  BenchAnalysis() {
    analyse(bench, cases::read_case_text(rough, "rough/case.toml"));
  }

  Bench bench = made_up();
};

// Orders and cost exponent are recovered. Tolerance: 40 bits of a root from
// differences that are 1e-4 of the values; for the slope roundoff, since the
// limit is the reference solution.
TEST_F(BenchAnalysis, FindsOrdersAndCost) {
  const BenchSeries& series = bench.series[0];

  EXPECT_NEAR(series.orders.at("mean_gap").by_differences, gap_order, 1e-5);
  EXPECT_NEAR(series.orders.at("mean_gap").error.exponent, gap_order, 1e-4);
  EXPECT_NEAR(series.orders.at("area_fraction").error.exponent, area_order,
              1e-9);
  EXPECT_NEAR(series.cost.exponent, cost_exponent, 1e-9);
}

// An error of a method's own limit is an error with respect to the reference
// solution and not with respect to that limit. Tolerance: the magnitudes of the
// two are 1e-2 and 5e-5.
TEST_F(BenchAnalysis, DistinguishesTheMethodsLimitFromTheReference) {
  const BenchPoint& finest_fem = bench.points[bench.series[1].points.back()];

  EXPECT_NEAR(finest_fem.errors.at("mean_gap"), stiff, 1e-4);
  EXPECT_LT(finest_fem.own_errors.at("mean_gap"), 1e-4);
}

// Every estimator is compared with the corrected area. The data have an error
// of 5 h.
TEST_F(BenchAnalysis, HasOneReferenceForAllEstimators) {
  EXPECT_NEAR(bench.points[0].errors.at("area_fraction"), 5.0 / 64, 1e-12);
  EXPECT_EQ(bench.points[0].errors.at("area_fraction_corrected"), 0.0);
}

// The Pareto front contains the half-space at 64, 128 and 256 points: the
// finite elements cost as much and have an error larger by 0.01; the reference
// run itself at 512 points, the most accurate of all, is excluded. Where all
// solutions are exact, only the cheapest remains.
TEST_F(BenchAnalysis, PutsTheBestSettingsOnTheFront) {
  EXPECT_EQ(bench.fronts.at("mean_gap"), (std::vector<std::size_t>{0, 1, 2}));
  const auto& exact = bench.fronts.at("area_fraction_corrected");
  ASSERT_EQ(exact.size(), 1u);
  EXPECT_EQ(bench.points[exact[0]].points, 64);
}

// The error of an order p in h, on n = N^3 unknowns, falls as n^(-p/3); on a
// cost N^e as its power -p/e. Tolerance: roundoff.
TEST(BenchAnalysisOfBlocks, FitsErrorsAgainstUnknownsAndTime) {
  Bench bench = made_up();
  for (BenchPoint& point : bench.points)
    point.unknowns = std::pow(point.points, 3.0);

  analyse(bench, cases::read_case_text(rough, "rough/case.toml"));

  const BenchSeries& series = bench.series[0];
  EXPECT_NEAR(series.against_unknowns.at("area_fraction").exponent,
              -area_order / 3.0, 1e-9);
  EXPECT_NEAR(series.against_cpu_time.at("area_fraction").exponent,
              -area_order / cost_exponent, 1e-9);
}

// A pressure that exceeds that of Hertz by a tenth everywhere differs by a
// tenth of the mean pressure, and the exact solution has the value 0. One
// contact has free boundaries; periodic ones are an array. Tolerance: roundoff.
TEST(BenchAnswerOfASphere, HasTheDifferenceOfThePressureFromHertz) {
  const cases::Case contact_case = cases::read_case_text(
      bench_case("kind = \"sphere\"\nradius = \"10 length\"\n",
                 "[halfspace]\nboundaries = \"free\"\n"),
      "case.toml");
  const Grid grid{64, 64, 1e-6, 1e-6};
  results::Result result;
  results::Fields fields;
  fields.nominal_pressure = 1e6;
  fields.grid = grid;
  fields.pressure.reserve(grid.size());
  const theory::HertzContact hertz =
      theory::hertz_contact(1e-6, 10e-6, 2e9); // 1 MPa on a square micrometre
  for (int iy = 0; iy < 64; ++iy)
    for (int ix = 0; ix < 64; ++ix)
      fields.pressure.push_back(
          1.1 * theory::hertz_pressure(
                    hertz, grid.spacing_x() * std::hypot(ix - 32, iy - 32)));
  results::MethodRecord method;
  method.name = method.kind = "halfspace";
  method.realizations.resize(1);
  method.realizations.front().fields = {fields};
  result.methods = {method};

  const BenchAnswer answer = answer_of(result, contact_case, "halfspace");

  ASSERT_EQ(answer.values.at(pressure_field).size(), 1u);
  EXPECT_NEAR(answer.values.at(pressure_field)[0], 0.1, 1e-12);
  EXPECT_NEAR(
      error_against(exact_answer(contact_case, answer), answer, pressure_field),
      0.1, 1e-12);
}

std::vector<std::string> names_of(const std::vector<reports::Figure>& figures) {
  std::vector<std::string> names;
  names.reserve(figures.size());
  for (const reports::Figure& figure : figures)
    names.push_back(figure.name);
  return names;
}

// Blocks are compared if one of them has more unknowns than surface nodes.
TEST(BenchPage, ComparesFullBlocksOnly) {
  Bench bench = made_up();
  for (BenchPoint& point : bench.points)
    point.unknowns = std::pow(point.points, 2.0);
  const cases::Case contact_case =
      cases::read_case_text(rough, "rough/case.toml");
  analyse(bench, contact_case);
  EXPECT_TRUE(block_figures(bench).empty());

  for (BenchPoint& point : bench.points)
    point.unknowns = std::pow(point.points, 3.0);
  analyse(bench, contact_case);

  EXPECT_EQ(names_of(block_figures(bench)),
            (std::vector<std::string>{"blocks-unknowns", "blocks-cpu"}));
}

// A setting without a solution does not change the others.
TEST(BenchAnalysisWithoutAnAnswer, LeavesItOut) {
  Bench bench = made_up();
  BenchPoint& broken = bench.points[4]; // the coarsest of the fem
  broken.problem = "ended with exit code 2: too few points";
  broken.answer = {};

  analyse(bench, cases::read_case_text(rough, "rough/case.toml"));

  EXPECT_TRUE(std::isnan(broken.errors.at("mean_gap")));
  EXPECT_NEAR(bench.series[1].cost.exponent, cost_exponent, 1e-9);
  EXPECT_EQ(bench.series[1].cost.points, 2);
}

// The page names every setting, including one without a solution and one with
// characters that HTML would interpret.
TEST(BenchPage, NamesEverySetting) {
  Bench bench = made_up();
  bench.points[4].problem = "ended with exit code 2: 3 < 4 points";
  bench.points[4].answer = {};
  analyse(bench, cases::read_case_text(rough, "rough/case.toml"));
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      ("asperity_bench_page_" + std::to_string(::getpid()));

  write_bench_report(bench, folder);

  std::ifstream file(folder / "report.html");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove_all(folder);
  EXPECT_NE(page.find("3 &lt; 4 points"), std::string::npos);
  for (const BenchPoint& point : bench.points)
    EXPECT_NE(page.find(point.label), std::string::npos) << point.label;
}

// An unknown number is null in the file, and numbers are read back.
TEST_F(BenchAnalysis, IsWrittenAsJson) {
  const auto json = json_of_text(text_of_json(bench_json(bench), 2));

  EXPECT_EQ(json["case"], bench.case_name);
  EXPECT_TRUE(json["points"][0]["transform_pair [s]"].is_null());
  EXPECT_EQ(json["points"][2]["errors"]["mean_gap"].get<double>(),
            bench.points[2].errors.at("mean_gap"));
}

} // namespace asperity::bench::analysis_test
