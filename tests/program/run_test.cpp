// Tests of the entire program: what it writes, how it ends, the state after a
// kill, which module it does not load.
#include "results/result_reader.hpp"
#include "results/types/method_columns.hpp"
#include "tests/program/program.hpp"

#include <cmath>

namespace asperity::program::run_test {

using results::Result;

class RunCommand : public ProgramTest {
protected:
  RunCommand() { write("small.toml", small_case); }

  Result result(const std::string& name) const {
    return results::read_result(folder / name);
  }
};

int steps_in(const Result& result) {
  int steps = 0;
  for (const auto& method : result.methods)
    for (const auto& curve : method.realizations)
      steps += static_cast<int>(curve.points.size());
  return steps;
}

/// Verifies equal numbers; the costs may differ.
void expect_same_curves(const Result& one, const Result& other,
                        double tolerance) {
  ASSERT_EQ(one.methods.size(), other.methods.size());
  for (std::size_t m = 0; m < one.methods.size(); ++m) {
    ASSERT_EQ(one.methods[m].realizations.size(),
              other.methods[m].realizations.size());
    for (std::size_t r = 0; r < one.methods[m].realizations.size(); ++r) {
      const auto& a = one.methods[m].realizations[r].points;
      const auto& b = other.methods[m].realizations[r].points;
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].mean_gap / b[i].mean_gap, 1.0, tolerance);
        EXPECT_NEAR(a[i].elastic_energy / b[i].elastic_energy, 1.0, tolerance);
        EXPECT_EQ(a[i].step, b[i].step);
      }
    }
  }
}

// Elastic methods also state the areas of (20), within 40 % of the counted one:
// three estimates of one contact (differences of 25 % are usual). The theory
// has its own.
TEST_F(RunCommand, WritesAllDocumentedFilesAndTheAreasOfTheFit) {
  const Ended done = run("run small.toml --out result");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  for (const char* file :
       {"result.h5", "curves.csv", "summary.json", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(folder / "result" / file)) << file;
  const Result written = result("result");
  EXPECT_EQ(written.status, "complete");
  EXPECT_EQ(steps_in(written), 4 + 2 * 4 + 2 * 4); // theory: one formula
  EXPECT_EQ(written.surfaces.size(), 2u);
  EXPECT_EQ(written.methods.at(1).realizations.at(0).fields.size(), 1u);
  EXPECT_EQ(written.methods.at(1).realizations.at(1).fields.size(), 0u);
  EXPECT_EQ(text_of(folder / "result/report.html").find("src=\"http"),
            std::string::npos);

  EXPECT_TRUE(std::isnan(written.methods.at(0).realizations.at(0).points.at(
      0)[columns::area_fraction_fit]));
  for (const std::size_t method : {1u, 2u})
    for (const auto& point : written.methods[method].realizations[0].points) {
      EXPECT_NEAR(point[columns::area_fraction_fit] / point.area_fraction, 1.0,
                  0.4);
      EXPECT_NEAR(point[columns::area_fraction_moment] / point.area_fraction,
                  1.0, 0.4);
    }
}

// Jobs on one thread and on two give the same bits.
TEST_F(RunCommand, ThreadsChangeNothing) {
  ASSERT_EQ(run("run small.toml --no-report --no-cache --out one --threads 1")
                .exit_code,
            0);
  ASSERT_EQ(run("run small.toml --no-report --no-cache --out two --threads 2")
                .exit_code,
            0);

  expect_same_curves(result("one"), result("two"), 0.0);
}

// A single job uses its threads inside the transforms: equal to the tolerance
// of the case, 1e-8 h_rms.
TEST_F(RunCommand, ThreadsInsideOneJobChangeNothingBeyondTheTolerance) {
  const std::string alone =
      "run small.toml --methods halfspace --no-report --no-cache "
      "--set surface.realizations=1 ";
  ASSERT_EQ(run(alone + "--out one --threads 1").exit_code, 0);
  ASSERT_EQ(run(alone + "--out two --threads 2").exit_code, 0);

  expect_same_curves(result("one"), result("two"), 1e-7);
}

TEST_F(RunCommand, SkipsWhatTheCaseDoesNotNeed) {
  const Ended theory =
      run("run small.toml --methods theory --no-report --out theory",
          "env LD_DEBUG=files");

  ASSERT_EQ(theory.exit_code, 0) << theory.output;
  EXPECT_EQ(theory.output.find("libdeal"), std::string::npos);
  EXPECT_TRUE(result("theory").surfaces.empty());

  const Ended block = run("run small.toml --methods fem --no-report --out fem",
                          "env LD_DEBUG=files");
  EXPECT_NE(block.output.find("libdeal"), std::string::npos);
}

TEST_F(RunCommand, FollowsAMeanGapAndBack) {
  const Ended done =
      run("run small.toml --methods halfspace,theory --no-report --out result "
          "--set load.nominal_pressure= "
          "--set 'load.mean_gap=[\"2 h_rms\", \"1 h_rms\"]' "
          "--set load.cycle=load-unload");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  const Result written = result("result");
  const auto& points = written.methods.at(1).realizations.at(0).points;
  ASSERT_EQ(points.size(), 3u); // the turning point once
  EXPECT_NEAR(points[0].mean_gap / written.surfaces[0].rms_height, 2.0, 1e-9);
  EXPECT_TRUE(points[2].is_unloading);
  // Without friction and adhesion unloading follows the loading curve.
  EXPECT_NEAR(points[2].nominal_pressure / points[0].nominal_pressure, 1.0,
              1e-5);
}

TEST_F(RunCommand, StopsInOrderOnCtrlC) {
  const std::string long_run =
      "run small.toml --set surface.points=512 --methods halfspace ";
  const Ended stopped =
      interrupt(long_run + "--out result", "result/result.journal");

  EXPECT_EQ(stopped.exit_code, 130) << stopped.output;
  EXPECT_EQ(result("result").status, "interrupted");
  EXPECT_TRUE(std::filesystem::exists(folder / "result/report.html"));
}

TEST_F(RunCommand, RefusesToResumeAnotherCase) {
  const std::string theory =
      "run small.toml --methods theory --no-report --out result ";
  ASSERT_EQ(run(theory).exit_code, 0);

  const Ended other = run(theory + "--set theory.gamma=0.5 --resume");

  EXPECT_EQ(other.exit_code, 2) << other.output;
}

} // namespace asperity::program::run_test
