// Tests of plans of full blocks: their memory.
// tests/run/expected_block_test.cpp compares the unknowns and the linear solver
// with those of blocks.
#include "input/input_error.hpp"
#include "run/plan/plan.hpp"
#include "tests/message_of.hpp"
#include "tests/run/planned_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity::run::plan_blocks_test {

using PlannedBlock = PlannedRun;

/// Peak memory of a shipped case with its quick.set, in the release build on
/// one thread.
struct Measured {
  const char* name;
  std::vector<std::string> overrides;
  double memory = 0.0; ///< [B]
};

constexpr double mebibyte = 1024.0 * 1024.0;

const std::vector<std::string> coarse{"surface.points=32"};
const std::vector<Measured> measured{
    {"two-blocks", {"surface.points=16"}, 253 * mebibyte},
    {"hertz-3d",
     {"surface.points=40", "load.nominal_pressure=2.304e-4 E*"},
     220 * mebibyte},
    {"hertz-adaptive",
     {"surface.points=64", "mesh.halvings=3",
      "load.nominal_pressure=2.304e-4 E*"},
     213 * mebibyte},
    {"rough-3d", coarse, 253 * mebibyte},
    {"heterogeneous", coarse, 228 * mebibyte},
    {"step42", coarse, 248 * mebibyte},
    {"punch",
     {"surface.points=32", "load.nominal_pressure=3e-4 E*"},
     227 * mebibyte},
    {"elastic-sphere",
     {"surface.points=50", "load.nominal_pressure=2.7777777777777778e-3 E*"},
     252 * mebibyte},
};

TEST(PlannedBlocks, NeedWhatWasMeasuredWithinAFactorOfTwo) {
  for (const Measured& one : measured) {
    const cases::Case shipped = cases::read_case(
        ASPERITY_CASES "/" + std::string(one.name) + "/case.toml",
        one.overrides);
    RunOptions options{"out", {}, false, 1};
    options.has_report = false;
    const Plan plan = make_plan(shipped, options);

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
           {R"(mesh.kind="gmsh")"}}) {
    std::vector<std::string> overrides = fine;
    overrides.insert(overrides.end(), mesh.begin(), mesh.end());
    const Plan large = plan(overrides, {"fem"});

    EXPECT_GT(large.methods.at(0).unknowns, 3e9);
    EXPECT_FALSE(refusal_of(large).empty());
  }
}

// No linear solver serves a nearly incompressible block of so many unknowns.
TEST_F(PlannedBlock, RefusesLargeNearlyIncompressibleBlocks) {
  const auto answer = [&](const std::string& points) {
    return tests::message_of<input::InputError>([&] {
      plan({points, R"(fem.solver="full")", "material.poisson_ratio=0.499"},
           {"fem"});
    });
  };

  EXPECT_EQ(answer("surface.points=8"), "accepted");
  const std::string words = answer("surface.points=32");
  EXPECT_NE(words.find("fem.solver = \"full\": unknowns of a full block"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("\"condensed\""), std::string::npos) << words;
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

} // namespace asperity::run::plan_blocks_test
