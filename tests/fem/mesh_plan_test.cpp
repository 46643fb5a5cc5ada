// Tests of fem/refined/mesh_plan.hpp: which cells of halved boxes are halved or
// merge, so that neighbours differ by one halving.
#include "fem/refined/mesh_plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace asperity::fem::mesh_plan_test {

using Box = BoxCell;

/// The eight cells of half the edge in a cube, one of them halved `more` times
/// at the corner that the other seven share; all wish to merge.
std::vector<MeshPlan::Wish> nested_cubes(int more) {
  std::vector<MeshPlan::Wish> wishes;
  Box inner{1, {0, 0, 0}};
  for (int depth = 0; depth <= more; ++depth) {
    const auto& [x, y, z] = inner.place;
    const std::array<int, 3> base{x / 2 * 2, y / 2 * 2, z / 2 * 2};
    for (int child = 0; child < 8; ++child) {
      const Box cell{
          inner.level,
          {base[0] + child % 2, base[1] + child / 2 % 2, base[2] + child / 4}};
      if (depth == more || cell.place != inner.place)
        wishes.push_back({cell, CellChange::coarsen});
    }
    inner = {inner.level + 1,
             {2 * inner.place[0], 2 * inner.place[1], 2 * inner.place[2]}};
  }
  return wishes;
}

// Eight cells merge if all of them are cells, and only these: a cell that is
// halved once more keeps its seven neighbours.
TEST(MeshPlan, MergesCompleteFamilies) {
  const MeshPlan flat({1, 1, 1}, false, nested_cubes(0));
  const MeshPlan nested({1, 1, 1}, false, nested_cubes(1));

  EXPECT_EQ(flat.count().coarsened, 8U);
  EXPECT_EQ(flat.cells_after(), 1U);
  EXPECT_EQ(nested.count().coarsened, 8U);
  EXPECT_EQ(nested.cells_after(), 8U);
  EXPECT_EQ(nested.change_of({1, {0, 0, 0}}), CellChange::none);
  EXPECT_EQ(nested.change_of({1, {1, 0, 0}}), CellChange::none);
  EXPECT_EQ(nested.change_of({0, {0, 0, 0}}), CellChange::refine);
}

// A cell that refines takes along a larger cell that touches it at a vertex,
// and a cell at the opposite periodic side.
TEST(MeshPlan, RefinesForItsRules) {
  std::vector<MeshPlan::Wish> wishes;
  for (int i = 1; i < 8; ++i)
    wishes.push_back({{0, {i % 2, i / 2 % 2, i / 4}}});
  for (int i = 0; i < 8; ++i)
    wishes.push_back({{1, {i % 2, i / 2 % 2, i / 4}},
                      i == 7 ? CellChange::refine : CellChange::none});
  const MeshPlan plan({2, 2, 2}, false, wishes);
  EXPECT_EQ(plan.count().refined, 8U);
  EXPECT_EQ(plan.change_of({0, {1, 1, 1}}), CellChange::refine);

  const std::vector<MeshPlan::Wish> row{
      {{0, {0, 0, 0}}, CellChange::refine}, {{0, {1, 0, 0}}}, {{0, {2, 0, 0}}}};
  EXPECT_EQ(MeshPlan({3, 1, 1}, false, row).count().refined, 1U);
  const MeshPlan periodic({3, 1, 1}, true, row);
  EXPECT_EQ(periodic.count().refined, 2U);
  EXPECT_EQ(periodic.change_of({0, {2, 0, 0}}), CellChange::refine);
}

} // namespace asperity::fem::mesh_plan_test
