// Tests of the predicted size of a full 3-D block against the block itself.
#include "app/plan/block_size.hpp"
#include "cases/reader/read_case.hpp"
#include "fem/plugin.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity::app::block_size_test {

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

struct Counted {
  double predicted = 0.0;
  double built = 0.0;
};

Counted unknowns_with(const Overrides& overrides) {
  const cases::Case sphere =
      cases::read_case_text(sphere_case, "sphere.toml", overrides);
  const int points = *sphere.surface.points;
  const Grid grid{points, points, *sphere.surface.length,
                  *sphere.surface.length};
  const mechanics::Scales scales{sphere.material.contact_modulus, grid.length_x,
                                 grid.spacing_x(), 0.0};
  const auto& settings =
      std::get<mechanics::FemSettings>(sphere.methods[0].settings);
  const auto block =
      fem::load_fem_module().full({grid, settings.block, settings.full,
                                   sphere.material, sphere.mesh, scales});
  return {block_size(sphere, settings, scales, grid).unknowns,
          static_cast<double>(block->unknowns())};
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

class FullBlockSize : public ::testing::TestWithParam<Overrides> {};

// The prediction is exact for structured meshes and the hexahedra of gmsh.
TEST_P(FullBlockSize, IsCountedBeforeItIsMeshed) {
  const Counted unknowns = unknowns_with(GetParam());

  EXPECT_EQ(unknowns.predicted, unknowns.built);
}

const Overrides hanging{R"(mesh.kind="hanging")", "mesh.cells_a_level=2"};
const Overrides gmsh{R"(mesh.kind="gmsh")", R"(mesh.size_at_contact="2 h")"};
const Overrides q2{R"(fem.element="Q2")"};

INSTANTIATE_TEST_SUITE_P(Structured, FullBlockSize,
                         ::testing::Values(Overrides{}, q2, with_layers,
                                           with(with_layers, q2), hanging,
                                           with(hanging, q2)));

INSTANTIATE_TEST_SUITE_P(ByGmsh, FullBlockSize,
                         ::testing::Values(gmsh, with(gmsh, indented),
                                           with(with(gmsh, indented), q2),
                                           with(with(gmsh, with_layers),
                                                {R"(mesh.geometry="layered")"}),
                                           with(gmsh, with_inclusion)));

// For gmsh's tetrahedra, whose positions gmsh chooses itself, it is within a
// factor of two.
TEST(FullBlockOfTetrahedra, IsCountedWithinAFactorOfTwo) {
  for (const Overrides& shape : {Overrides{}, indented}) {
    const Counted unknowns =
        unknowns_with(with(with(gmsh, {R"(mesh.cells="tetrahedra")"}), shape));

    EXPECT_LT(unknowns.predicted, 2.0 * unknowns.built);
    EXPECT_GT(unknowns.predicted, 0.5 * unknowns.built);
  }
}

} // namespace asperity::app::block_size_test
