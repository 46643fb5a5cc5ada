// Tests of meshes/gmsh_block.hpp; those of the spherical inclusion are in
// gmsh_inclusion.
#include "meshes/gmsh_block.hpp"
#include "meshes/mesh_bytes.hpp"
#include "meshes/mesh_quality.hpp"
#include "meshes/valid_mesh.hpp"
#include "tests/meshes/mesh_measures.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace asperity::meshes::gmsh_block_test {

using mechanics::BlockSides;
using mechanics::MeshGeometry;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double length = 1e-6;

/// A cube of 1 um with cells of 0.1 um at the contact surface and 0.25 um far
/// from it.
GmshBlock cube(MeshGeometry geometry) {
  GmshBlock block;
  block.geometry = geometry;
  block.length_x = block.length_y = block.depth = length;
  block.size_at_contact = 0.1 * length;
  block.size_far = 0.25 * length;
  block.fine_radius = 0.2 * length;
  block.interfaces = {0.15 * length, 0.5 * length};
  block.inclusion_radius = 0.2 * length;
  block.inclusion_depth = 0.35 * length;
  return block;
}

/// Any block of four or five cells along its shortest side.
GmshBlock any_block() {
  const auto between = [](double low, double high) {
    return std::lerp(low, high, *rc::gen::inRange(0, 1000) / 1000.0);
  };
  GmshBlock block;
  block.geometry =
      *rc::gen::element(MeshGeometry::block, MeshGeometry::indentation,
                        MeshGeometry::layered, MeshGeometry::inclusion);
  block.length_x = length;
  block.length_y = length * between(0.7, 1.4);
  block.depth = length * between(0.5, 2.0);
  const double half =
      0.5 * std::min({block.length_x, block.length_y, block.depth});
  block.size_at_contact = half * between(0.4, 0.5);
  block.size_far = block.size_at_contact * between(1.0, 3.0);
  block.fine_radius = half * between(0.5, 0.8);
  block.interfaces = {block.depth * between(0.1, 0.4),
                      block.depth * between(0.5, 0.9)};
  block.inclusion_radius = half * between(0.5, 0.9);
  block.inclusion_depth =
      std::lerp(1.01 * block.inclusion_radius,
                block.depth - 1.01 * block.inclusion_radius, between(0.0, 1.0));
  return block;
}

/// No cell is inverted, the cells fill the box, the groups fill all six sides,
/// and periodic sides match. Tolerance: eps for each of the terms of the sums.
void expect_valid(const GmshBlock& block) {
  const BlockMesh mesh = gmsh_block(block);

  RC_LOG() << quality_text(mesh_quality(mesh));
  const double rounding = 50 * eps * static_cast<double>(mesh.cells.size());
  const auto is_near = [&](double sum, double expected) {
    return std::abs(sum / expected - 1.0) < rounding;
  };
  const double face = block.length_x * block.length_y;
  RC_ASSERT(test::smallest_jacobian(mesh) > 0.0);
  RC_ASSERT(is_near(test::volume_of(mesh), face * block.depth));
  RC_ASSERT(is_near(test::area_of(mesh, FaceGroup::contact), face));
  RC_ASSERT(is_near(test::area_of(mesh, FaceGroup::far_boundary), face));
  for (const auto side : {FaceGroup::left, FaceGroup::right})
    RC_ASSERT(is_near(test::area_of(mesh, side), block.length_y * block.depth));
  for (const auto side : {FaceGroup::front, FaceGroup::back})
    RC_ASSERT(is_near(test::area_of(mesh, side), block.length_x * block.depth));
  BlockMesh fitted = mesh;
  fit_sides(fitted, BlockSides::periodic);
}

// The default of a hundred blocks would take a quarter of a minute: fewer,
// unless the environment states the number.
const int fewer_blocks = setenv("RC_PARAMS", "max_success=20", 0);

TEST(GmshBlock, IsValidForAnySizes) {
  ASSERT_EQ(fewer_blocks, 0);
  EXPECT_TRUE(rc::check([] { expect_valid(any_block()); }));
}

// The number of nodes that is stated without a mesh is that of the mesh.
TEST(GmshBlock, CountsItsNodesBeforeItIsMeshed) {
  for (const auto geometry : {MeshGeometry::block, MeshGeometry::indentation,
                              MeshGeometry::layered, MeshGeometry::inclusion}) {
    const GmshBlock block = cube(geometry);

    EXPECT_EQ(gmsh_nodes(block, 1),
              static_cast<double>(gmsh_block(block).vertices.size()));
  }
}

// Verifies that no cell is of poor quality: hexahedra stay above the corner of
// the divided cube, 1/sqrt(3), less its skew where the box is not a cube
// (1/sqrt(6) if it is twice as long along one axis).
TEST(GmshBlock, HasNoBadCells) {
  for (const auto geometry : {MeshGeometry::block, MeshGeometry::indentation,
                              MeshGeometry::layered, MeshGeometry::inclusion})
    EXPECT_GT(mesh_quality(gmsh_block(cube(geometry))).smallest_shape,
              1.0 / std::sqrt(6.0));
}

/// The longest edge of the contact faces with a vertex within the radius of the
/// middle, and of those entirely beyond twice that.
EdgeRange near_and_far_edges(const BlockMesh& mesh, double radius) {
  EdgeRange edges{0.0, 0.0};
  for (const BoundaryFace& face : mesh.faces) {
    if (face.group != FaceGroup::contact)
      continue;
    double nearest = length;
    for (std::size_t i = 0; i < 3; ++i) {
      const Place& place = mesh.vertices[face.vertices[i]];
      nearest = std::min(nearest, std::hypot(place[0] - 0.5 * length,
                                             place[1] - 0.5 * length));
    }
    const Place edge = test::minus(mesh.vertices[face.vertices[1]],
                                   mesh.vertices[face.vertices[0]]);
    double& longest = nearest < radius ? edges.smallest : edges.largest;
    if (nearest < radius || nearest > 2.0 * radius)
      longest = std::max(longest, std::sqrt(test::dot(edge, edge)));
  }
  return edges;
}

// Under the indenter the contact surface is as fine as requested, to roundoff,
// and coarser away from it.
TEST(GmshBlock, IsFineUnderTheIndenter) {
  GmshBlock block = cube(MeshGeometry::indentation);
  block.size_at_contact = 0.05 * length;
  const EdgeRange edges =
      near_and_far_edges(gmsh_block(block), 0.9 * block.fine_radius);
  EXPECT_LE(edges.smallest, block.size_at_contact * (1.0 + 1e-9));
  EXPECT_GT(edges.largest, 2.0 * block.size_at_contact);
}

// Interfaces are planes of vertices to the bit and no cell crosses one: the
// groups fill the box between them. Tolerance: sums of roundoff.
TEST(GmshBlock, HasItsInterfacesExactly) {
  const GmshBlock block = cube(MeshGeometry::layered);
  const BlockMesh mesh = gmsh_block(block);

  EXPECT_EQ(mesh.group_names,
            (std::vector<std::string>{"layer 1", "layer 2", "layer 3"}));
  const std::vector<double> depths = {0.0, 0.15 * length, 0.5 * length, length};
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto layer = static_cast<std::size_t>(mesh.cell_group[cell]);
    for (const unsigned int vertex : mesh.cells[cell]) {
      EXPECT_GE(mesh.vertices[vertex][2], depths[layer]);
      EXPECT_LE(mesh.vertices[vertex][2], depths[layer + 1]);
    }
  }
  for (std::size_t layer = 0; layer < 3; ++layer)
    EXPECT_NEAR(test::volume_of(mesh, static_cast<int>(layer)) /
                    (length * length * (depths[layer + 1] - depths[layer])),
                1.0, 1e-11);
}

// Verifies (M.5): the layers of a block start and end near the requested sizes
// and grow evenly. Tolerance: the size of a cell is that of its middle, half a
// ratio from those of its ends, and the count is rounded up by less than one in
// ten.
TEST(GmshBlock, GrowsFromTheContactSurface) {
  GmshBlock block = cube(MeshGeometry::block);
  block.size_at_contact = 0.05 * length;
  const MeshQuality quality = mesh_quality(gmsh_block(block));

  EXPECT_NEAR(quality.contact_edges.smallest, 0.05 * length, 1e-9 * length);
  EXPECT_NEAR(quality.edges.smallest / length, 0.05, 0.2 * 0.05);
  EXPECT_NEAR(quality.edges.largest / length, 0.25, 0.2 * 0.25);
}

// A block with an inclusion in its middle is invariant under rotation by 180
// degrees. Tolerance: gmsh divides a curve by its length, integrated to 1e-8.
TEST(GmshBlock, IsInvariantUnderHalfATurn) {
  for (const auto geometry :
       {MeshGeometry::indentation, MeshGeometry::inclusion}) {
    const BlockMesh mesh = gmsh_block(cube(geometry));
    const auto has_vertex = [&](const Place& place) {
      return std::any_of(
          mesh.vertices.begin(), mesh.vertices.end(), [&](const Place& vertex) {
            const Place apart = test::minus(vertex, place);
            return test::dot(apart, apart) < 1e-16 * length * length;
          });
    };

    EXPECT_TRUE(std::all_of(
        mesh.vertices.begin(), mesh.vertices.end(), [&](const Place& place) {
          return has_vertex({length - place[0], length - place[1], place[2]});
        }));
  }
}

// The same arguments give the same bits, whatever was meshed in between and
// with any number of threads.
TEST(GmshBlock, IsTheSameEachTime) {
  const GmshBlock block = cube(MeshGeometry::inclusion);
  const BlockMesh first = gmsh_block(block);
  gmsh_block(cube(MeshGeometry::layered));
  BlockMesh second;
  BlockMesh third;
  std::thread one([&] { second = gmsh_block(block); });
  std::thread other([&] { third = gmsh_block(block); });
  one.join();
  other.join();

  EXPECT_TRUE(bytes_of(first) == bytes_of(second));
  EXPECT_TRUE(bytes_of(first) == bytes_of(third));
}

TEST(GmshBlock, RefusesImpossibleNumbers) {
  const auto refusal = [](MeshGeometry geometry, double GmshBlock::*member,
                          double value) {
    GmshBlock block = cube(geometry);
    block.*member = value;
    return tests::message_of<std::domain_error>([&] { gmsh_block(block); })
        .substr(0, 16);
  };
  using enum MeshGeometry;
  EXPECT_EQ(refusal(block, &GmshBlock::depth, 0.0), "depth = 0, but m");
  EXPECT_EQ(refusal(block, &GmshBlock::size_at_contact, 3e-7),
            "size_at_contact ");
  EXPECT_EQ(refusal(block, &GmshBlock::size_far, 5e-8), "size_far = 5e-08");
  EXPECT_EQ(refusal(indentation, &GmshBlock::fine_radius, 4.5e-7),
            "fine_radius = 4.");
  EXPECT_EQ(refusal(inclusion, &GmshBlock::inclusion_radius, 5e-7),
            "inclusion_radius");
  EXPECT_EQ(refusal(inclusion, &GmshBlock::inclusion_depth, 1.9e-7),
            "inclusion_depth ");
  EXPECT_EQ(refusal(inclusion, &GmshBlock::inclusion_depth, 8.1e-7),
            "inclusion_depth ");
  EXPECT_EQ(refusal(file, &GmshBlock::depth, 1e-6), "gmsh_block: the ");
  GmshBlock crossed = cube(layered);
  crossed.interfaces = {5e-7, 2e-7};
  EXPECT_THROW(gmsh_block(crossed), std::domain_error);
}

} // namespace asperity::meshes::gmsh_block_test
