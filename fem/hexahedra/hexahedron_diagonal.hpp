#pragma once

// The shape of a second-order hexahedron with trilinear geometry, and the
// diagonal of its matrix. This file does not depend on deal.II.

#include "fem/hexahedra/hexahedron_kernel.hpp"
#include "fem/multigrid/box_lattice.hpp"

#include <array>
#include <cstddef>

namespace asperity::fem {

/// The coefficients c0 .. c6 of (F.5) in hexahedron_kernel.hpp [m].
using HexahedronShape = std::array<std::array<double, 3>, 7>;

/// @param vertices  places of the vertices, x fastest [m]
HexahedronShape
hexahedron_shape(const std::array<std::array<double, 3>, 8>& vertices);

/// The diagonal of the matrix of one cell, by node and component, from 3^3
/// Gauss points.
class CellDiagonal {
public:
  CellDiagonal();

  /// The diagonal [N/m]; it remains valid until the next call. Equal cells that
  /// follow each other are computed once.
  const std::array<double, 3 * nodes_in_hexahedron>&
  of(const HexahedronShape& shape, const CellModuli& moduli);

private:
  /// Values and derivatives of the shape functions of a line at a Gauss point.
  struct LineFunctions {
    std::array<double, 3> value{}, slope{};

    explicit LineFunctions(double at)
        : value{0.5 * at * (at - 1.0), 1.0 - at * at, 0.5 * at * (at + 1.0)},
          slope{at - 0.5, -2.0 * at, at + 0.5} {}
  };

  bool is_last(const HexahedronShape& shape, const CellModuli& moduli) const;
  void add_point(const HexahedronShape& c, const CellModuli& moduli,
                 const std::array<std::size_t, 3>& point);

  std::array<double, 3> places_{};
  std::array<LineFunctions, 3> lines_{LineFunctions(0.0), LineFunctions(0.0),
                                      LineFunctions(0.0)};
  HexahedronShape shape_{}; ///< of the last cell
  CellModuli moduli_{};     ///< of the last cell
  std::array<double, 3 * nodes_in_hexahedron> diagonal_{};
};

} // namespace asperity::fem
