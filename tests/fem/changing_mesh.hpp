#pragma once

// Blocks of 4^3 coarsest cells whose meshes tests of adaptive meshes change.

#include "fem/adaptive/mesh_change.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/bent_block.hpp"

#include <functional>
#include <memory>

namespace asperity::fem {

constexpr double side = 1e-6; // m

using Mesh = MeshChange::Mesh;
using Field = std::function<double(const dealii::Point<3>&)>;

inline BlockProblem problem_of(int degree, mechanics::BlockSides sides) {
  return {.grid = {16 * degree, 16 * degree, side, side},
          .mesh = meshes::equal_boxes({4, 4, side, side}, side),
          .degree = degree,
          .moduli = ModuliField(moduli({soft_modulus, 0.3})),
          .sides = sides};
}

inline std::shared_ptr<Mesh> mesh_of(const BlockProblem& problem) {
  start_mpi();
  std::shared_ptr<dealii::parallel::TriangulationBase<3>> mesh =
      make_triangulation(problem.mesh, false);
  return std::dynamic_pointer_cast<Mesh>(mesh);
}

} // namespace asperity::fem
