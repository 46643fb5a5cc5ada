#pragma once

// The settings of the finite-element methods: the condensed block and the full
// 3-D block.

#include "mechanics/contact_law.hpp"
#include "mechanics/far_boundary.hpp"
#include "mechanics/mesh_spec.hpp"
#include "mechanics/quantity.hpp"

#include <optional>

namespace asperity::mechanics {

enum class Element { q1, q2 };

/// Polynomial degree of the shape functions of an element.
constexpr int degree_of(Element element) {
  return element == Element::q1 ? 1 : 2;
}

/// The discretisation of the block, which the condensed and the full method
/// share: graded layers of elements with one far boundary.
struct BlockSettings {
  Element element = Element::q2;
  double surface_cell_depth = 1.0; ///< in node spacings
  double growth = 1.2;             ///< grading ratio of successive layers
  Quantity depth{1.0, ReferenceUnit::length};
  FarBoundary far_boundary = FarBoundary::clamped;
};

/// Solver of the linear systems of the full block.
enum class LinearSolver {
  automatic, ///< direct for small and for nearly incompressible blocks, else
             ///< multigrid
  direct,    ///< MUMPS; KLU on several ranks
  multigrid, ///< CG with geometric multigrid on boxes and hexahedra of second
             ///< order, otherwise Trilinos ML smoothed aggregation
};

/// What only the full 3-D block has (solver = "full").
struct FullBlockSettings {
  BlockSides sides = BlockSides::periodic;
  LinearSolver linear_solver = LinearSolver::automatic;
  bool uses_case_mesh = false; ///< [mesh] instead of graded layers
  int bodies = 1; ///< 2 meshes the second body too; with 1 it enters through E*
  bool has_stiffness = false; ///< finds the stiffness of each contact
  std::optional<Quantity> yield_stress = {};      ///< [Pa]; unset: elastic
  std::optional<Quantity> hardening_modulus = {}; ///< [Pa]; unset: 0
};

enum class FemSolver { automatic, condensed, full };

/// [fem]: finite elements in contact with the rigid surface.
struct FemSettings {
  ContactSettings contact;
  FemSolver solver = FemSolver::automatic;
  BlockSettings block;
  FullBlockSettings full;

  static constexpr const char* kind = "fem";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return true; }

  bool uses_layers() const { return true; }

  bool is_continuum() const { return true; }

  /// Whether the block ends at free sides instead of continuing periodically.
  bool has_free_sides() const {
    return solver == FemSolver::full && full.sides == BlockSides::free;
  }
};

} // namespace asperity::mechanics
