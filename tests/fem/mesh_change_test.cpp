// Tests of fem/adaptive/mesh_change.hpp, mesh_plan.hpp and
// stress_indicator.hpp: a change of the mesh preserves a field, the match of
// periodic sides and an exact stress, and is the planned one on any number of
// ranks.
#include "fem/adaptive/mesh_change.hpp"
#include "fem/adaptive/stress_indicator.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>

#include "tests/fem/bent_block.hpp"

namespace asperity::fem {
namespace {

constexpr double length = 1e-6; // m
constexpr int most_levels = 2;

using Mesh = MeshChange::Mesh;
using Field = std::function<double(const dealii::Point<3>&)>;

BlockProblem problem_of(int degree, mechanics::BlockSides sides) {
  return {.grid = {16 * degree, 16 * degree, length, length},
          .mesh = meshes::equal_boxes({4, 4, length, length}, length),
          .degree = degree,
          .moduli = ModuliField(moduli({soft_modulus, 0.3})),
          .sides = sides};
}

std::shared_ptr<Mesh> mesh_of(const BlockProblem& problem) {
  start_mpi();
  std::shared_ptr<dealii::parallel::TriangulationBase<3>> mesh =
      make_triangulation(problem.mesh, false);
  return std::dynamic_pointer_cast<Mesh>(mesh);
}

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
          {static_cast<int>(cell->center()[0] / length * 4),
           static_cast<int>(cell->center()[1] / length * 4),
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
    return (p[0] * p[0] - 2.0 * p[0] * p[1] + p[2] * p[1]) / length;
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
      {4, 4, length, length},
      {0.01 * length, 0.1 * length, 0.5 * length, 0.39 * length});
  expect_what_is_planned(problem);
}

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

// A uniform strain in two materials has a step of the stress between
// them, which is no error, not even if a solver left the displacement inexact
// by 1e-6; a strain that varies along a cell has one.
TEST(StressIndicator, IsZeroForASteppedStress) {
  BlockProblem problem = problem_of(1, mechanics::BlockSides::free);
  LayeredBlock layers;
  for (const double modulus : {3.0 * soft_modulus, soft_modulus})
    layers.layers.push_back(elastic_layer(0.5 * length, modulus, 0.3));
  problem.moduli = ModuliField(layers);
  const BlockSystem system(problem);
  const auto largest = [&](const Field& field) {
    const auto indicator =
        stress_indicator(system, vertical_displacement(system.space(), field));
    return *std::max_element(indicator.begin(), indicator.end());
  };

  // Both vanish at the clamped far boundary.
  const std::vector<double> noise = random_field(1000, 5);
  EXPECT_EQ(largest([&](const dealii::Point<3>& p) {
              const std::size_t i = std::hash<double>()(p[0] + 7.0 * p[1]);
              return (1e-3 + 1e-9 * noise[i % noise.size()]) *
                     (p[2] < 0.5 * length ? 2.0 * p[2] - 1.5 * length
                                          : p[2] - length);
            }),
            0.0);
  EXPECT_GT(largest([](const dealii::Point<3>& p) {
              return 1e-3 * (p[2] * p[2] / length - length);
            }),
            0.0);
}

// Where E varies smoothly, every cell is another material. The indicator must
// still compare a cell with its neighbours: of one displacement it is that of
// the uniform block, with the modulus of the cell, to roundoff. Averages of
// single cells, ratio 1, miss all of it, because first-order cells have no
// curvature in them.
TEST(StressIndicator, ComparesCellsWhoseModuliDifferLittle) {
  const BlockProblem uniform = problem_of(1, mechanics::BlockSides::free);
  BlockProblem varied = uniform;
  const auto factor = [](const meshes::Place& place) {
    return 1.0 + 0.3 * place[2] / length;
  };
  varied.moduli.set_factor(factor);
  const auto indicators = [&](const BlockProblem& problem, double ratio) {
    const BlockSystem system(problem);
    const auto displacement =
        vertical_displacement(system.space(), [](const dealii::Point<3>& p) {
          return 1e-3 * (p[2] * p[2] * p[2] / (length * length) - length);
        });
    return std::pair{mesh_of(problem),
                     stress_indicator(system, displacement, ratio)};
  };
  const auto [mesh, expected] = indicators(uniform, 1.0);
  const std::vector<double> found = indicators(varied, 1.25).second;
  const std::vector<double> alone = indicators(varied, 1.0).second;
  for (const auto& cell : mesh->active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const auto i = cell->active_cell_index();
    const dealii::Point<3> centre = cell->center();
    const double root = std::sqrt(factor({centre[0], centre[1], centre[2]}));
    EXPECT_NEAR(found[i], root * expected[i], 1e-10 * expected[i]);
    EXPECT_LT(alone[i], 1e-6 * found[i]);
  }
}

} // namespace
} // namespace asperity::fem
