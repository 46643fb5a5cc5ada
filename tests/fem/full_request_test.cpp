// Tests of fem/full_request.hpp: what the description of a block becomes.
#include "fem/full_request.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace asperity::fem::full_request_test {

FullRequest adaptive_request(int points, int halvings) {
  FullRequest request;
  request.grid = {points, points, 1e-6, 1e-6};
  request.full.uses_case_mesh = true;
  request.material.contact_modulus = 2e9;
  request.material.poisson_ratio = 0.3;
  request.mesh.kind = mechanics::MeshKind::adaptive;
  request.mesh.halvings = halvings;
  request.scales = {2e9, 1e-6, 1e-6 / points, 1e-9, 0.1};
  return request;
}

std::string refusal(const FullRequest& request) {
  return tests::message_of<std::domain_error>(
      [&] { static_cast<void>(problem_of(request)); });
}

// The coarsest cells of second order span two nodes of the grid after all
// halvings: 48 points with three halvings are 3 cells per side.
TEST(FullRequest, HalvesTheCellsOfAnAdaptiveMesh) {
  for (const int halvings : {1, 2, 3}) {
    const BlockProblem problem = problem_of(adaptive_request(48, halvings));

    const auto cells = static_cast<std::size_t>(24 >> halvings);
    EXPECT_EQ(problem.mesh.cells.size(), cells * cells * cells);
    ASSERT_TRUE(problem.adaptive.has_value());
    EXPECT_EQ(problem.adaptive->halvings, halvings);
  }
}

// At least one halving, and two coarsest cells per side.
TEST(FullRequest, RefusesHalvingsThatDoNotFit) {
  EXPECT_NE(refusal(adaptive_request(48, 0)).find("halvings = 0"),
            std::string::npos);
  EXPECT_NE(refusal(adaptive_request(48, 13)).find("halvings = 13"),
            std::string::npos);
  EXPECT_EQ(refusal(adaptive_request(32, 3)), "accepted");
  EXPECT_NE(refusal(adaptive_request(48, 4)).find("a multiple of 32"),
            std::string::npos);
  EXPECT_NE(refusal(adaptive_request(32, 4)).find("at least twice as many"),
            std::string::npos);
}

// A coating of a tenth of the side is two fifths of a coarsest cell, which is
// too thin for a layer of its own: half of one, with five cells to the depth.
TEST(FullRequest, PutsInterfacesOnPlanesOfAdaptiveCells) {
  FullRequest request = adaptive_request(32, 2);
  request.material.layers = {
      {{0.1, mechanics::ReferenceUnit::length}, {2e10, 0.2}}};
  request.mesh.interface_halvings = 1;
  request.mesh.moduli_ratio = 2.0;

  const BlockProblem problem = problem_of(request);

  std::set<double> depths;
  for (const meshes::Place& place : problem.mesh.vertices)
    depths.insert(place[2]);
  EXPECT_NEAR(*std::next(depths.begin()), 0.2e-6, 1e-18);
  EXPECT_EQ(problem.adaptive->interface_halvings, 1);
  EXPECT_EQ(problem.adaptive->moduli_ratio, 2.0);
}

// A random factor for each cell would change with the mesh.
TEST(FullRequest, RefusesRandomModuliOfAdaptiveCells) {
  FullRequest request = adaptive_request(32, 2);
  request.material.variation.emplace().kind = mechanics::VariationKind::random;
  request.material.variation->spread = 0.5;

  EXPECT_NE(refusal(request).find("material.variation.edge"),
            std::string::npos);
  request.material.variation->edge = {4.0, mechanics::ReferenceUnit::spacing};
  EXPECT_EQ(refusal(request), "accepted");
}

TEST(FullRequest, PassesTheSidesOn) {
  FullRequest request = adaptive_request(16, 1);
  request.full.sides = mechanics::BlockSides::free;

  const BlockProblem problem = problem_of(request);

  EXPECT_EQ(problem.sides, mechanics::BlockSides::free);
}

} // namespace asperity::fem::full_request_test
