// Tests of fem/adaptive/material_marks.hpp: cells that layers, an inclusion or
// a variation of the moduli require.
#include "fem/adaptive/material_marks.hpp"
#include "fem/adaptive/refinement_rule.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/halvable_layers.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace asperity::fem::material_marks_test {

constexpr double length = 1e-6; // m, of a side and of the depth
constexpr int halvings = 4;
constexpr Moduli soft{1e9, 1e9}; // Pa
constexpr Moduli hard{2e9, 2e9};

using Mesh = MeshChange::Mesh;

BlockProblem problem_with(const ModuliField& moduli) {
  return {.grid = {64, 64, length, length},
          .mesh = meshes::equal_boxes({4, 4, length, length}, length),
          .degree = 1,
          .moduli = moduli,
          .adaptive = AdaptiveMesh{halvings}};
}

std::shared_ptr<Mesh> refined(const BlockProblem& problem) {
  start_mpi();
  std::shared_ptr<dealii::parallel::TriangulationBase<3>> mesh =
      make_triangulation(problem.mesh, false);
  auto adaptive = std::dynamic_pointer_cast<Mesh>(mesh);
  refine_for_materials(problem, *adaptive);
  return adaptive;
}

void for_each_cell(
    Mesh& mesh,
    const std::function<void(const Mesh::active_cell_iterator&)>& look) {
  for (const auto& cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      look(cell);
}

ModuliField with_factor(const ModulusFactor& factor, double feature = 0.0) {
  ModuliField moduli(soft);
  moduli.set_factor(factor, feature);
  return moduli;
}

TEST(MaterialMarks, LeaveAUniformBlockAlone) {
  const auto mesh = refined(problem_with(ModuliField(soft)));

  EXPECT_EQ(mesh->n_global_active_cells(), 64U);
}

// No cell has parts on both sides of an interface, and away from it the
// coarsest cells remain.
TEST(MaterialMarks, EndAtThePlanesOfLayers) {
  ModuliField moduli(soft);
  moduli.add_layer(0.05 * length, hard);
  BlockProblem problem = problem_with(moduli);
  problem.mesh = meshes::layered_mesh(
      {4, 4, length, length},
      meshes::halvable_layers(0.25 * length, halvings,
                              problem.moduli.interfaces(), length));

  const auto mesh = refined(problem);

  bool has_coarsest = false;
  for_each_cell(*mesh, [&](const auto& cell) {
    const auto box = cell->bounding_box();
    EXPECT_FALSE(box.lower_bound(2) < 0.0499 * length &&
                 box.upper_bound(2) > 0.0501 * length);
    EXPECT_LE(cell->level(), 2);
    has_coarsest = has_coarsest || cell->level() == 0;
  });
  EXPECT_TRUE(has_coarsest);
}

/// Whether corners of the cell lie inside and others outside of the ball.
bool has_both_sides(const Mesh::active_cell_iterator& cell,
                    const dealii::Point<3>& centre, double radius) {
  unsigned int inside = 0;
  for (const unsigned int v : cell->vertex_indices())
    inside += cell->vertex(v).distance(centre) < radius ? 1 : 0;
  return inside > 0 && inside < 8;
}

// Cells with corners on both sides of the ball's surface have an edge of at
// most a quarter of their depth and of the radius, or the requested level.
TEST(MaterialMarks, FollowTheSurfaceOfAnInclusion) {
  const dealii::Point<3> centre(0.5 * length, 0.5 * length, 0.3 * length);
  constexpr double radius = 0.15 * length;
  ModuliField moduli(soft);
  moduli.set_sphere({centre[0], centre[1], centre[2]}, radius, hard);
  BlockProblem problem = problem_with(moduli);

  for_each_cell(*refined(problem), [&](const auto& cell) {
    if (!has_both_sides(cell, centre, radius))
      return;
    const auto box = cell->bounding_box();
    EXPECT_LE(box.side_length(2), 0.25 * radius * (1.0 + 1e-9));
    EXPECT_LE(box.side_length(2), 0.25 * box.lower_bound(2) * (1.0 + 1e-9));
  });
  problem.adaptive->interface_halvings = 2;
  for_each_cell(*refined(problem), [&](const auto& cell) {
    if (has_both_sides(cell, centre, radius)) {
      EXPECT_EQ(cell->level(), 2);
    }
  });
}

// With a modulus that grows e-fold over half a side along x, cells of an edge
// H hold a ratio of exp(2 H / side), which is below 1.2 for H < 0.091 side: two
// halvings of the coarsest edge 0.25, at all depths where the edge exceeds a
// quarter of the depth.
TEST(MaterialMarks, HalveCellsUntilTheModuliInThemAreSimilar) {
  BlockProblem problem =
      problem_with(with_factor([](const meshes::Place& place) {
        return std::exp(2.0 * place[0] / length);
      }));
  problem.adaptive->moduli_ratio = 1.2;

  for_each_cell(*refined(problem), [&](const auto& cell) {
    const double edge = cell->bounding_box().side_length(0);
    const double depth = cell->bounding_box().lower_bound(2);
    EXPECT_LE(cell->level(), 2);
    if (edge > 0.25 * depth) {
      EXPECT_EQ(cell->level(), 2) << depth;
    }
  });
}

// A single box of a table is seen by a cell eight times as wide.
TEST(MaterialMarks, SeeEveryBoxOfATable) {
  FactorTable table{
      {32, 32, 32}, std::vector<double>(32768, 1.0), {length, length, length}};
  table.factors[3 * 32 + 3] = 4.0; // in the first layer
  const double box = length / 32.0;
  const BlockProblem problem =
      problem_with(with_factor(table_factor(table), box));

  const auto mesh = refined(problem);

  for_each_cell(*mesh, [&](const auto& cell) {
    const auto bounds = cell->bounding_box();
    if (bounds.point_inside({3.5 * box, 3.5 * box, 0.5 * box})) {
      EXPECT_LE(bounds.side_length(0), box * (1.0 + 1e-9));
    }
  });
}

// Without any contact and stress all cells may merge, but not those whose
// parent is too coarse for the ball.
TEST(MaterialMarks, KeepCellsFromMerging) {
  ModuliField moduli(soft);
  moduli.set_sphere({0.5 * length, 0.5 * length, 0.3 * length}, 0.15 * length,
                    hard);
  const BlockProblem problem = problem_with(moduli);
  const auto mesh = refined(problem);
  for (const auto& cell : mesh->active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[2] > 0.75 * length)
      cell->set_refine_flag();
  mesh->execute_coarsening_and_refinement();
  const MeshedBlock block(problem, mesh);
  const std::vector<double> none(problem.grid.size(), 0.0);
  const std::vector<double> open(problem.grid.size(), length);
  const MaterialMarks marks(problem);

  const std::vector<CellChange> changes =
      RefinementRule(problem, block, {none, open}, 0.0).changes(true);

  unsigned int merging = 0;
  for (const auto& cell : mesh->active_cell_iterators())
    if (changes[cell->active_cell_index()] == CellChange::coarsen) {
      EXPECT_FALSE(marks.is_too_coarse(cell->parent()));
      ++merging;
    }
  merging = dealii::Utilities::MPI::sum(merging, MPI_COMM_WORLD);
  EXPECT_GE(merging, 128U); // the sixteen cells that were halved here
  EXPECT_GT(mesh->n_global_active_cells(), 300U);
}

TEST(MaterialMarks, RefuseSettingsOutOfRange) {
  const auto refusal = [](double ratio, int at_interfaces) {
    BlockProblem problem = problem_with(ModuliField(soft));
    problem.adaptive->moduli_ratio = ratio;
    problem.adaptive->interface_halvings = at_interfaces;
    return tests::message_of<std::domain_error>(
        [&] { const MaterialMarks marks(problem); });
  };

  EXPECT_EQ(refusal(1.5, 4), "accepted");
  EXPECT_NE(refusal(0.9, 4).find("moduli_ratio"), std::string::npos);
  EXPECT_NE(refusal(1.5, 5).find("interface_halvings"), std::string::npos);
}

} // namespace asperity::fem::material_marks_test
