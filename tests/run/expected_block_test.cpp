// Tests of what a plan expects of a full 3-D block, its unknowns and its linear
// solver, against those of the block that a run builds and solves.
#include "input/reader/read_case.hpp"
#include "run/methods/full_block_method.hpp"
#include "run/plan/needs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity::run::expected_block_test {

const std::string sphere_case = R"(schema = 1
title = "sphere"
[surface]
kind = "sphere"
length = "1 mm"
points = 32
radius = "10 length"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[mesh]
kind = "layers"
[load]
nominal_pressure = ["1e-4 E*"]
[fem]
element = "Q1"
contact = "hard"
solver = "full"
growth = 1.5
)";

using Overrides = std::vector<std::string>;
using fem::BlockSolverKind;

/// A part of the name of a solver that no other one has.
const char* name_of(BlockSolverKind kind) {
  switch (kind) {
  case BlockSolverKind::direct:
    return "direct";
  case BlockSolverKind::algebraic:
    return "multigrid (Trilinos ML)";
  case BlockSolverKind::box_grid:
    return "multigrid on the grid of boxes";
  case BlockSolverKind::halved:
    return "coarser meshes";
  case BlockSolverKind::hexahedra:
    return "first order by Trilinos ML";
  }
  return "?";
}

/// Solves the first load of a method on a flat surface.
void expect_as_built(const cases::Case& contact_case,
                     const cases::MethodSpec& method, double factor = 1.0) {
  const int points = *contact_case.surface.points;
  const double length = *contact_case.surface.length;
  const Grid grid{points, points, length, length};
  const mechanics::Scales scales{contact_case.material.contact_modulus, length,
                                 grid.spacing_x(), grid.spacing_x()};
  const auto& settings = std::get<mechanics::FemSettings>(method.settings);
  const fem::BlockTraits expected = block_of(contact_case, method, grid, 1);

  const auto block = fem::load_fem_module().full(
      methods::full_request(contact_case, settings, grid, scales));
  const fem::BlockSolution solution = block->solve(
      std::vector<double>(grid.size(), 0.0),
      {mechanics::Control::nominal_pressure, 1e-4 * scales.contact_modulus},
      fem::block_contact(settings.contact, scales));

  const auto built = static_cast<double>(block->unknowns());
  EXPECT_LE(expected.unknowns, factor * built) << method.name;
  EXPECT_GE(expected.unknowns, built / factor) << method.name;
  const std::string name = name_of(fem::solver_of(expected));
  EXPECT_NE(solution.linear_solver.find(name), std::string::npos)
      << method.name << ": " << name << ", but " << solution.linear_solver;
}

void expect_as_built(const Overrides& overrides, double factor = 1.0) {
  const cases::Case sphere =
      cases::read_case_text(sphere_case, "sphere.toml", overrides);
  expect_as_built(sphere, sphere.methods.at(0), factor);
}

const Overrides with_layers{
    R"(material.layers=[{thickness = "0.03 length", youngs_modulus = "20 GPa",)"
    R"( poisson_ratio = 0.3}, {thickness = "0.2 length", youngs_modulus =)"
    R"( "5 GPa", poisson_ratio = 0.3}])"};
const Overrides with_inclusion{
    R"(material.inclusion={radius = "0.15 length", depth = "0.3 length",)"
    R"( youngs_modulus = "40 GPa", poisson_ratio = 0.3})",
    R"(mesh.geometry="inclusion")"};
const Overrides indented{R"(mesh.geometry="indentation")",
                         R"(mesh.fine_radius="0.25 length")"};

Overrides with(Overrides overrides, const Overrides& more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

class ExpectedBlock : public ::testing::TestWithParam<Overrides> {};

// The unknowns of structured meshes and of the hexahedra of gmsh are exact.
TEST_P(ExpectedBlock, IsTheOneThatIsBuilt) {
  expect_as_built(GetParam());
}

const Overrides hanging{R"(mesh.kind="hanging")", "mesh.cells_a_level=2"};
const Overrides gmsh{R"(mesh.kind="gmsh")", R"(mesh.size_at_contact="2 h")"};
const Overrides q2{R"(fem.element="Q2")"};
const Overrides stiff{"material.poisson_ratio=0.499"};
const Overrides small{"surface.points=8", "fem.growth=3"};

INSTANTIATE_TEST_SUITE_P(
    Structured, ExpectedBlock,
    ::testing::Values(Overrides{}, q2, with_layers, with(with_layers, q2),
                      hanging, with(hanging, q2), with(small, stiff),
                      with(small, {R"(fem.depth="1 h")"}),
                      with(with(small, stiff), {R"(fem.sides="free")"})));

INSTANTIATE_TEST_SUITE_P(ByGmsh, ExpectedBlock,
                         ::testing::Values(gmsh, with(gmsh, indented),
                                           with(with(gmsh, indented), q2),
                                           with(with(gmsh, with_layers),
                                                {R"(mesh.geometry="layered")"}),
                                           with(gmsh, with_inclusion)));

class ExpectedBlockOfCase : public ::testing::TestWithParam<const char*> {};

// The shipped cases with a full block, on coarser grids. The mesh that follows
// the contact has its coarsest cells before the first load.
TEST_P(ExpectedBlockOfCase, IsTheOneThatIsBuilt) {
  const cases::Case shipped = cases::read_case(
      ASPERITY_CASES "/" + std::string(GetParam()) + "/case.toml",
      {"surface.points=32"});
  for (const cases::MethodSpec& method : shipped.methods)
    if (const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings);
        fem != nullptr && fem->solver == mechanics::FemSolver::full)
      expect_as_built(shipped, method);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExpectedBlockOfCase,
                         ::testing::Values("heterogeneous", "punch", "rough-3d",
                                           "step42", "two-blocks"));

} // namespace asperity::run::expected_block_test
