#pragma once

// The product of the stiffness of second-order hexahedra of any shape with a
// vector, many cells at a time and without their matrices.

#include <cstddef>
#include <cstdint>

namespace asperity::fem {

/// The number of cells whose shapes are stored together: the largest number
/// that is treated at a time.
inline constexpr std::size_t cells_in_group = 16;

/// Numbers of a cell: the derivatives of its places by the reference
/// coordinates xi, eta, zeta in -1..1,
///
///     dx/dxi   = c0 + c3 eta  + c5 zeta + c6 eta zeta
///     dx/deta  = c1 + c3 xi   + c4 zeta + c6 xi zeta                   (F.5)
///     dx/dzeta = c2 + c5 xi   + c4 eta  + c6 xi eta
///
/// three numbers each, and then lambda and mu.
inline constexpr std::size_t numbers_in_shape = 23;

inline constexpr std::size_t nodes_in_hexahedron = 27;

inline constexpr std::size_t points_in_hexahedron = 27; ///< of Gauss

/// Numbers of a tangent (F.6): lambda, mu and the six components of s.
inline constexpr std::size_t numbers_in_tangent = 8;

inline constexpr std::uint32_t no_tangents = UINT32_MAX;

/// Groups of cells and the vectors that they act on. A node has three
/// consecutive unknowns.
template <class Number>
struct HexahedronProduct {
  const Number* from = nullptr;
  Number* to = nullptr; ///< sums are added here
  std::size_t groups = 0;
  /// The first unknown of each node of each cell, x fastest.
  const std::uint32_t* nodes = nullptr;
  /// For each group numbers_in_shape times cells_in_group numbers.
  const Number* shapes = nullptr;
  /// The place of each group in `tangents`, or no_tangents for one whose cells
  /// have the moduli of their shapes; null if all are of that kind.
  const std::uint32_t* tangent_places = nullptr;
  /// For each place and Gauss point, x fastest, numbers_in_tangent times
  /// cells_in_group numbers.
  const Number* tangents = nullptr;
  Number factor = Number(1);
};

/// Adds `factor` K `from` to `to` with 3^3 Gauss points for each cell. The
/// fastest instructions of this processor are used; the result depends on them
/// only by rounding.
void multiply_hexahedra(const HexahedronProduct<float>& product);
void multiply_hexahedra(const HexahedronProduct<double>& product);

} // namespace asperity::fem
