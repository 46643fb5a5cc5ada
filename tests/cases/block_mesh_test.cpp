// Tests of [mesh] in a case: meshes by gmsh, from files, of a counter-body and
// adaptive ones, and the messages about invalid ones.
#include <gtest/gtest.h>

#include <string>

#include "tests/cases/block_samples.hpp"

namespace asperity::cases::block_mesh_test {

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

// The vertices of a tetrahedron of second order have no area.
INSTANTIATE_TEST_SUITE_P(Tetrahedra, RefusedBlock,
                         testing::Values(Refused{
                             "[fem.tets]\nsolver = \"full\"\nelement = \"Q2\"\n"
                             "[mesh]\nkind = \"gmsh\"\n"
                             "cells = \"tetrahedra\"\n",
                             "fem.growth=1.2",
                             "fem.tets.contact_at = \"nodes\" cannot be "
                             "combined with mesh.cells = \"tetrahedra\""}));

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

} // namespace asperity::cases::block_mesh_test
