// Tests of meshes/hanging_mesh.hpp.
#include "meshes/hanging_mesh.hpp"
#include "tests/meshes/mesh_measures.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <stdexcept>
#include <string>

namespace asperity::meshes::hanging_mesh_test {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The layers of one column after the cuts, by the rule of block_mesh.hpp:
/// thickness and number of cuts, starting at the contact surface.
struct Layer {
  double top = 0.0; ///< nearer to the contact surface
  double bottom = 0.0;
  int cuts = 0;
};

std::vector<Layer> layers_after_cuts(const BlockMesh& mesh) {
  std::set<double> depths;
  for (const Place& vertex : mesh.vertices)
    depths.insert(vertex[2]);
  std::vector<Layer> layers;
  for (auto next = std::next(depths.begin()); next != depths.end(); ++next)
    layers.push_back({*std::prev(next), *next, 0});
  for (const double depth : mesh.refine_below) {
    std::vector<Layer> cut;
    for (const Layer& layer : layers) {
      const double centre = 0.5 * (layer.top + layer.bottom);
      if (centre < depth) {
        cut.push_back({layer.top, centre, layer.cuts + 1});
        cut.push_back({centre, layer.bottom, layer.cuts + 1});
      } else {
        cut.push_back(layer);
      }
    }
    layers = cut;
  }
  return layers;
}

double coarse_edge(const BlockMesh& mesh) {
  const auto& cell = mesh.cells.front();
  return mesh.vertices[cell[1]][0] - mesh.vertices[cell[0]][0];
}

// After the cuts the contact surface has the requested cells, every level is m
// or m + 1 cells thick, neighbours differ by one cut, the layers end at the
// depth, and boxes are cubes to 1 / (2 m). Tolerance: eps for each of the terms
// of the sum.
TEST(HangingMesh, HasTheRequestedLevels) {
  const bool holds = rc::check([] {
    const int cells_a_level = *rc::gen::inRange(1, 7);
    const int points = *rc::gen::inRange(1, 4) * (1 << *rc::gen::inRange(1, 8));
    const double length = 1e-6;
    const double depth = length * *rc::gen::inRange(2, 40) / 10.0;

    const BlockMesh mesh =
        hanging_mesh({points, points, length, length}, depth, cells_a_level);
    const std::vector<Layer> layers = layers_after_cuts(mesh);

    const auto n_cuts = static_cast<int>(mesh.refine_below.size());
    RC_ASSERT(std::abs(coarse_edge(mesh) * points / (1 << n_cuts) / length -
                       1.0) < 4 * eps);
    RC_ASSERT(layers.front().cuts == n_cuts);
    RC_ASSERT(layers.back().cuts == 0);
    RC_ASSERT(std::abs(mesh.depth / depth - 1.0) < 1e-13);
    std::vector<int> cells(static_cast<std::size_t>(n_cuts) + 1, 0);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      ++cells[static_cast<std::size_t>(layers[i].cuts)];
      const double edge = coarse_edge(mesh) / (1 << layers[i].cuts);
      const double ratio = (layers[i].bottom - layers[i].top) / edge;
      if (n_cuts > 0)
        RC_ASSERT(std::abs(ratio - 1.0) <= 0.5 / cells_a_level + 1e-9);
      if (i > 0) {
        RC_ASSERT(layers[i].cuts <= layers[i - 1].cuts);
        RC_ASSERT(layers[i].cuts >= layers[i - 1].cuts - 1);
      }
    }
    for (std::size_t cuts = 1; cuts < cells.size(); ++cuts) {
      RC_ASSERT(cells[cuts] >= cells_a_level);
      RC_ASSERT(cells[cuts] <= cells_a_level + 1);
    }
    if (n_cuts > 0)
      RC_ASSERT(cells[0] >= cells_a_level);
  });
  EXPECT_TRUE(holds);
}

// Verifies (M.2) for 64 cells per side, as deep as wide, m = 4: d = 4, 12 (and
// 32, which would leave the coarse cells of edge 8 the last 32: four).
TEST(HangingMesh, FollowsM2) {
  const BlockMesh mesh = hanging_mesh({64, 64, 64.0, 64.0}, 64.0, 4);

  EXPECT_EQ(mesh.refine_below, (std::vector<double>{32.0, 12.0, 4.0}));
  EXPECT_EQ(mesh.cells.size(), 8u * 8u * 8u);
  EXPECT_EQ(coarse_edge(mesh), 8.0);
}

// A shallow block is the uniform mesh, and a deep one of few cells has two
// coarse cells per side.
TEST(HangingMesh, StopsWhereTheBlockEnds) {
  const BlockMesh shallow = hanging_mesh({16, 16, 16.0, 16.0}, 4.0, 4);
  const BlockMesh deep = hanging_mesh({16, 32, 16.0, 32.0}, 300.0, 4);

  EXPECT_TRUE(shallow.refine_below.empty());
  EXPECT_EQ(shallow.cells.size(), 16u * 16u * 4u);
  EXPECT_EQ(coarse_edge(deep), 8.0);
  EXPECT_NEAR(test::volume_of(deep) / (16.0 * 32.0 * 300.0), 1.0, 1e3 * eps);
}

TEST(HangingMesh, RefusesOddCounts) {
  const auto refusal = [](int points_x, int points_y, int cells_a_level) {
    return tests::message_of<std::domain_error>([&] {
      hanging_mesh({points_x, points_y, 1.0, 1.0}, 1.0, cells_a_level);
    });
  };

  EXPECT_NE(refusal(16, 15, 4).find("= 15, but must be even"),
            std::string::npos);
  EXPECT_NE(refusal(0, 16, 4).find("= 0, but must be even"), std::string::npos);
  EXPECT_NE(refusal(16, 16, 0).find("cells_a_level"), std::string::npos);
}

} // namespace asperity::meshes::hanging_mesh_test
