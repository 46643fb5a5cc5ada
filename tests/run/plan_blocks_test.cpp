// Tests of plans of full blocks: their cost and its uncertainty. No test
// measures the time of a run; tests/run/expected_block_test.cpp compares the
// unknowns and the linear solver with those of blocks.
#include "run/plan/block_cost.hpp"
#include "run/plan/memory_check.hpp"
#include "tests/run/planned_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asperity::run::plan_blocks_test {

using PlannedBlock = PlannedRun;

/// What a shipped case with its quick.set took, in the release build on one
/// thread: CPU time of a method with its set-up, and peak memory of the run.
struct Measured {
  const char* name;
  std::vector<std::string> overrides;
  const char* method;
  double time = 0.0; ///< over MachineRates::relative_time(), of which it is the
                     ///< mean with two measured before and two after it [s]
  double memory = 0.0; ///< [B]
};

constexpr double mebibyte = 1024.0 * 1024.0;

const std::vector<std::string> coarse{"surface.points=32"};
const std::vector<Measured> measured{
    {"two-blocks", {"surface.points=16"}, "fem.two", 4.1, 253 * mebibyte},
    {"hertz-3d",
     {"surface.points=40", "load.nominal_pressure=2.304e-4 E*"},
     "fem",
     0.5,
     220 * mebibyte},
    {"hertz-adaptive",
     {"surface.points=64", "mesh.halvings=3",
      "load.nominal_pressure=2.304e-4 E*"},
     "fem",
     0.44,
     213 * mebibyte},
    {"rough-3d", coarse, "fem.fourier", 1.1, 253 * mebibyte},
    {"rough-3d", coarse, "fem.multigrid", 0.73, 253 * mebibyte},
    {"heterogeneous", coarse, "fem", 1.5, 228 * mebibyte},
    {"heterogeneous", coarse, "fem.multigrid", 0.6, 228 * mebibyte},
    {"step42", coarse, "fem", 0.39, 248 * mebibyte},
    {"step42", coarse, "fem.layers", 0.75, 248 * mebibyte},
    {"punch",
     {"surface.points=32", "load.nominal_pressure=3e-4 E*"},
     "fem",
     0.34,
     227 * mebibyte},
    {"punch",
     {"surface.points=32", "load.nominal_pressure=3e-4 E*"},
     "fem.finite",
     0.29,
     227 * mebibyte},
    {"elastic-sphere",
     {"surface.points=50", "load.nominal_pressure=2.7777777777777778e-3 E*"},
     "fem",
     1.3,
     252 * mebibyte},
    {"elastic-sphere",
     {"surface.points=50", "load.nominal_pressure=2.7777777777777778e-3 E*"},
     "fem.ball",
     2.8,
     252 * mebibyte},
};

// Time and memory are predicted within a factor of two. The time is compared in
// units of the measured speed of this machine, so that it does not depend on
// it.
TEST(PlannedBlocks, CostWhatWasMeasuredWithinAFactorOfTwo) {
  MachineRates rates(32);
  for (const Measured& one : measured) {
    const cases::Case shipped = cases::read_case(
        ASPERITY_CASES "/" + std::string(one.name) + "/case.toml",
        one.overrides);
    RunOptions options{"out", {}, false, 1};
    options.has_report = false;
    const Plan plan = make_plan(shipped, options, rates);
    const auto method = std::ranges::find(plan.methods, std::string(one.method),
                                          &PlannedMethod::name);
    ASSERT_NE(method, plan.methods.end());
    const double time =
        (method->setup_time + method->step_time) / rates.relative_time() -
        fem_load_time;

    EXPECT_LT(std::abs(std::log2(time / one.time)), 1.0)
        << one.name << ' ' << one.method << ": " << time << " s";
    EXPECT_LT(std::abs(std::log2(plan.memory / one.memory)), 1.0)
        << one.name << ": " << plan.memory / mebibyte << " MiB";
  }
}

// A block that could not be built is counted, not meshed: of the sizes of a
// case file, each of these meshes has more than 1e9 nodes.
TEST_F(PlannedBlock, CountsWhatIsTooLargeToMesh) {
  const std::vector<std::string> fine{"surface.points=8192",
                                      R"(fem.solver="full")"};
  for (const auto& mesh : std::vector<std::vector<std::string>>{
           {},
           {R"(mesh.kind="hanging")", "mesh.cells_a_level=64"},
           {R"(mesh.kind="gmsh")"},
           {R"(mesh.kind="gmsh")", R"(mesh.cells="tetrahedra")",
            R"(fem.contact_at="gauss")", R"(fem.contact="augmented")",
            R"(fem.penalty="10 E*/h")"}}) {
    std::vector<std::string> overrides = fine;
    overrides.insert(overrides.end(), mesh.begin(), mesh.end());
    const Plan large = plan(overrides, {"fem"});

    EXPECT_GT(large.methods.at(0).unknowns, 3e9);
    EXPECT_FALSE(refusal_of(large).empty());
  }
}

// .4 kB per node of the block, whose unknowns are three times as many.
TEST_F(PlannedBlock, CountsTheMatrixOfItsConduction) {
  const std::string whole = R"(fem.solver="full")";
  const PlannedMethod without = plan({whole}, {"fem"}).methods.at(0);
  const PlannedMethod with =
      plan({whole, R"(conductance.resistivity="2e-8 Ohm m")",
            R"(conductance.counter_resistivity="2e-8 Ohm m")"},
           {"fem"})
          .methods.at(0);

  EXPECT_GT(with.memory - without.memory, 400.0 * with.unknowns / 3.0);
}

// A plan with a full block states its uncertainty.
TEST_F(PlannedBlock, StatesItsUncertainty) {
  const Plan whole = plan({R"(fem.solver="full")"});

  EXPECT_EQ(plan().factor, 2.0);
  EXPECT_EQ(whole.factor, block_factor);
  EXPECT_NE(plan_text(whole, read()).find("within a factor of 3"),
            std::string::npos);
}

} // namespace asperity::run::plan_blocks_test
