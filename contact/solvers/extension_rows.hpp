#pragma once

// The loops over one row of BoundaryExtension. They are compiled for the
// instructions of several processors and round in the same way on all of them.
// Rows that a loop reads and writes do not overlap, unless one pointer stands
// for both.

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity::contact {

/// Weights of bilinear interpolation between the centres of cells, in one
/// direction: of the cell that contains a place, and of the nearest other one.
inline constexpr float own_weight = 0.75F;
inline constexpr float other_weight = 0.25F;

/// How cells continue beyond the borders of the grid: periodically, or by their
/// mirror images.
enum class Continuation { periodic, mirrored };

/// The two rows of nodes, or of finer cells, that a row of cells consists of.
/// The second one is null where there is none.
template <class Value>
struct RowPair {
  const Value* first;
  const Value* second;
};

/// sums[p] = scale shares[p] times the sum of the values 2p and 2p + 1 of both
/// rows
void sum_cells(std::size_t points, const RowPair<float>& rows, float scale,
               const float* shares, float* sums);

/// shares = 1 / (1 + variance n), precision = shares n, with n[p] = scale times
/// such a sum, where a freedom counts as 1 or 0
void share_precision(std::size_t points, const RowPair<float>& rows,
                     float scale, float variance, float* precision,
                     float* shares);
void share_precision(std::size_t points, const RowPair<std::uint8_t>& rows,
                     float scale, float variance, float* precision,
                     float* shares);

/// mixed = own_weight own + other_weight other
void mix_rows(std::size_t n, const float* own, const float* other,
              float* mixed);

/// fine[x] = interpolation along x of a row of cells.
void widen_row(const float* cells, std::size_t points,
               Continuation continuation, float* fine);

/// cells = shares times the transpose of widen_row().
void narrow_row(const float* fine, std::size_t points,
                Continuation continuation, const float* shares, float* cells);

/// field = residual where a node is active.
void take_active(std::size_t n, const std::uint8_t* freedom,
                 const float* residual, float* field);

/// A row of a field with the freedom of its nodes.
struct MaskedRow {
  const float* field;
  const std::uint8_t* freedom;
};

/// outside = field where a node is not active, otherwise 0.
void take_inactive(std::size_t n, const MaskedRow& row, float* outside);

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

/// field[x] += share times the value of the cell above the node x, begin <= x <
/// end; `begin` is even.
void add_above(std::size_t begin, std::size_t end, float share,
               const float* above, float* field);

} // namespace asperity::contact
