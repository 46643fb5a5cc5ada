#pragma once

// This file declares the loops over one row of BoundaryExtension. They are
// compiled for the instructions of several processors and round in the same way
// on all of them. Rows that a loop reads and writes do not overlap, unless one
// pointer stands for both.

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity::contact {

/// Weights of bilinear interpolation between the centres of cells, in one
/// direction: of the cell that contains a place, and of the nearest other one.
inline constexpr float own_weight = 0.75F;
inline constexpr float other_weight = 0.25F;

/// sums[p] += the nodes 2p and 2p + 1, where a freedom counts as 1 or 0.
void add_pairs(std::size_t points, const float* nodes, float* sums);
void add_pairs(std::size_t points, const std::uint8_t* freedom, float* sums);

/// shares = 1 / (1 + variance scale precision), precision = shares scale
/// precision
void share_precision(std::size_t n, float scale, float variance,
                     float* precision, float* shares);

/// values = scale shares values
void scale_row(std::size_t n, float scale, const float* shares, float* values);

/// mixed = own_weight own + other_weight other
void mix_rows(std::size_t n, const float* own, const float* other,
              float* mixed);

/// fine[x] = interpolation along x of a periodic row of cells.
void widen_row(const float* cells, std::size_t points, float* fine);

/// The transpose of widen_row().
void narrow_row(const float* fine, std::size_t points, float* cells);

/// field = residual where a node is active.
void take_active(std::size_t n, const std::uint8_t* freedom,
                 const float* residual, float* field);

/// outside = field where a node is not active, otherwise 0.
void take_inactive(std::size_t n, const std::uint8_t* freedom,
                   const float* field, float* outside);

/// sum = the rows, each times its weight
void sum_rows(std::size_t n, const std::array<const float*, 4>& rows,
              const std::array<float, 4>& weights, float* sum);

/// values = variance values + shares beyond
void add_beyond(std::size_t n, float variance, const float* shares,
                const float* beyond, float* values);

/// values = variance values + shares times the value of the cell above, which
/// is 0 if `above` is null
void pass_down(std::size_t n, float variance, const float* shares,
               const float* above, float* values);

/// field += share times the value of the cell above each node.
void add_above(std::size_t points, float share, const float* above,
               float* field);

} // namespace asperity::contact
