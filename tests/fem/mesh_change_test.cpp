// Tests of fem/adaptive/mesh_change.hpp: a change of the mesh preserves a field
// and the match of periodic sides, and is the planned one on any number of
// ranks.
#include "fem/adaptive/mesh_change.hpp"
#include "meshes/layered_mesh.hpp"
#include "tests/fem/changing_mesh.hpp"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace asperity::fem::mesh_change_test {

constexpr int most_levels = 2;

/// The place of a cell in a mesh of four coarsest cells per side: the layer is
/// that of its coarsest ancestor, and each halving adds a bit.
BoxCell box_of(const Mesh::cell_iterator& cell) {
  if (cell->level() > 0) {
    BoxCell box = box_of(cell->parent());
    for (unsigned int i = 0; i < 3; ++i)
      box.place[i] =
          2 * box.place[i] +
          static_cast<int>(cell->center()[i] > cell->parent()->center()[i]);
    return {box.level + 1, box.place};
  }
  std::set<double> above;
  for (const auto& other : cell->get_triangulation().cell_iterators_on_level(0))
    if (other->center()[2] < cell->bounding_box().lower_bound(2))
      above.insert(other->bounding_box().lower_bound(2));
  return {0,
          {static_cast<int>(cell->center()[0] / side * 4),
           static_cast<int>(cell->center()[1] / side * 4),
           static_cast<int>(above.size())}};
}

/// A random change of a cell that is not yet of the finest level. Cells of one
/// parent often merge.
CellChange random_change(const BoxCell& cell, unsigned int seed,
                         int levels = most_levels) {
  const auto thrown = [&](const BoxCell& of) {
    return random_field(
               1, static_cast<unsigned int>(seed + 31 * of.key() % 1000003))
        .front();
  };
  if (thrown(cell) < 0.1 && cell.level < levels)
    return CellChange::refine;
  const auto& [x, y, z] = cell.place;
  return thrown({cell.level + 1, {x / 2, y / 2, z / 2}}) > 0.4
             ? CellChange::coarsen
             : CellChange::none;
}

std::vector<CellChange> random_changes(const Mesh& mesh, unsigned int seed,
                                       int levels = most_levels) {
  std::vector<CellChange> changes(mesh.n_active_cells());
  for (const auto& cell : mesh.active_cell_iterators())
    changes[cell->active_cell_index()] =
        random_change(box_of(cell), seed, levels);
  return changes;
}

/// The largest relative difference between a field that has been carried over
/// and the field itself, over several changes.
double worst_transfer(int degree, const Field& field) {
  const BlockProblem problem =
      problem_of(degree, mechanics::BlockSides::periodic);
  const auto mesh = mesh_of(problem);
  double worst = 0.0;
  std::size_t merged = 0;
  for (unsigned int seed = 1; seed <= 4; ++seed) {
    const auto before = vertical_displacement(BlockSpace(problem, mesh), field);
    MeshChange change(problem, *mesh, random_changes(*mesh, seed));
    merged += change.count().coarsened;
    auto found = change.execute(before, [] {});
    const auto expected =
        vertical_displacement(BlockSpace(problem, mesh), field);
    EXPECT_EQ(found.size(), expected.size());
    found -= expected;
    worst = std::max(worst, found.linfty_norm() / expected.linfty_norm());
  }
  EXPECT_GT(merged, 0U);
  return worst;
}

// The transfer reproduces what the elements can hold: linear fields, and
// with second order quadratic ones, but with first order not.
TEST(MeshChange, KeepsPolynomials) {
  const Field linear = [](const dealii::Point<3>& p) {
    return 1e-7 + 0.3 * p[0] - 0.2 * p[1] + 0.5 * p[2];
  };
  const Field quadratic = [](const dealii::Point<3>& p) {
    return (p[0] * p[0] - 2.0 * p[0] * p[1] + p[2] * p[1]) / side;
  };

  EXPECT_LT(worst_transfer(1, linear), 1e-13);
  EXPECT_LT(worst_transfer(2, linear), 1e-13);
  EXPECT_LT(worst_transfer(2, quadratic), 1e-13);
  EXPECT_GT(worst_transfer(1, quadratic), 1e-3);
}

// Opposite sides match after any change; BlockSpace refuses sides that
// do not, as those that change at random without regard for the other side.
TEST(MeshChange, KeepsPeriodicSidesEqual) {
  const BlockProblem periodic = problem_of(1, mechanics::BlockSides::periodic);
  const BlockProblem free = problem_of(1, mechanics::BlockSides::free);
  const auto equal = mesh_of(periodic);
  const auto other = mesh_of(free);
  for (unsigned int seed = 1; seed <= 8; ++seed) {
    const auto change = [&](const BlockProblem& problem, Mesh& mesh) {
      const MeshChange flags(problem, mesh, random_changes(mesh, seed));
      mesh.execute_coarsening_and_refinement();
    };
    change(periodic, *equal);
    change(free, *other);
    EXPECT_NO_THROW(BlockSpace(periodic, equal)) << seed;
  }
  EXPECT_THROW(BlockSpace(periodic, other), std::domain_error);
}

// All of eight cells merge again, at periodic sides too.
TEST(MeshChange, UndoesARefinement) {
  for (const auto sides :
       {mechanics::BlockSides::periodic, mechanics::BlockSides::free}) {
    const BlockProblem problem = problem_of(2, sides);
    const auto mesh = mesh_of(problem);
    const auto change_all = [&](CellChange what) {
      MeshChange change(problem, *mesh,
                        std::vector<CellChange>(mesh->n_active_cells(), what));
      static_cast<void>(
          change.execute(BlockSpace(problem, mesh).make_vector(), [] {}));
      return mesh->n_global_active_cells();
    };

    EXPECT_EQ(change_all(CellChange::refine), 8U * 64U);
    EXPECT_EQ(change_all(CellChange::coarsen), 64U);
  }
}

/// The cells of all ranks, by key.
std::vector<std::uint64_t> cells_of(const Mesh& mesh) {
  std::vector<std::uint64_t> own;
  for (const auto& cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      own.push_back(box_of(cell).key());
  std::vector<std::uint64_t> all;
  for (const auto& part :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
    all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all);
  return all;
}

/// A list of cells after a plan.
std::vector<BoxCell> planned(const std::vector<BoxCell>& cells,
                             const MeshPlan& plan) {
  std::vector<BoxCell> after;
  for (const BoxCell& cell : cells) {
    const CellChange change = plan.change_of(cell);
    const auto& [x, y, z] = cell.place;
    if (change == CellChange::none)
      after.push_back(cell);
    else if (change == CellChange::refine)
      for (int child = 0; child < 8; ++child)
        after.push_back(
            {cell.level + 1,
             {2 * x + child % 2, 2 * y + child / 2 % 2, 2 * z + child / 4}});
    else if (x % 2 + y % 2 + z % 2 == 0)
      after.push_back({cell.level - 1, {x / 2, y / 2, z / 2}});
  }
  return after;
}

/// Changes a mesh of 4^3 coarsest cells at random and compares it with the list
/// of cells that is planned without it.
void expect_what_is_planned(const BlockProblem& problem) {
  constexpr int levels = 3;
  const auto mesh = mesh_of(problem);
  std::vector<BoxCell> cells;
  for (int i = 0; i < 64; ++i)
    cells.push_back({0, {i % 4, i / 4 % 4, i / 16}});
  std::size_t merged = 0;
  for (unsigned int seed = 1; seed <= 8; ++seed) {
    std::vector<MeshPlan::Wish> wishes;
    for (const BoxCell& cell : cells)
      wishes.push_back({cell, random_change(cell, seed, levels)});
    const MeshPlan plan({4, 4, 4}, true, wishes);
    cells = planned(cells, plan);

    MeshChange change(problem, *mesh, random_changes(*mesh, seed, levels));
    merged += change.count().coarsened;
    mesh->execute_coarsening_and_refinement();

    std::vector<std::uint64_t> expected;
    for (const BoxCell& cell : cells)
      expected.push_back(cell.key());
    std::ranges::sort(expected);
    EXPECT_EQ(cells.size(), plan.cells_after());
    ASSERT_TRUE(cells_of(*mesh) == expected) << seed;
  }
  EXPECT_EQ(mesh->n_global_levels(), levels + 1U);
  EXPECT_GT(merged, 0U);
}

// Random changes of three levels give the mesh of a list of cells that knows
// neither deal.II nor ranks, over many changes; under a thin coating too, where
// the layers of the coarsest cells have different thicknesses.
TEST(MeshChange, DoesWhatIsPlanned) {
  BlockProblem problem = problem_of(1, mechanics::BlockSides::periodic);
  expect_what_is_planned(problem);
  problem.mesh = meshes::layered_mesh(
      {4, 4, side, side}, {0.01 * side, 0.1 * side, 0.5 * side, 0.39 * side});
  expect_what_is_planned(problem);
}

} // namespace asperity::fem::mesh_change_test
