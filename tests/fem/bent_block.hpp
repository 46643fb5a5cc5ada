#pragma once

// A block of two materials under a prescribed displacement, whose stress is
// known everywhere: on boxes, with hanging nodes.

#include "fem/solution/block_stress.hpp"
#include "meshes/layered_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace asperity::fem {

/// Over the owned unknowns of that space: u_z at each place [m].
inline dealii::TrilinosWrappers::MPI::Vector vertical_displacement(
    const BlockSpace& space,
    const std::function<double(const dealii::Point<3>&)>& of) {
  auto displacement = space.make_vector();
  const auto& support = space.element().get_unit_support_points();
  std::vector<dealii::types::global_dof_index> unknowns(support.size());
  for (const auto& cell : space.dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(unknowns);
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      if (space.element().system_to_component_index(i).first == 2 &&
          space.owned().is_element(unknowns[i]))
        displacement(unknowns[i]) =
            of(space.mapping().transform_unit_to_real_cell(cell, support[i]));
  }
  displacement.compress(dealii::VectorOperation::insert);
  return displacement;
}

struct Bent {
  const char* name;
  bool hangs;
};

/// u_z = strain_ z (L - z) / L, which quadratic functions represent exactly;
/// the sides are free, so that only hanging nodes are constrained.
class BentBlock : public ::testing::TestWithParam<Bent> {
protected:
  static constexpr double depth_ = 1e-6; // m
  static constexpr double strain_ = 1e-3;
  static constexpr double interface_ =
      0.75 * depth_; ///< not deformed: only the middle plane
  const Grid grid_{8, 8, depth_, depth_};
  const Moduli near_ = moduli({2.0 * soft_modulus, 0.3}); ///< to interface_
  const Moduli far_ = moduli({soft_modulus, 0.2});

  BlockProblem problem() const {
    BlockProblem problem{
        .grid = grid_,
        .mesh = meshes::layered_mesh({4, 4, depth_, depth_},
                                     std::vector<double>(4, depth_ / 4.0)),
        .degree = 2,
        .moduli = ModuliField(far_),
        .far_boundary = mechanics::FarBoundary::sliding,
        .sides = mechanics::BlockSides::free,
        .linear_solver = LinearSolver::direct};
    problem.moduli.add_layer(interface_, near_);
    if (GetParam().hangs)
      problem.mesh.refine_below = {depth_ / 4.0};
    return problem;
  }

  static double strain_at(double z) {
    return strain_ * (1.0 - 2.0 * z / depth_);
  }

  static dealii::TrilinosWrappers::MPI::Vector
  displacement_of(const BlockSpace& space) {
    return vertical_displacement(space, [](const dealii::Point<3>& place) {
      return strain_ * place[2] * (depth_ - place[2]) / depth_;
    });
  }
};

inline auto all_bent_blocks() {
  return ::testing::Values(Bent{"boxes", false}, Bent{"hanging", true});
}

inline std::string name_of_bent(const ::testing::TestParamInfo<Bent>& tested) {
  return tested.param.name;
}

} // namespace asperity::fem
