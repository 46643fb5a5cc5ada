#pragma once

// The stiffness of a mesh of second-order hexahedra of any shape without a
// matrix, under linear constraints. This file does not depend on deal.II.

#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/hexahedra/hexahedron_kernel.hpp"
#include "fem/hexahedra/unknown_constraints.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ranks/ghost_values.hpp"

namespace asperity::fem {

/// Second-order hexahedra, those of this rank if several share the block; the
/// three unknowns of a node are consecutive.
struct HexahedronMesh {
  /// The first unknown of each of the nodes of a cell, x fastest.
  std::vector<std::array<std::uint32_t, nodes_in_hexahedron>> nodes;
  /// The vertices of each cell [m], x fastest.
  std::vector<std::array<std::array<double, 3>, 8>> vertices;
  std::vector<CellModuli> moduli; ///< of each cell
  std::size_t unknowns = 0;       ///< including copies of those of other ranks
  SharedConstraints constraints;
  /// The nodes of other ranks; null for a block on one process. It must outlive
  /// what is made from the mesh.
  const GhostValues* ghosts = nullptr;

  RankGroup* ranks() const {
    return ghosts == nullptr ? nullptr : &ghosts->ranks();
  }
};

/// The mesh in units of its shortest edge along an axis and its largest shear
/// modulus on any rank, so that its stiffness can be stored in single
/// precision.
/// @param unit  unit of the stiffness of the result [N/m]
HexahedronMesh normalised(const HexahedronMesh& mesh, double& unit);

/// K on vectors of all unknowns, with isotropic linear elasticity and trilinear
/// geometry. Forces and diagonals are zero at the unknowns of other ranks.
template <class Number>
class HexahedronOperator {
public:
  using Mesh = HexahedronMesh;

  explicit HexahedronOperator(const HexahedronMesh& mesh);

  std::size_t size() const { return size_; }

  /// Computes force = K displacement; zero at constrained unknowns.
  /// @param displacement  [m]; constrained values and those of other ranks are
  ///                      overwritten
  void apply(Number* displacement, Number* force) const {
    apply_own(displacement, force);
    collect(force);
  }

  /// The share of the cells of this rank, before collect().
  void apply_own(Number* displacement, Number* force) const {
    std::fill_n(force, size(), Number(0));
    add_own(displacement, force, Number(1));
  }

  /// Adds `factor` times this share to a force, which must be zero at
  /// constrained unknowns and those of other ranks.
  void add_own(Number* displacement, Number* force, Number factor) const;

  /// Moves forces on unknowns of other ranks to these.
  template <class Other>
  void collect(Other* force) const {
    if (ghosts_ != nullptr)
      ghosts_->add_to_owners(force);
  }

  /// Gives some cells tangents in place of their moduli; all others have their
  /// moduli again.
  /// @param cells  each cell once
  void set_tangents(std::span<const CellTangents> cells);

  /// Diagonal of K without the terms that couple two masters of one unknown;
  /// positive, and zero at constrained unknowns. It is that of the moduli also
  /// where cells have tangents.
  /// @param mesh  of this operator
  std::vector<Number> diagonal(const HexahedronMesh& mesh) const;

  std::size_t bytes() const;

private:
  std::size_t groups() const {
    return shapes_.size() / (cells_in_group * numbers_in_shape);
  }

  void take_shape(const HexahedronMesh& mesh, std::size_t cell);

  std::size_t size_;
  const GhostValues* ghosts_;
  SharedConstraints constraints_;
  std::vector<std::uint32_t> nodes_;
  std::vector<Number> shapes_;
  std::vector<Number> tangents_;
  std::vector<std::uint32_t> tangent_places_; ///< as HexahedronProduct has them
};

extern template class HexahedronOperator<float>;
extern template class HexahedronOperator<double>;

} // namespace asperity::fem
