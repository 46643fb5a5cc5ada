#pragma once

// The product of the stiffness of first-order boxes with a vector, many cells
// at a time and without their matrices.

#include <cstddef>
#include <cstdint>

namespace asperity::fem {

/// The number of boxes that are stored together: the largest number that is
/// treated at a time.
inline constexpr std::size_t boxes_in_group = 16;

/// Numbers of a box: its edges along x, y and z, lambda and mu.
inline constexpr std::size_t numbers_in_box = 5;

inline constexpr std::size_t nodes_in_box = 8;

/// Groups of boxes and the vectors that they act on. A node has three
/// consecutive unknowns.
template <class Number>
struct BoxProduct {
  const Number* from = nullptr;
  Number* to = nullptr; ///< sums are added here
  std::size_t groups = 0;
  /// The first unknown of each node of each cell, x fastest.
  const std::uint32_t* nodes = nullptr;
  /// For each kind of group numbers_in_box times boxes_in_group numbers.
  const Number* boxes = nullptr;
  const std::uint32_t* kinds = nullptr; ///< of each group
  Number factor = Number(1);
};

/// Adds `factor` K `from` to `to`. The displacement of a box is a sum of eight
/// products of 1 or xi, 1 or eta, and 1 or zeta with -1 <= xi, eta, zeta <= 1.
/// The three reflections of the box leave the energy as it is, so that of its
/// 24 terms only three at a time are coupled: u_x = xi, u_y = eta and u_z =
/// zeta by lambda, and others in pairs by mu. The fastest instructions of this
/// processor are used; the result depends on them only by rounding.
void multiply_boxes(const BoxProduct<float>& product);
void multiply_boxes(const BoxProduct<double>& product);

} // namespace asperity::fem
