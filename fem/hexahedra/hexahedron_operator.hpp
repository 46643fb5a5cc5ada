#pragma once

// The stiffness of a mesh of second-order hexahedra of any shape without a
// matrix. This file does not depend on deal.II.

#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/hexahedra/hexahedron_kernel.hpp"
#include "fem/multigrid/box_grid.hpp"
#include "fem/multigrid/mesh_operator.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::fem {

/// Second-order hexahedra, those of this rank if several share the block; the
/// three unknowns of a node are consecutive.
struct HexahedronMesh {
  /// The first unknown of each of the nodes of a cell, x fastest.
  std::vector<std::array<std::uint32_t, nodes_in_hexahedron>> nodes;
  /// The vertices of each cell [m], x fastest.
  std::vector<std::array<std::array<double, 3>, 8>> vertices;
  std::vector<CellModuli> moduli; ///< of each cell
  UnknownLayout unknowns;
};

/// Those of all ranks; the edges are those along an axis. Collective.
MeshUnits units_of(const HexahedronMesh& mesh);

/// The mesh in these units.
HexahedronMesh scaled(const HexahedronMesh& mesh, const MeshUnits& units);

/// Diagonal of K without the terms that couple two masters of one unknown;
/// positive, and zero at constrained unknowns. Collective.
std::vector<double> diagonal_of(const HexahedronMesh& mesh);

/// K with isotropic linear elasticity and trilinear geometry.
template <class Number>
class HexahedronOperator final : public MeshOperator<Number> {
public:
  using Mesh = HexahedronMesh;

  explicit HexahedronOperator(const HexahedronMesh& mesh);

  /// Gives some cells tangents in place of their moduli; all others have their
  /// moduli again.
  /// @param cells  each cell once
  void set_tangents(std::span<const CellTangents> cells);

  std::size_t bytes() const override;

private:
  std::size_t groups() const {
    return shapes_.size() / (cells_in_group * numbers_in_shape);
  }

  void add_cells(const Number* displacement, Number* force,
                 Number factor) const override;
  void take_shape(const HexahedronMesh& mesh, std::size_t cell);

  std::vector<std::uint32_t> nodes_;
  std::vector<Number> shapes_;
  std::vector<Number> tangents_;
  std::vector<std::uint32_t> tangent_places_; ///< as HexahedronProduct has them
};

extern template class HexahedronOperator<float>;
extern template class HexahedronOperator<double>;

} // namespace asperity::fem
