// Tests of the spherical inclusion of meshes/gmsh_block.hpp.
#include "meshes/gmsh_block.hpp"
#include "tests/meshes/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace asperity::meshes::gmsh_inclusion_test {

constexpr double length = 1e-6;
constexpr double radius = 0.4 * length;
const Place centre = {0.5 * length, 0.5 * length, 0.5 * length};

BlockMesh with_ball(double size) {
  GmshBlock block;
  block.geometry = mechanics::MeshGeometry::inclusion;
  block.length_x = block.length_y = block.depth = length;
  block.size_at_contact = size;
  block.size_far = size;
  block.inclusion_radius = radius;
  block.inclusion_depth = centre[2];
  return gmsh_block(block);
}

std::set<unsigned int> vertices_of_group(const BlockMesh& mesh, int group) {
  std::set<unsigned int> vertices;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_group[cell] == group)
      vertices.insert(mesh.cells[cell].begin(), mesh.cells[cell].end());
  return vertices;
}

// The cells conform to the sphere: the vertices common to inclusion and block
// lie on it, the other vertices of the inclusion inside and those of the block
// outside. Tolerance: the surfaces of gmsh's built-in kernel are accurate to
// 1e-9 of the block.
TEST(GmshInclusion, ConformsToTheSphere) {
  const BlockMesh mesh = with_ball(0.1 * length);

  ASSERT_EQ(mesh.group_names, (std::vector<std::string>{"block", "inclusion"}));
  const auto outside = vertices_of_group(mesh, 0);
  const auto inside = vertices_of_group(mesh, 1);
  std::size_t n_shared = 0;
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const Place from_centre = test::minus(mesh.vertices[vertex], centre);
    const double beyond =
        std::sqrt(test::dot(from_centre, from_centre)) - radius;
    const auto number = static_cast<unsigned int>(vertex);
    if (inside.contains(number) && outside.contains(number)) {
      EXPECT_NEAR(beyond, 0.0, 1e-9 * length);
      ++n_shared;
    } else {
      EXPECT_EQ(beyond > 0.0, outside.contains(number));
    }
  }
  EXPECT_GT(n_shared, 30u);
}

double missing_volume(double size) {
  const double exact = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  return 1.0 - test::volume_of(with_ball(size), 1) / exact;
}

// The volume of the inclusion converges from below, at second order: faces of
// size h miss caps of height h^2 / (8 R). The sizes divide the box around the
// inclusion (0.9 of the block wide) into 6, 12 and 24. Tolerance: the next
// order, h^4, contributes (h/R)^2 / 4 of the error or 0.03 to the first of the
// two orders.
TEST(GmshInclusion, ConvergesToTheSphere) {
  const double coarse = missing_volume(0.9 / 6.0 * length);
  const double middle = missing_volume(0.9 / 12.0 * length);
  const double fine = missing_volume(0.9 / 24.0 * length);

  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.03);
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.03);
}

} // namespace asperity::meshes::gmsh_inclusion_test
