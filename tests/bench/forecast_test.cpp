// Tests of the prediction of finer runs from coarse ones, against runs from a
// formula: an error c h^p, a cost a + b n^e.
#include "suite/bench/analysis/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::bench::forecast_test {

constexpr double limit = 2.0;
constexpr double order = 1.5;
constexpr double cost_exponent = 2.3;

/// A run whose kappa has the error 30 / n^1.5 and which costs 0.5 s and 1e-6
/// n^2.3.
BenchPoint run_on(int points) {
  BenchPoint run;
  run.points = points;
  run.answer.values["kappa"] = {limit + 30.0 * std::pow(points, -order)};
  run.answer.rms_height = 1.0;
  run.phases.solving = 1e-6 * std::pow(points, cost_exponent);
  run.cpu.median = 0.5 + run.phases.solving;
  return run;
}

Forecast forecast_from(const std::vector<BenchPoint>& coarse) {
  Forecast forecast;
  add_runs(forecast, coarse, std::vector<std::string>{"kappa"});
  return forecast;
}

// Verifies order, error and cost at any finer grid. Tolerance: the error is
// relative to the finest coarse solution, which differs from the limit by 4 %.
TEST(Forecast, FindsOrderErrorAndCost) {
  const Forecast forecast =
      forecast_from({run_on(32), run_on(64), run_on(128)});

  EXPECT_NEAR(forecast.terms.at("kappa").order, order, 1e-6);
  const double expected = 30.0 * std::pow(1024.0, -order) / limit;
  EXPECT_NEAR(forecast.error("kappa", 1024, 1.0) / expected, 1.0, 0.04);
  EXPECT_NEAR(forecast.cpu_time(1024) /
                  (0.5 + 1e-6 * std::pow(1024.0, cost_exponent)),
              1.0, 1e-9);
}

// From two runs the order is taken as 1, so that the prediction for a faster
// series is never too small.
TEST(Forecast, OfTwoRunsIsCareful) {
  const Forecast forecast = forecast_from({run_on(64), run_on(128)});

  const double error = 30.0 * std::pow(1024.0, -order) / limit;
  EXPECT_EQ(forecast.terms.at("kappa").order, 1.0);
  EXPECT_GT(forecast.error("kappa", 1024, 1.0), error);
}

// For the grading ratio of the layers, of second order in its logarithm, one
// run with half of it is sufficient: 4/3 of the difference at the given ratio,
// a quarter of that at half. Tolerance: roundoff.
TEST(Forecast, AddsTheFloorOfTheLayers) {
  Forecast forecast = forecast_from({run_on(32), run_on(64), run_on(128)});
  forecast.growth = 1.2;
  const double before = forecast.error("kappa", 4096, 1.0);
  BenchPoint as_it_is = run_on(32);
  BenchPoint halved = as_it_is;
  as_it_is.answer.values["kappa"] = {limit + 4.0 * 0.01};
  halved.answer.values["kappa"] = {limit + 0.01};

  add_growth(forecast, as_it_is, halved);

  const double floor = 0.04 / (limit + 0.01);
  EXPECT_NEAR(forecast.error("kappa", 4096, 1.0) - before, floor, 1e-12);
  EXPECT_NEAR(forecast.error("kappa", 4096, 0.5) - before, floor / 4.0, 1e-12);
}

/// Runs with a given order, compared with an exact solution that differs from
/// their limit.
Forecast held_against(double exact_value) {
  const std::vector<BenchPoint> coarse{run_on(32), run_on(64), run_on(128)};
  Forecast forecast = forecast_from(coarse);
  BenchAnswer exact;
  exact.values["kappa"] = {exact_value};
  add_exact(forecast, coarse, std::vector<BenchAnswer>(3, exact));
  return forecast;
}

// The difference between the limit of the runs and the exact solution remains
// on any grid. Tolerance: the remainder at 2^20 points, 1e-8 of kappa, and that
// both errors are relative to the exact value.
TEST(Forecast, KeepsErrorsThatRefinementLeaves) {
  const double exact_value = 0.9 * limit;
  const double staying = limit / exact_value - 1.0;

  const Forecast forecast = held_against(exact_value);

  EXPECT_NEAR(forecast.error("kappa", 1 << 20, 1.0), staying, 1e-6);
  EXPECT_NEAR(forecast.parts("kappa", 1 << 20, 1.0).staying, staying, 1e-6);
  EXPECT_NEAR(forecast.error("kappa", 128, 1.0),
              staying + 30.0 * std::pow(128.0, -order) / exact_value, 1e-3);
}

// Where the runs converge to the exact solution nothing remains. Tolerance:
// roundoff of the order.
TEST(Forecast, KeepsNothingWhereTheRunsTendToTheExactAnswer) {
  EXPECT_NEAR(held_against(limit).terms.at("kappa").bias, 0.0, 1e-9);
}

// Of the error that remains at the grading ratio of the case, the layers
// contribute a part, which half of the ratio removes.
TEST(Forecast, CountsTheLayersOnce) {
  std::vector<BenchPoint> coarse{run_on(32), run_on(64), run_on(128)};
  const double layers = 0.04;
  for (BenchPoint& run : coarse)
    run.answer.values["kappa"].front() += limit * layers;
  Forecast forecast = forecast_from(coarse);
  forecast.terms.at("kappa").floor = layers;
  BenchAnswer exact;
  exact.values["kappa"] = {limit};

  add_exact(forecast, coarse, std::vector<BenchAnswer>(3, exact));

  EXPECT_NEAR(forecast.error("kappa", 1 << 20, 1.0), layers, 1e-6);
  EXPECT_NEAR(forecast.error("kappa", 1 << 20, 0.5), layers / 4.0, 1e-6);
}

// An error that a verification finds beyond the prediction is included from
// then on; at first it is assumed to decrease with the points, and to remain
// where it was found again. A solution that is better than predicted changes
// nothing.
TEST(Forecast, LearnsFromAMissedTarget) {
  Forecast forecast = forecast_from({run_on(32), run_on(64), run_on(128)});
  const double lucky = forecast.error("kappa", 512, 1.0);

  forecast.learn("kappa", 512, 1.0, 0.5 * lucky);
  EXPECT_EQ(forecast.error("kappa", 512, 1.0), lucky);

  forecast.learn("kappa", 512, 1.0, 0.03);
  EXPECT_NEAR(forecast.error("kappa", 512, 1.0), 0.03, 1e-15);
  EXPECT_NEAR(forecast.error("kappa", 2048, 1.0) / 0.03, std::pow(4.0, -order),
              1e-6);

  forecast.learn("kappa", 2048, 1.0, 0.03);
  EXPECT_NEAR(forecast.error("kappa", 2048, 1.0), 0.03, 1e-15);
  EXPECT_GT(forecast.error("kappa", 1 << 20, 1.0), 0.02);
}

// The cost of a run besides its steps may grow with the points too (maps, the
// stress inside) and is then not treated as constant.
TEST(Forecast, CountsWhatGrowsBesidesTheSteps) {
  std::vector<BenchPoint> coarse{run_on(32), run_on(64), run_on(128)};
  for (BenchPoint& run : coarse)
    run.cpu.median +=
        9.0 * run.phases.solving; // the steps take ten times as long in total
  coarse.front().cpu.median -= 9.0 * coarse.front().phases.solving;

  const Forecast forecast = forecast_from(coarse);

  const double steps = 1e-6 * std::pow(1024.0, cost_exponent);
  EXPECT_GT(forecast.cpu_time(1024), 9.0 * steps);
}

// If the area is requested, the estimator with the smallest error is used.
TEST(Forecast, TakesTheBestEstimatorOfTheArea) {
  Forecast forecast;
  forecast.finest = 64;
  forecast.terms["area_fraction"] = {.error = 0.1, .order = 1.0};
  forecast.terms["area_fraction_corrected"] = {.error = 0.02, .order = 1.0};

  EXPECT_NEAR(forecast.error(any_area, 128, 1.0), 0.01, 1e-15);
  EXPECT_EQ(forecast.best_column(any_area, 128, 1.0),
            "area_fraction_corrected");
}

// An estimator that converges fast to another area than the corrected count is
// not preferred: its bias remains on any grid. Tolerance: the two errors that
// are allowed, 5e-3 and 1e-4 of the area.
TEST(Forecast, IgnoresABiasedEstimator) {
  std::vector<BenchPoint> coarse;
  for (const int points : {32, 64, 128}) {
    BenchPoint run = run_on(points);
    run.answer.values["area_fraction_corrected"] = {0.1 *
                                                    (1.0 + 0.64 / points)};
    run.answer.values["area_fraction_moment"] = {0.114 *
                                                 (1.0 + 1.0 / points / points)};
    coarse.push_back(run);
  }
  Forecast forecast;

  add_runs(forecast, coarse, std::vector<std::string>{any_area});

  EXPECT_NEAR(forecast.error("area_fraction_moment", 4096, 1.0), 0.14, 0.015);
  EXPECT_EQ(forecast.error(any_area, 4096, 1.0),
            forecast.error("area_fraction_corrected", 4096, 1.0));
}

/// What a target applies to where the case expects something of these.
std::vector<std::string> asked_by(cases::Case contact_case,
                                  const std::vector<std::string>& expected) {
  for (const std::string& quantity : expected)
    contact_case.expectations.push_back({quantity, 0.0, 1.0, {}});
  return asked_quantities(contact_case);
}

// Each expectation asks for the quantity that it is computed from, once,
// and a wave, whose theory is no roughness theory, for no fitted number.
TEST(AskedQuantities, AreThoseOfTheExpectations) {
  using Names = std::vector<std::string>;
  cases::Case rough;
  rough.surface.kind = mechanics::SurfaceKind::self_affine;

  EXPECT_EQ(asked_by(rough, {}), (Names{"mean_gap", any_area}));
  EXPECT_EQ(asked_by(rough, {"gap_deviation", "kappa", "pressure_difference"}),
            (Names{"mean_gap", "kappa"}));
  EXPECT_EQ(asked_by(rough, {"area_error", "contact_radius_error"}),
            Names{any_area});

  rough.surface.kind = mechanics::SurfaceKind::wave_1d;
  EXPECT_EQ(asked_by(rough, {"kappa"}), (Names{"mean_gap", any_area}));

  rough.load.control = mechanics::Control::mean_gap;
  EXPECT_EQ(asked_by(rough, {}), (Names{"nominal_pressure", any_area}));
  EXPECT_EQ(asked_by(rough, {"mean_gap_error"}), Names{"nominal_pressure"});
}

} // namespace asperity::bench::forecast_test
