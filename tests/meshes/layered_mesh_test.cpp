// Tests of meshes/layered_mesh.hpp.
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "tests/meshes/mesh_measures.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <stdexcept>
#include <string>

namespace asperity::meshes::layered_mesh_test {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::string refusal(const Grid& face, const std::vector<double>& thickness) {
  return tests::message_of<std::domain_error>(
      [&] { layered_mesh(face, thickness); });
}

/// The side of the box on which a face lies, from the positions of its vertices
/// alone.
FaceGroup side_of(const BlockMesh& mesh, const BoundaryFace& face) {
  const auto all_have = [&](std::size_t d, double value) {
    for (const unsigned int vertex : face.vertices)
      if (mesh.vertices[vertex][d] != value)
        return false;
    return true;
  };
  if (all_have(0, 0.0))
    return FaceGroup::left;
  if (all_have(0, mesh.length_x))
    return FaceGroup::right;
  if (all_have(1, 0.0))
    return FaceGroup::front;
  if (all_have(1, mesh.length_y))
    return FaceGroup::back;
  if (all_have(2, 0.0))
    return FaceGroup::contact;
  return all_have(2, mesh.depth) ? FaceGroup::far_boundary : FaceGroup::sides;
}

// For any counts no cell is inverted, the cells fill the box, each face has the
// group of its position, and the groups fill the six sides of the box.
// Tolerance: eps for each of the terms of the sums.
TEST(LayeredMesh, FillsTheBox) {
  const bool holds = rc::check([] {
    const Grid face{*rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7), 3e-9,
                    2e-9};
    const int n_layers = *rc::gen::inRange(1, 6);
    std::vector<double> thickness;
    for (int i = 0; i < n_layers; ++i)
      thickness.push_back(1e-10 * *rc::gen::inRange(1, 50));

    const BlockMesh mesh = layered_mesh(face, thickness);

    const double area = face.length_x * face.length_y;
    const double rounding = 20 * eps * static_cast<double>(mesh.cells.size());
    RC_ASSERT(test::smallest_jacobian(mesh) > 0.0);
    RC_ASSERT(std::abs(test::volume_of(mesh) / (area * mesh.depth) - 1.0) <
              rounding);
    const std::map<FaceGroup, double> areas = {
        {FaceGroup::contact, area},
        {FaceGroup::far_boundary, area},
        {FaceGroup::left, face.length_y * mesh.depth},
        {FaceGroup::right, face.length_y * mesh.depth},
        {FaceGroup::front, face.length_x * mesh.depth},
        {FaceGroup::back, face.length_x * mesh.depth}};
    for (const auto& [group, expected] : areas)
      RC_ASSERT(std::abs(test::area_of(mesh, group) / expected - 1.0) <
                rounding);
    for (const BoundaryFace& side : mesh.faces)
      RC_ASSERT(side_of(mesh, side) == side.group);
  });
  EXPECT_TRUE(holds);
}

// Vertices lie at the depths of the layers, columns are equal, x is fastest.
// Tolerance: eps of the sum of three thicknesses and of one division.
TEST(LayeredMesh, HasTheRequestedLayers) {
  const std::vector<double> thickness = {1.0, 1.5, 2.25};
  const Grid face{3, 2, 6.0, 8.0};

  const BlockMesh mesh = layered_mesh(face, thickness);

  ASSERT_EQ(mesh.vertices.size(), 4u * 3u * 4u);
  ASSERT_EQ(mesh.cells.size(), 3u * 2u * 3u);
  EXPECT_EQ(mesh.cell_group, std::vector<int>(18, 0));
  const std::vector<double> depths = {0.0, 1.0, 2.5, 4.75};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        const Place& vertex = mesh.vertices[i + 4 * (j + 3 * k)];
        EXPECT_NEAR(vertex[0], 2.0 * static_cast<double>(i), 6 * eps);
        EXPECT_NEAR(vertex[1], 4.0 * static_cast<double>(j), 8 * eps);
        EXPECT_NEAR(vertex[2], depths[k], 5 * eps);
      }
}

// Cells are in deal.II's order: bit d of the number of a corner states on which
// side of the cell it is along d.
TEST(LayeredMesh, NumbersCornersLexicographically) {
  const BlockMesh mesh =
      layered_mesh({2, 3, 1.0, 1.0}, graded_layers(0.25, 1.5, 1.0));

  for (const auto& cell : mesh.cells)
    for (std::size_t corner = 0; corner < 8; ++corner)
      for (std::size_t d = 0; d < 3; ++d)
        if ((corner >> d & 1U) == 0) {
          const std::size_t next = corner | std::size_t{1} << d;
          EXPECT_GT(mesh.vertices[cell[next]][d],
                    mesh.vertices[cell[corner]][d]);
        }
}

TEST(LayeredMesh, RefusesImpossibleArguments) {
  EXPECT_NE(refusal({0, 2, 1.0, 1.0}, {1.0}).find("points_x"),
            std::string::npos);
  EXPECT_NE(refusal({2, 2, 1.0, -1.0}, {1.0}).find("length_y"),
            std::string::npos);
  EXPECT_NE(refusal({2, 2, 1.0, 1.0}, {}).find("number of layers"),
            std::string::npos);
  EXPECT_NE(refusal({2, 2, 1.0, 1.0}, {1.0, 0.0}).find("thickness"),
            std::string::npos);
  EXPECT_NE(refusal({60000, 60000, 1.0, 1.0}, {1.0}).find("vertices"),
            std::string::npos);
}

} // namespace asperity::meshes::layered_mesh_test
