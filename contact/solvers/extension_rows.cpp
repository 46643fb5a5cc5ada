#include "contact/solvers/extension_rows.hpp"

#include "base/simd_pack.hpp"

#include <bit>

namespace asperity::contact {
namespace {

/// Calls do_node(i) for i in 0..n-1, compiled for this processor.
template <class DoNode>
void each_node(std::size_t n, const DoNode& do_node) {
  on_this_processor([&, n ](auto) __attribute__((always_inline)) {
    for (std::size_t i = 0; i < n; ++i)
      do_node(i);
  });
}

/// Calls finish(p, sum) for the sum of counted(value) over each cell of 2 by 2
/// nodes.
template <class Value, class Counted, class Finish>
void each_cell(std::size_t points, const RowPair<Value>& rows,
               const Counted& counted, const Finish& finish) {
  const Value *const a = rows.first, *const b = rows.second;
  const std::size_t pairs = points / 2;
  if (b != nullptr)
    each_node(
        pairs, [=](std::size_t p) __attribute__((always_inline)) {
          finish(p, (counted(a[2 * p]) + counted(a[2 * p + 1])) +
                        (counted(b[2 * p]) + counted(b[2 * p + 1])));
        });
  else
    each_node(
        pairs, [=](std::size_t p) __attribute__((always_inline)) {
          finish(p, counted(a[2 * p]) + counted(a[2 * p + 1]));
        });
  if (points % 2 != 0)
    finish(pairs, b != nullptr ? counted(a[points - 1]) + counted(b[points - 1])
                               : counted(a[points - 1]));
}

// A choice between two numbers is one between their bits, because the compiler
// makes no vectors of branches.

[[gnu::always_inline]] inline float chosen(bool is_first, float first,
                                           float second) {
  const std::int32_t mask = is_first ? -1 : 0;
  return std::bit_cast<float>((std::bit_cast<std::int32_t>(first) & mask) |
                              (std::bit_cast<std::int32_t>(second) & ~mask));
}

} // namespace

void sum_cells(std::size_t points, const RowPair<float>& rows, float scale,
               const float* shares, float* sums) {
  each_cell(
      points, rows,
      [](float value) __attribute__((always_inline)) { return value; },
      [=](std::size_t p, float sum) __attribute__((always_inline)) {
        sums[p] = scale * shares[p] * sum;
      });
}

void share_precision(std::size_t points, const RowPair<float>& rows,
                     float scale, float variance, float* precision,
                     float* shares) {
  each_cell(
      points, rows,
      [](float value) __attribute__((always_inline)) { return value; },
      [=](std::size_t p, float sum) __attribute__((always_inline)) {
        const float own = scale * sum;
        shares[p] = 1.0F / (1.0F + variance * own);
        precision[p] = shares[p] * own;
      });
}

void share_precision(std::size_t points, const RowPair<std::uint8_t>& rows,
                     float scale, float variance, float* precision,
                     float* shares) {
  each_cell(
      points, rows, [](std::uint8_t freedom) __attribute__((always_inline)) {
        return std::int32_t{freedom > 0};
      },
      [=](std::size_t p, std::int32_t count) __attribute__((always_inline)) {
        const float own = scale * static_cast<float>(count);
        shares[p] = 1.0F / (1.0F + variance * own);
        precision[p] = shares[p] * own;
      });
}

void mix_rows(std::size_t n, const float* own, const float* other,
              float* mixed) {
  each_node(
      n, [=](std::size_t i) __attribute__((always_inline)) {
        mixed[i] = own_weight * own[i] + other_weight * other[i];
      });
}

void widen_row(const float* cells, std::size_t points,
               Continuation continuation, float* fine) {
  const std::size_t n = (points + 1) / 2;
  const bool is_mirrored = continuation == Continuation::mirrored;
  const auto put = [=](std::size_t p, float before, float after) {
    const float own = own_weight * cells[p];
    fine[2 * p] = own + other_weight * before;
    if (2 * p + 1 < points)
      fine[2 * p + 1] = own + other_weight * after;
  };
  put(0, cells[is_mirrored ? 0 : n - 1], cells[n > 1 ? 1 : 0]);
  if (n > 2)
    each_node(
        n - 2, [=](std::size_t i) __attribute__((always_inline)) {
          const float own = own_weight * cells[i + 1];
          fine[2 * i + 2] = own + other_weight * cells[i];
          fine[2 * i + 3] = own + other_weight * cells[i + 2];
        });
  if (n > 1)
    put(n - 1, cells[n - 2], cells[is_mirrored ? n - 1 : 0]);
}

void narrow_row(const float* fine, std::size_t points,
                Continuation continuation, const float* shares, float* cells) {
  const std::size_t n = (points + 1) / 2;
  const bool is_even = points % 2 == 0;
  const bool is_mirrored = continuation == Continuation::mirrored;
  // The nodes beyond the ends that have the first or the last cell beside them.
  const float before = is_mirrored ? fine[0]
                       : is_even   ? fine[points - 1]
                                   : 0.0F;
  const float after = !is_mirrored ? fine[0]
                      : is_even    ? fine[points - 1]
                                   : 0.0F;
  const auto at_end = [=](std::size_t p) {
    float own = fine[2 * p];
    if (2 * p + 1 < points)
      own += fine[2 * p + 1];
    const float other = (p + 1 < n ? fine[2 * p + 2] : after) +
                        (p > 0 ? fine[2 * p - 1] : before);
    cells[p] = shares[p] * (own_weight * own + other_weight * other);
  };
  at_end(0);
  if (n > 2)
    each_node(
        n - 2, [=](std::size_t i) __attribute__((always_inline)) {
          cells[i + 1] = shares[i + 1] *
                         (own_weight * (fine[2 * i + 2] + fine[2 * i + 3]) +
                          other_weight * (fine[2 * i + 1] + fine[2 * i + 4]));
        });
  if (n > 1)
    at_end(n - 1);
}

void take_active(std::size_t n, const std::uint8_t* freedom,
                 const float* residual, float* field) {
  each_node(
      n, [=](std::size_t i) __attribute__((always_inline)) {
        field[i] = chosen(freedom[i] > 0, residual[i], field[i]);
      });
}

void take_inactive(std::size_t n, const MaskedRow& row, float* outside) {
  const float* const field = row.field;
  const std::uint8_t* const freedom = row.freedom;
  each_node(
      n, [=](std::size_t i) __attribute__((always_inline)) {
        outside[i] = chosen(freedom[i] > 0, 0.0F, field[i]);
      });
}

void sum_rows(std::size_t n, const std::array<const float*, 4>& rows,
              const std::array<float, 4>& weights, float* sum) {
  const float *const a = rows[0], *const b = rows[1], *const c = rows[2],
                     *const d = rows[3];
  const float of_a = weights[0], of_b = weights[1], of_c = weights[2],
              of_d = weights[3];
  on_this_processor([=](auto) __attribute__((always_inline)) {
    for (std::size_t i = 0; i < n; ++i)
      sum[i] = of_a * a[i] + of_b * b[i] + of_c * c[i] + of_d * d[i];
  });
}

void add_beyond(std::size_t n, float variance, const float* shares,
                const float* beyond, float* values) {
  each_node(
      n, [=](std::size_t i) __attribute__((always_inline)) {
        values[i] = variance * values[i] + shares[i] * beyond[i];
      });
}

void pass_down(std::size_t n, float variance, const float* shares,
               const float* above, float* values) {
  if (above == nullptr) {
    each_node(
        n, [=](std::size_t i)
               __attribute__((always_inline)) { values[i] *= variance; });
    return;
  }
  const auto pass = [=](std::size_t i, float own)
      __attribute__((always_inline)) {
    values[i] = variance * values[i] + shares[i] * own;
  };
  each_node(
      n / 2, [=](std::size_t p) __attribute__((always_inline)) {
        pass(2 * p, above[p]);
        pass(2 * p + 1, above[p]);
      });
  if (n % 2 != 0)
    pass(n - 1, above[n / 2]);
}

void add_above(std::size_t begin, std::size_t end, float share,
               const float* above, float* field) {
  const std::size_t first = begin / 2;
  each_node(
      end / 2 - first, [=](std::size_t i) __attribute__((always_inline)) {
        const std::size_t p = first + i;
        const float own = share * above[p];
        field[2 * p] += own;
        field[2 * p + 1] += own;
      });
  if (end % 2 != 0)
    field[end - 1] += share * above[end / 2];
}

} // namespace asperity::contact
