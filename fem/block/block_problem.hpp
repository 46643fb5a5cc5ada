#pragma once

// Plain data of a full 3-D block problem: mesh, materials, boundary conditions,
// and treatment of contact and of the linear systems.

#include "base/grid.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/moduli_field.hpp"
#include "mechanics/far_boundary.hpp"
#include "mechanics/fem_settings.hpp"
#include "mechanics/material.hpp"
#include "meshes/block_mesh.hpp"

#include <memory>
#include <optional>
#include <string>

namespace asperity::fem {

/// Refinement of a mesh of boxes where the contact requires it
/// (fem/adaptive).
struct AdaptiveMesh {
  /// Number of times that a cell may be halved. The nodes of the contact
  /// surface are then those of the grid.
  int halvings = 0;
  /// Largest ratio of moduli in a cell that need not be halved [1] > 1.
  double moduli_ratio = 1.25;
  /// Number of halvings of cells that an interface between materials crosses;
  /// unset, it follows from their depth (adaptive/material_marks.hpp).
  std::optional<int> interface_halvings = {};
};

class MaterialLaw;

/// The problem that make_full_block builds. It must be equal on every rank.
struct BlockProblem {
  Grid grid;              ///< grid of the heights and of the fields in the
                          ///< solution
  meshes::BlockMesh mesh; ///< its contact surface covers the rectangle of the
                          ///< grid
  int degree = 1;         ///< polynomial degree of the shape functions, 1 or 2
  ModuliField moduli;
  mechanics::FarBoundary far_boundary = mechanics::FarBoundary::clamped;
  /// Free sides with a pressure-loaded far boundary are refused, because such a
  /// block may tilt.
  mechanics::BlockSides sides = mechanics::BlockSides::periodic;
  LinearSolver linear_solver = LinearSolver::automatic;

  /// The second body, if it is meshed as well, below the contact surface and
  /// supported at its own far boundary as the first body is.
  std::optional<mechanics::BodyModuli> counter = {};

  /// The mesh of the second body, which lies at z <= 0, has free sides and is
  /// held at its group far_boundary, z = -depth (counter_body.hpp). Empty: the
  /// second body is the mirror image of the first.
  std::optional<meshes::BlockMesh> counter_mesh = {};

  /// Set for make_adaptive_block, for which `mesh` is the coarsest mesh.
  std::optional<AdaptiveMesh> adaptive = {};

  /// Needs one body of second-order hexahedra that do not follow the contact;
  /// null: Hooke's law.
  std::shared_ptr<const MaterialLaw> law = {};

  std::string quality = {}; ///< lines on the mesh quality, for report()
};

/// Builds the mesh, numbers the unknowns and assembles the matrices. This call
/// is collective.
/// @throws std::domain_error  a parameter is outside its range, the periodic
///                            sides do not match, or the combination is refused
std::unique_ptr<FullBlock> make_full_block(const BlockProblem& problem);

} // namespace asperity::fem
