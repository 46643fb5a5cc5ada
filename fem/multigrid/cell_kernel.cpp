#include "fem/multigrid/cell_kernel.hpp"

#include "base/simd_pack.hpp"
#include "fem/multigrid/box_stiffness.hpp"

#include <array>
#include <utility>

// The values of a cell of degree 1 stay in registers, so its loops are
// unrolled.
#define ASPERITY_UNROLL _Pragma("GCC unroll 12")

namespace asperity::fem {
namespace {

/// The values after one cell: {last of `before`, all but the last of `here`}.
template <class Pack, std::size_t... lane>
[[gnu::always_inline]] inline void shift_up(const Pack& before,
                                            const Pack& here, Pack& shifted,
                                            std::index_sequence<lane...>) {
  shifted =
      __builtin_shufflevector(before, here, (sizeof...(lane) - 1 + lane)...);
}

template <int degree, class Number, bool has_shear, std::size_t bytes>
struct Cells {
  /// The numbers of neighbouring cells along x.
  using Pack = typename SimdPack<Number, bytes>::Type;
  using Unaligned = typename SimdPack<Number, bytes>::Unaligned;
  static constexpr std::size_t nodes = degree + 1;
  static constexpr std::size_t lines = 3 * nodes * nodes; ///< along x
  static constexpr std::size_t size = lines * nodes;
  static constexpr std::size_t lanes = SimdPack<Number, bytes>::lanes;
  static constexpr ParitySlots<degree> slots{};

  [[gnu::always_inline]] static std::size_t
  line_start(const RowProduct<Number>& row, std::size_t line) {
    const std::size_t component = line / (nodes * nodes);
    return line / nodes % nodes * row.row_size + line % nodes * row.slice_size +
           component * degree * row.stride;
  }

  [[gnu::always_inline]] static void read(const RowProduct<Number>& row,
                                          const Number* from, Pack* v) {
    for (std::size_t line = 0; line < lines; ++line) {
      const Number* const first = from + line_start(row, line);
      v[line * nodes] = *reinterpret_cast<const Unaligned*>(first);
      if constexpr (degree == 2)
        v[line * nodes + 1] =
            *reinterpret_cast<const Unaligned*>(first + row.stride);
      v[line * nodes + degree] = *reinterpret_cast<const Unaligned*>(first + 1);
    }
  }

  /// T along one axis, or its transpose, which has the opposite sign of the
  /// difference.
  template <std::size_t step, bool is_transposed>
  [[gnu::always_inline]] static void reflect(Pack* v) {
    for (std::size_t i = 0; i < size / nodes; ++i) {
      Pack& first = v[i / step * step * nodes + i % step];
      Pack& last = (&first)[degree * step];
      const Pack before = first;
      first = is_transposed ? before - last : before + last;
      last = is_transposed ? before + last : last - before;
    }
  }

  template <std::size_t block>
  [[gnu::always_inline]] static void
  multiply_block(const Number* blocks, const Pack& factor, const Pack& shear,
                 Pack* v) {
    constexpr std::size_t rows = static_cast<std::size_t>(slots.count[block]);
    const Number* const own = blocks + slots.start[block];
    Pack in[rows];
    ASPERITY_UNROLL
    for (std::size_t s = 0; s < rows; ++s)
      in[s] = v[slots.row[block][s]];
    for (std::size_t r = 0; r < rows; ++r) {
      Pack sum = own[r * rows] * in[0];
      ASPERITY_UNROLL
      for (std::size_t s = 1; s < rows; ++s)
        sum += own[r * rows + s] * in[s];
      sum *= factor;
      if constexpr (has_shear) {
        Pack other = own[slots.entries + r * rows] * in[0];
        ASPERITY_UNROLL
        for (std::size_t s = 1; s < rows; ++s)
          other += own[slots.entries + r * rows + s] * in[s];
        sum += other * shear;
      }
      v[slots.row[block][r]] = sum;
    }
  }

  [[gnu::always_inline]] static void multiply(const Number* blocks,
                                              const Pack& factor,
                                              const Pack& shear, Pack* v) {
    reflect<1, false>(v);
    reflect<nodes, false>(v);
    reflect<nodes * nodes, false>(v);
    multiply_block<0>(blocks, factor, shear, v);
    multiply_block<1>(blocks, factor, shear, v);
    multiply_block<2>(blocks, factor, shear, v);
    multiply_block<3>(blocks, factor, shear, v);
    multiply_block<4>(blocks, factor, shear, v);
    multiply_block<5>(blocks, factor, shear, v);
    multiply_block<6>(blocks, factor, shear, v);
    multiply_block<7>(blocks, factor, shear, v);
    reflect<nodes * nodes, true>(v);
    reflect<nodes, true>(v);
    reflect<1, true>(v);
  }

  /// Adds the sums of each cell. A vertex between two cells is written once:
  /// what the cell before it adds is passed on in `passed`.
  [[gnu::always_inline]] static void write(const RowProduct<Number>& row,
                                           const Pack* v, Pack* passed,
                                           Number* to) {
    for (std::size_t line = 0; line < lines; ++line) {
      Number* const first = to + line_start(row, line);
      Pack from_before;
      shift_up(passed[line], v[line * nodes + degree], from_before,
               std::make_index_sequence<lanes>());
      passed[line] = v[line * nodes + degree];
      *reinterpret_cast<Unaligned*>(first) += v[line * nodes] + from_before;
      if constexpr (degree == 2)
        *reinterpret_cast<Unaligned*>(first + row.stride) +=
            v[line * nodes + 1];
    }
  }

  [[gnu::always_inline]] static void all(const RowProduct<Number>& row) {
    Pack passed[lines] = {};
    for (std::size_t x = 0; x < row.cells; x += lanes) {
      Pack v[size];
      read(row, row.from + x, v);
      const Pack factor =
          row.scale * *reinterpret_cast<const Unaligned*>(row.factor + x);
      Pack shear = factor;
      if constexpr (has_shear)
        shear = row.scale * *reinterpret_cast<const Unaligned*>(row.shear + x);
      multiply(row.blocks, factor, shear, v);
      write(row, v, passed, row.to + x);
    }
    if (row.cells % lanes != 0)
      return;
    for (std::size_t line = 0; line < lines; ++line)
      row.to[row.cells + line_start(row, line)] += passed[line][lanes - 1];
  }
};

template <int degree, bool has_shear, class Number>
void multiply_here(const RowProduct<Number>& row) {
  on_this_processor_with_fma([&](auto bytes) __attribute__((always_inline)) {
    Cells<degree, Number, has_shear, bytes()>::all(row);
  });
}

template <int degree, class Number>
void multiply_row_of(const RowProduct<Number>& row) {
  if (row.shear == nullptr)
    multiply_here<degree, false>(row);
  else
    multiply_here<degree, true>(row);
}

} // namespace

void multiply_row(int degree, const RowProduct<float>& row) {
  degree == 1 ? multiply_row_of<1>(row) : multiply_row_of<2>(row);
}

void multiply_row(int degree, const RowProduct<double>& row) {
  degree == 1 ? multiply_row_of<1>(row) : multiply_row_of<2>(row);
}

} // namespace asperity::fem

#undef ASPERITY_UNROLL
