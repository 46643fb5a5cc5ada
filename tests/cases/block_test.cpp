// Tests of heterogeneous blocks and of [mesh] in a case: meshes by gmsh, from
// files, of a counter-body and adaptive ones, and the messages about invalid
// ones.
#include "input/text/toml_text.hpp"
#include "tests/cases/block_samples.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::block_test {

TEST(Block, IsUniformUnlessTheCaseSaysMore) {
  const Case read = block("");

  EXPECT_TRUE(read.material.is_uniform());
  EXPECT_EQ(read.mesh.kind, mechanics::MeshKind::layers);
  EXPECT_EQ(fem_of(read).full.sides, mechanics::BlockSides::periodic);
  EXPECT_EQ(fem_of(read).full.bodies, 1);
  EXPECT_FALSE(fem_of(read).full.uses_case_mesh);
}

TEST(Block, HasLayersFromTheContactSurface) {
  const Case read = block(
      "", {"material.layers=[{ thickness = \"0.05 length\", youngs_modulus = "
           "\"20 GPa\", poisson_ratio = 0.2 }, { thickness = 1e-6, "
           "youngs_modulus = 3e9, poisson_ratio = 0.4 }]"});

  ASSERT_EQ(read.material.layers.size(), 2U);
  EXPECT_EQ(read.material.layers[0].thickness.reference,
            mechanics::ReferenceUnit::length);
  EXPECT_EQ(read.material.layers[0].thickness.value, 0.05);
  EXPECT_EQ(read.material.layers[0].moduli.youngs_modulus, 20e9);
  EXPECT_EQ(read.material.layers[1].moduli.poisson_ratio, 0.4);
  EXPECT_FALSE(read.material.is_uniform());
}

TEST(Block, KeepsItsLayersInTheTextOfTheCase) {
  const Case read =
      block("", {"material.layers=[{ thickness = 1e-6, youngs_modulus = 3e9, "
                 "poisson_ratio = 0.4 }]"});

  const Case again = read_case_text(read.text, "some/case.toml", {});

  ASSERT_EQ(again.material.layers.size(), 1U);
  EXPECT_EQ(again.material.layers[0].moduli.youngs_modulus, 3e9);
}

TEST(Block, NamesTheKeyThatALayerLacks) {
  const std::string answer =
      refusal("", {"material.layers=[{ thickness = 1e-6, yungs_modulus = 3e9, "
                   "poisson_ratio = 0.4 }]"});

  EXPECT_NE(answer.find("youngs_modulus is missing"), std::string::npos)
      << answer;
  EXPECT_NE(answer.find("yungs_modulus"), std::string::npos) << answer;
}

TEST(Block, HasAnInclusionOnlyInTheFullBlock) {
  const std::string sphere =
      "[material.inclusion]\nradius = \"0.1 length\"\ndepth = \"0.2 length\"\n"
      "youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.2\n";

  const Case read = block(sphere, full);
  const std::string answer = refusal(sphere);

  ASSERT_TRUE(read.material.inclusion);
  EXPECT_EQ(read.material.inclusion->moduli.youngs_modulus, 20e9);
  EXPECT_NE(answer.find("solver = \"full\""), std::string::npos) << answer;
}

TEST(Block, RefusesAnInclusionOutsideOfTheBlock) {
  const std::string answer = refusal(
      "[material.inclusion]\nradius = \"0.3 length\"\ndepth = \"0.2 length\"\n"
      "youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.2\n",
      full);

  EXPECT_NE(answer.find("must be larger than the radius"), std::string::npos)
      << answer;
}

// A sphere that touches the contact surface is not inside the block; the reader
// cannot compare depths in other reference units than that of the radius.
TEST(Block, ComparesDepthsOfOneReferenceUnitAlone) {
  const auto sphere = [](const std::string& depth) {
    return "[material.inclusion]\nradius = \"0.2 length\"\ndepth = " + depth +
           "\nyoungs_modulus = \"20 GPa\"\npoisson_ratio = 0.2\n";
  };

  EXPECT_NE(refusal(sphere("\"0.2 length\""), full)
                .find("must be larger than the radius"),
            std::string::npos);
  EXPECT_EQ(block(sphere("1e-6"), full).material.inclusion->depth.value, 1e-6);
}

TEST(Block, VariesByAFunctionByChanceOrByATable) {
  const auto variation = [](const std::string& keys) {
    return *block("[material.variation]\n" + keys, full).material.variation;
  };

  EXPECT_EQ(variation("kind = \"function\"\nfactor = \"1 + x\"\n").factor,
            "1 + x");
  EXPECT_EQ(variation("kind = \"random\"\nspread = 0.5\nseed = 3\n").seed, 3U);
  EXPECT_EQ(variation("kind = \"table\"\nfile = \"f.txt\"\n").file,
            "some/f.txt");
}

// Tolerance: a difference of nearly equal inverses, some ten roundings.
TEST(Block, OfTwoBodiesIsTheFirstOfThem) {
  const Case pair = block("[material.counter]\nyoungs_modulus = \"7 GPa\"\n"
                          "poisson_ratio = 0.2\n");

  const mechanics::BodyModuli first = pair.material.first_body();

  EXPECT_NEAR(first.youngs_modulus, 2e9, 1e-5);
  EXPECT_EQ(first.poisson_ratio, 0.3);
  ASSERT_TRUE(pair.material.counter);
  EXPECT_EQ(pair.material.counter->youngs_modulus, 7e9);
}

const std::string a_layer =
    "material.layers=[{ thickness = 1e-6, youngs_modulus = 3e9, poisson_ratio "
    "= 0.4 }]";

// The missing keys of a layered block, and a pair that no single block can
// represent, are named.
TEST(Block, NamesWhatLayersCannotBe) {
  std::string without_ratio = contact_case;
  const std::size_t from = without_ratio.find("poisson_ratio");
  without_ratio.erase(from, without_ratio.find('\n', from) - from);
  const std::string pair =
      refusal("[material.counter]\nyoungs_modulus = \"70 GPa\"\n"
              "poisson_ratio = 0.3\n",
              {a_layer});

  EXPECT_NE(pair.find("halfspace: no single block represents a layered body"),
            std::string::npos)
      << pair;
  EXPECT_NE(pair.find("fem: no single block"), std::string::npos) << pair;
  EXPECT_NE(mistakes_of(without_ratio, {a_layer})
                .find("material.layers needs material.poisson_ratio"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, RefusedBlock,
    testing::Values(
        Refused{"", "fem.sides=free", "needs solver = \"full\""},
        Refused{"", "fem.bodies=2", "needs solver = \"full\""},
        Refused{"", "fem.linear_solver=direct", "needs solver = \"full\""},
        Refused{"", "fem.linear_solver=fourier", "auto | direct | multigrid"},
        Refused{"", "fem.stiffness=true", "needs solver = \"full\""},
        Refused{"[fem.whole]\nsolver = \"full\"\nstiffness = true\n",
                "fem.whole.top=sliding",
                "cannot be combined with this far boundary (top); it needs top "
                "= \"clamped\""},
        Refused{"[fem.whole]\nsolver = \"full\"\nstiffness = true\n",
                "fem.whole.bodies=2", "it needs bodies = 1"},
        Refused{"", "fem.mesh=case", "the table [mesh] is missing"},
        Refused{"[fem.whole]\nsolver = \"full\"\nbodies = 2\n",
                "fem.growth=1.2", "[material.counter] is missing"},
        Refused{"[fem.whole]\nsolver = \"full\"\nbodies = 2\ncontact = "
                "\"hard\"\n[material.counter]\nyoungs_modulus = \"7 GPa\"\n"
                "poisson_ratio = 0.3\n",
                "fem.growth=1.2", "cannot be combined with hard"},
        Refused{"[mesh]\nkind = \"gmsh\"\ngeometry = \"layered\"\n",
                "fem.growth=1.2", "material.layers is missing"},
        Refused{"[mesh]\nkind = \"gmsh\"\ngeometry = \"file\"\n",
                "fem.growth=1.2", "mesh.file is missing"}));

const std::string gmsh = "[mesh]\nkind = \"gmsh\"\ngeometry = ";

INSTANTIATE_TEST_SUITE_P(
    Shapes, RefusedBlock,
    testing::Values(
        Refused{"", "material.layers=3", "must be a list of tables"},
        Refused{"", "material.layers=[]", "must be a list of tables"},
        Refused{"", "material.layers=[3]", "must be a table of thickness"},
        Refused{"", "material.inclusion=3",
                "must be a table: [material.inclusion]"},
        Refused{gmsh + "\"indentation\"\n", "fem.mesh=case",
                "needs solver = \"full\""},
        Refused{"[material.variation]\nkind = \"random\"\nspread = "
                "0.5\nseed = 1\n",
                "fem.growth=1.2", "[material.variation] is not laterally"},
        Refused{"[material.variation]\nkind = \"function\"\nfactor = "
                "\"1 + * x\"\n[fem.whole]\nsolver = \"full\"\n",
                "fem.growth=1.2",
                "material.variation.factor = \"1 + * x\", but must be an "
                "expression of x, y and z: "},
        Refused{"[material.variation]\nkind = \"function\"\nfactor = "
                "\"1 + depth\"\n[fem.whole]\nsolver = \"full\"\n",
                "fem.growth=1.2", "\"depth\" found at position 4. (column 5)"},
        Refused{gmsh + "\"inclusion\"\n", "fem.growth=1.2",
                "[material.inclusion] is missing"}));

TEST(BlockMesh, IsMeshedByGmshAsAFullBlock) {
  const std::string mesh = "[mesh]\nkind = \"gmsh\"\ngeometry = "
                           "\"indentation\"\nsize_at_contact = \"0.5 h\"\n";

  const Case read = block(mesh, full);

  EXPECT_TRUE(fem_of(read).full.uses_case_mesh);
  EXPECT_EQ(read.mesh.geometry, mechanics::MeshGeometry::indentation);
  EXPECT_EQ(read.mesh.size_at_contact.reference,
            mechanics::ReferenceUnit::spacing);
  EXPECT_FALSE(fem_of(block(mesh)).full.uses_case_mesh);
  EXPECT_FALSE(fem_of(block(mesh, {"fem.solver=full", "fem.mesh=layers"}))
                   .full.uses_case_mesh);
}

TEST(BlockMesh, TakesPathsOfMeshesFromTheFolderOfTheCase) {
  const Case read =
      block("[mesh]\nkind = \"gmsh\"\ngeometry = \"file\"\nfile = "
            "\"own.msh\"\nfile_unit = \"1 mm\"\n",
            full);

  EXPECT_EQ(read.mesh.file, "some/own.msh");
  EXPECT_EQ(read.mesh.file_unit, 1e-3);
}

const std::string pair =
    "[fem.pair]\nsolver = \"full\"\nbodies = 2\ncontact = \"penalty\"\n"
    "penalty = \"10 E*/h\"\n[material.counter]\nyoungs_modulus = \"7 GPa\"\n"
    "poisson_ratio = 0.3\n[mesh]\nkind = \"layers\"\n[mesh.counter]\n";

INSTANTIATE_TEST_SUITE_P(
    CounterBody, RefusedBlock,
    testing::Values(
        Refused{pair, "fem.growth=1.2", "mesh.counter.shape is missing"},
        Refused{pair + "shape = \"sphere\"\n", "fem.growth=1.2",
                "needs the radius of the sphere in [surface]"},
        Refused{pair + "shape = \"sphere\"\nradius = 1e-6\n",
                "surface.form_radius=\"2 length\"",
                "does not apply to shape = \"sphere\""},
        Refused{pair + "shape = \"sphere\"\n",
                "surface.form_radius=\"2 length\"",
                "cannot be combined with theory"},
        Refused{pair + "shape = \"cone\"\n", "fem.growth=1.2",
                "must be sphere | cylinder | cuboid"},
        Refused{pair + "shape = \"cylinder\"\n", "fem.growth=1.2",
                "mesh.counter.radius is missing"},
        Refused{pair + "shape = \"cuboid\"\nradius = \"0.2 length\"\n",
                "fem.pair.top=pressure",
                "mesh.counter cannot be combined with fem.pair.top"},
        Refused{"[mesh]\nkind = \"layers\"\n[mesh.counter]\nshape = "
                "\"cuboid\"\nradius = \"0.2 length\"\n",
                "fem.growth=1.2", "no method has solver = \"full\""}));

TEST(BlockMesh, HasACounterBodyOfItsOwnMesh) {
  const Case read = block(pair + "shape = \"cylinder\"\nradius = \"0.2 "
                                 "length\"\noffset_x = \"-0.1 length\"\n");

  ASSERT_TRUE(read.mesh.counter);
  EXPECT_EQ(read.mesh.counter->shape, mechanics::CounterShape::cylinder);
  EXPECT_EQ(read.mesh.counter->radius.value, 0.2);
  EXPECT_EQ(read.mesh.counter->offset_x.value, -0.1);
  EXPECT_FALSE(read.mesh.counter->height);
}

const std::string cylinder =
    pair + "shape = \"cylinder\"\nradius = \"0.2 length\"\n";

INSTANTIATE_TEST_SUITE_P(
    SizesOfACounterBody, RefusedBlock,
    testing::Values(
        Refused{cylinder + "size_at_contact = \"0.5 h\"\n", "fem.element=Q1",
                "must be at least 1.953125e-08 m, the edge of the block's "
                "cells"},
        Refused{cylinder + "size_at_contact = \"0.3 length\"\n",
                "fem.element=Q1",
                "must be between 0 and 2.0000000000000003e-06 [m]"},
        Refused{cylinder + "fine_radius = \"0.3 length\"\n", "fem.element=Q1",
                "mesh.counter.fine_radius = \"0.3 length\", which is 3e-06 m, "
                "but must be between 1.953125e-08 and"},
        Refused{cylinder + "fine_radius = \"1 h\"\nheight = \"1 h\"\n",
                "fem.element=Q1", "twice the fine_radius"},
        Refused{cylinder + "offset_y = \"-0.35 length\"\n", "fem.element=Q1",
                "mesh.counter.offset_y = \"-0.35 length\", which is -3.5"},
        Refused{pair + "shape = \"cuboid\"\nradius = \"0.5 length\"\n",
                "fem.growth=1.2", "and off its periodic sides"},
        Refused{pair + "shape = \"sphere\"\nheight = 1e-7\n",
                "surface.form_radius=\"0.3 length\"",
                "mesh.counter.height = 1e-07, which is 1e-07 m, but must be "
                "between 7.5e-07 and 3e-06 [m]"},
        Refused{pair + "shape = \"sphere\"\n",
                "surface.form_radius=\"0.6 length\"",
                "surface.form_radius = \"0.6 length\", which is 6e-06 m, but "
                "must be such that the body"},
        Refused{cylinder + "height = \"1 h\"\n", "fem.element=Q2",
                "mesh.counter.size_at_contact is not given and is 3.90625e-08 "
                "m by default"}));

TEST(BlockMesh, FreeSidesMayCarryACounterBodyUpToThem) {
  const Case read =
      block(pair + "shape = \"cuboid\"\nradius = \"0.5 length\"\n",
            {"fem.pair.sides=free"});

  EXPECT_EQ(read.mesh.counter->radius.value, 0.5);
}

TEST(BlockMesh, ChecksACounterBodyBelowAMeshOfGmsh) {
  const std::string by_gmsh = "mesh.kind=\"gmsh\"";

  EXPECT_TRUE(block(cylinder, {by_gmsh}).mesh.counter);
  EXPECT_NE(refusal(cylinder + "size_at_contact = \"0.5 h\"\n", {by_gmsh})
                .find("mesh.counter.size_at_contact = \"0.5 h\", which is"),
            std::string::npos);
  EXPECT_NE(refusal(cylinder + "fine_radius = \"0.3 length\"\n", {by_gmsh})
                .find("mesh.counter.fine_radius"),
            std::string::npos);
}

const std::string adaptive = "[fem.whole]\nsolver = \"full\"\n[mesh]\nkind = "
                             "\"adaptive\"\n";

INSTANTIATE_TEST_SUITE_P(
    Adaptive, RefusedBlock,
    testing::Values(
        Refused{adaptive + "halvings = 0\n", "fem.growth=1.2",
                "halvings = 0, but must be between 1 and 12"},
        Refused{adaptive + "halvings = 12\n", "fem.growth=1.2",
                "must be a multiple of that"},
        Refused{adaptive + "[material.counter]\nyoungs_modulus = \"7 GPa\"\n"
                           "poisson_ratio = 0.3\n",
                "fem.whole.bodies=2", "mesh.kind = \"adaptive\" cannot be"},
        Refused{adaptive + "interface_halvings = 4\n", "fem.growth=1.2",
                "must not exceed mesh.halvings = 3"},
        Refused{adaptive + "moduli_ratio = 0.9\n", "fem.growth=1.2",
                "moduli_ratio = 0.9, but must be"},
        Refused{adaptive,
                "material.variation={ kind = \"random\", spread = 0.5, seed = "
                "3 }",
                "needs material.variation.edge"}));

TEST(BlockMesh, HalvesCellsAtTheContact) {
  const Case read = block(adaptive + "halvings = 1\n", {"surface.points=32"});

  EXPECT_EQ(read.mesh.kind, mechanics::MeshKind::adaptive);
  EXPECT_EQ(read.mesh.halvings, 1);
  EXPECT_EQ(read.mesh.moduli_ratio, 1.25);
  EXPECT_FALSE(read.mesh.interface_halvings);
}

TEST(BlockMesh, HalvesCellsForMaterials) {
  const Case read = block(
      "[material.inclusion]\nradius = \"0.1 length\"\ndepth = \"0.2 length\"\n"
      "youngs_modulus = \"9 GPa\"\npoisson_ratio = 0.3\n"
      "[material.variation]\nkind = \"random\"\nspread = 0.5\nseed = 3\n"
      "edge = \"4 h\"\n" +
          adaptive + "halvings = 2\ninterface_halvings = 1\nmoduli_ratio = 2\n",
      {"surface.points=32", "fem.solver=full"});

  EXPECT_EQ(read.mesh.interface_halvings, 1);
  EXPECT_EQ(read.mesh.moduli_ratio, 2.0);
  ASSERT_TRUE(read.material.variation && read.material.variation->edge);
  EXPECT_EQ(read.material.variation->edge->value, 4.0);
}

} // namespace asperity::cases::block_test
