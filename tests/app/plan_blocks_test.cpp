// Tests of plans of full blocks: their size, their linear solver and the
// uncertainty of their cost. No test asserts a time.
#include "app/plan/block_cost.hpp"
#include "app/plan/block_size.hpp"
#include "fem/linear/solver_choice.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/app/planned_run.hpp"

namespace asperity::app::plan_blocks_test {

using PlannedBlock = PlannedRun;

// The plan states the size of the block without elimination: three
// displacements per node, (N + 1)^2 of them on every plane that meshes/ makes.
TEST_F(PlannedBlock, CountsTheDisplacementsOfTheFullBlock) {
  const cases::Case contact_case = read();
  auto fem =
      std::get<mechanics::FemSettings>(contact_case.methods.at(2).settings);
  fem.block.element = mechanics::Element::q1;
  const Grid grid = grid_of_case(contact_case, contact_case.methods);
  MachineRates rates(32);
  const std::size_t layers =
      meshes::graded_layers(grid.spacing_x(), fem.block.growth, grid.length_x)
          .size();

  const MethodCost cost = cost_of_full_block(contact_case, fem, grid, rates);

  EXPECT_EQ(cost.unknowns, 3.0 * 33 * 33 * (static_cast<double>(layers) + 1.0));
}

// The interface of a coating is a face of the layers, and the additional layers
// are counted.
TEST_F(PlannedBlock, CountsTheLayersOfACoating) {
  const cases::Case coated =
      read({R"(material.layers=[{thickness = "0.1 length", youngs_modulus = )"
            R"("20 GPa", poisson_ratio = 0.3}])"});
  const auto& fem =
      std::get<mechanics::FemSettings>(coated.methods.at(2).settings);
  const Grid grid = grid_of_case(coated, coated.methods);
  const mechanics::Scales scales{coated.material.contact_modulus, grid.length_x,
                                 grid.spacing_x(), 0.0};
  const std::vector<double> interfaces{0.1 * grid.length_x};

  const std::vector<double> meshed = meshes::graded_layers_with_interfaces(
      2.0 * grid.spacing_x(), fem.block.growth, interfaces, grid.length_x);

  EXPECT_EQ(n_layers(coated, fem, scales, grid),
            static_cast<int>(meshed.size()));
  EXPECT_NE(n_layers(coated, fem, scales, grid),
            n_layers(read(), fem, scales, grid));
}

// The linear solver of each block is that of docs/numerics/full-block.md:
// without a matrix where fem/ has it, depending on the number of processes.
TEST_F(PlannedBlock, KnowsTheLinearSolverOfABlock) {
  const auto kind = [](const std::vector<std::string>& overrides,
                       double unknowns, int ranks) {
    const cases::Case contact_case = read(overrides);
    return block_cost_kind(
        contact_case,
        std::get<mechanics::FemSettings>(contact_case.methods.at(2).settings),
        unknowns, ranks);
  };
  const std::string full = R"(fem.solver="full")";
  const std::string q1 = R"(fem.element="Q1")";
  const std::string q2 = R"(fem.element="Q2")";
  const std::string hanging = R"(mesh.kind="hanging")";
  const std::string stiff = "material.poisson_ratio=0.499";
  const std::string gauss = R"(fem.contact_at="gauss")";
  const std::string springs = R"(fem.contact="augmented")",
                    stiffness_of_springs = R"(fem.penalty="1e3 E*/h")";

  const std::string free_sides = R"(fem.sides="free")";
  const double small = fem::most_direct_unknowns;
  const double least = small + 1.0;
  const double most_stiff = fem::most_direct_stiff_unknowns;
  const double most_stiff_on_ranks = fem::most_direct_stiff_unknowns_on_ranks;

  EXPECT_EQ(kind({full}, small, 1), BlockCostKind::direct);
  EXPECT_EQ(kind({full}, small, 2), BlockCostKind::lattice);
  EXPECT_EQ(kind({full}, least, 1), BlockCostKind::lattice);
  EXPECT_EQ(kind({full, stiff}, small, 1), BlockCostKind::direct);
  EXPECT_EQ(kind({full, stiff}, small, 2), BlockCostKind::fourier);
  EXPECT_EQ(kind({full, stiff}, least, 1), BlockCostKind::fourier);
  EXPECT_EQ(kind({full, stiff, free_sides}, most_stiff, 1),
            BlockCostKind::direct);
  EXPECT_EQ(kind({full, stiff, free_sides}, most_stiff + 1.0, 1),
            BlockCostKind::algebraic);
  EXPECT_EQ(kind({full, stiff, hanging}, most_stiff_on_ranks, 2),
            BlockCostKind::direct);
  EXPECT_EQ(kind({full, stiff, hanging}, most_stiff_on_ranks + 1.0, 2),
            BlockCostKind::algebraic);
  EXPECT_EQ(kind({full, hanging, q1}, small, 1), BlockCostKind::direct);
  EXPECT_EQ(kind({full, hanging, q1}, least, 1), BlockCostKind::halved);
  EXPECT_EQ(kind({full, hanging, q2}, 3000, 2), BlockCostKind::halved);
  EXPECT_EQ(
      kind({full, hanging, q1, gauss, springs, stiffness_of_springs}, 3000, 2),
      BlockCostKind::halved);
}

// A counter-body of finite size is solved without a matrix, a mirror image of
// the block is not. The shipped case has both bodies.
TEST_F(PlannedBlock, KnowsTheLinearSolverOfTwoBodies) {
  const cases::Case pair =
      cases::read_case(ASPERITY_CASES "/elastic-sphere/case.toml");
  const cases::Case mirrored =
      cases::read_case(ASPERITY_CASES "/two-blocks/case.toml");
  const auto kind = [](const cases::Case& contact_case, int ranks) {
    return block_cost_kind(
        contact_case,
        std::get<mechanics::FemSettings>(contact_case.methods.back().settings),
        5e4, ranks);
  };

  EXPECT_EQ(kind(pair, 1), BlockCostKind::pair);
  EXPECT_EQ(kind(pair, 2), BlockCostKind::pair);
  EXPECT_EQ(kind(mirrored, 1), BlockCostKind::algebraic);
}

// A plan with a full block states its uncertainty.
TEST_F(PlannedBlock, StatesItsUncertainty) {
  const Plan whole = plan({R"(fem.solver="full")"});

  EXPECT_EQ(plan().factor, 2.0);
  EXPECT_EQ(whole.factor, block_factor);
  EXPECT_NE(plan_text(whole, read()).find("within a factor of 3"),
            std::string::npos);
}

} // namespace asperity::app::plan_blocks_test
