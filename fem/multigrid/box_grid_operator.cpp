#include "fem/multigrid/box_grid_operator.hpp"

#include "base/simd_pack.hpp"
#include "fem/multigrid/box_stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

// The values of a cell of degree 1 stay in registers, so its loops are
// unrolled.
#define ASPERITY_UNROLL _Pragma("GCC unroll 12")

namespace asperity::fem {
namespace {

/// A row of cells along x and the nodes around them.
template <class Number>
struct RowProduct {
  const Number* from = nullptr; ///< the row's first node, with images
  Number* to = nullptr;         ///< the same node; sums are added here
  std::size_t stride = 0, row_size = 0, slice_size = 0; ///< of NodeLayout
  std::size_t cells = 0;
  /// Blocks of ParitySlots: of the layer's cells up to a factor; or, if
  /// `shear` is set, of lambda = 1 and then of mu = 1.
  const Number* blocks = nullptr;
  /// Factor of each cell, or its lambda; zeros follow up to a multiple of
  /// most_lanes.
  const Number* factor = nullptr;
  const Number* shear = nullptr; ///< mu of each cell; null if not needed
  Number scale = Number(1);      ///< of the product
};

/// The largest number of cells that are treated at a time.
constexpr std::size_t most_lanes = 16;

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

/// Adds `scale` K `from` to `to` for the cells of a row. The fastest
/// instructions of this processor are used; the result depends on them only by
/// rounding.
template <class Number>
void multiply_row(int degree, const RowProduct<Number>& row) {
  degree == 1 ? multiply_row_of<1>(row) : multiply_row_of<2>(row);
}

/// Smallest and largest lambda / mu of a layer.
struct RatioRange {
  double low = 0.0, high = 0.0;

  RatioRange(const BoxGrid& box_grid, int layer) {
    const auto ratio = [&](int x, int y) {
      const CellModuli& moduli = box_grid.moduli_of(x, y, layer);
      return moduli.lame / moduli.shear;
    };
    low = high = ratio(0, 0);
    if (box_grid.is_layered())
      return;
    for (int y = 0; y < box_grid.cells_y; ++y)
      for (int x = 0; x < box_grid.cells_x; ++x) {
        low = std::min(low, ratio(x, y));
        high = std::max(high, ratio(x, y));
      }
  }

  /// Whether one matrix serves up to a factor.
  bool is_single() const {
    constexpr double rounding = 1e-14;
    return high - low <= rounding * (1.0 + std::abs(high));
  }
};

std::vector<double> diagonal_of(const std::vector<double>& matrix) {
  std::size_t size = 0;
  while (size * size < matrix.size())
    ++size;
  std::vector<double> diagonal(size);
  for (std::size_t i = 0; i < size; ++i)
    diagonal[i] = matrix[i * (size + 1)];
  return diagonal;
}

template <class Number>
void append_as(const std::vector<double>& numbers, std::vector<Number>& to) {
  for (const double number : numbers)
    to.push_back(static_cast<Number>(number));
}

} // namespace

template <class Number>
BoxGridOperator<Number>::BoxGridOperator(const BoxGrid& box_grid,
                                         const BoxGridSlab& slab,
                                         UnknownLayout unknowns)
    : MeshOperator<Number>(std::move(unknowns)),
      degree_(box_grid.degree),
      cells_x_(static_cast<std::size_t>(box_grid.cells_x)),
      cells_y_(static_cast<std::size_t>(slab.count())),
      layout_(slab.layout(box_grid)) {
  for (int layer = 0; layer < box_grid.layers(); ++layer)
    add_layer(box_grid, slab, layer);
}

template <class Number>
void BoxGridOperator<Number>::add_layer(const BoxGrid& box_grid,
                                        const BoxGridSlab& slab, int layer) {
  const RatioRange ratio(box_grid, layer);
  const std::array<double, 3> size = box_grid.cell_size(layer);
  const auto stiffness = [&](double lame, double shear) {
    return box_stiffness(degree_, size, {lame, shear});
  };
  Layer own;
  const std::vector<double> of_low = stiffness(ratio.low, 1.0);
  bound_ = std::max(bound_, fem::jacobi_bound(degree_, of_low));
  if (ratio.is_single()) {
    append_as(parity_blocks(degree_, of_low), own.blocks);
    own.of_factor = diagonal_of(of_low);
  } else {
    bound_ = std::max(bound_,
                      fem::jacobi_bound(degree_, stiffness(ratio.high, 1.0)));
    const std::vector<double> of_lame = stiffness(1.0, 0.0);
    const std::vector<double> of_shear = stiffness(0.0, 1.0);
    append_as(parity_blocks(degree_, of_lame), own.blocks);
    append_as(parity_blocks(degree_, of_shear), own.blocks);
    own.of_factor = diagonal_of(of_lame);
    own.of_shear = diagonal_of(of_shear);
  }
  take_factors(box_grid, slab, layer, own);
  layers_.push_back(std::move(own));
}

template <class Number>
void BoxGridOperator<Number>::take_factors(const BoxGrid& box_grid,
                                           const BoxGridSlab& slab, int layer,
                                           Layer& own) const {
  const bool has_shear = !own.of_shear.empty();
  const std::size_t padded =
      (cells_x_ + most_lanes - 1) / most_lanes * most_lanes;
  const std::size_t rows = box_grid.is_layered() ? 1 : cells_y_;
  own.factor_row = box_grid.is_layered() ? 0 : padded;
  own.factor.assign(rows * padded, Number(0));
  if (has_shear)
    own.shear = own.factor;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < cells_x_; ++x) {
      const CellModuli& moduli = box_grid.moduli_of(
          static_cast<int>(x), slab.first() + static_cast<int>(y), layer);
      own.factor[y * padded + x] =
          static_cast<Number>(has_shear ? moduli.lame : moduli.shear);
      if (has_shear)
        own.shear[y * padded + x] = static_cast<Number>(moduli.shear);
    }
}

template <class Number>
void BoxGridOperator<Number>::add_cells(const Number* displacement,
                                        Number* force, Number scale) const {
  RowProduct<Number> row;
  row.stride = layout_.stride();
  row.row_size = layout_.row_size();
  row.slice_size = layout_.slice_size();
  row.cells = cells_x_;
  row.scale = scale;
  for (std::size_t y = 0; y < cells_y_; ++y)
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
      const Layer& own = layers_[layer];
      const std::size_t at = layout_.degree() * (y * layout_.slice_size() +
                                                 layer * layout_.row_size());
      row.from = displacement + at;
      row.to = force + at;
      row.blocks = own.blocks.data();
      row.factor = own.factor.data() + y * own.factor_row;
      row.shear =
          own.shear.empty() ? nullptr : own.shear.data() + y * own.factor_row;
      multiply_row(degree_, row);
    }
}

/// Adds the diagonal of the cell (x, y) of a layer, whose first plane is
/// `plane`.
template <class Number>
void BoxGridOperator<Number>::add_diagonal(const Layer& layer,
                                           std::size_t plane, int x, int y,
                                           std::vector<double>& sum) const {
  const std::size_t at = static_cast<std::size_t>(y) * layer.factor_row +
                         static_cast<std::size_t>(x);
  const auto factor = static_cast<double>(layer.factor[at]);
  const double shear =
      layer.shear.empty() ? 0.0 : static_cast<double>(layer.shear[at]);
  std::size_t row = 0;
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k <= degree_; ++k)
      for (int j = 0; j <= degree_; ++j)
        for (int i = 0; i <= degree_; ++i, ++row)
          sum[layout_.index(degree_ * x + i, degree_ * y + j,
                            static_cast<int>(plane) + k, c)] +=
              factor * layer.of_factor[row] +
              (shear != 0.0 ? shear * layer.of_shear[row] : 0.0);
}

template <class Number>
std::vector<double> BoxGridOperator<Number>::diagonal() const {
  std::vector<double> sum(layout_.size(), 0.0);
  for (std::size_t layer = 0; layer < layers_.size(); ++layer)
    for (std::size_t y = 0; y < cells_y_; ++y)
      for (std::size_t x = 0; x < cells_x_; ++x)
        add_diagonal(layers_[layer], layer * layout_.degree(),
                     static_cast<int>(x), static_cast<int>(y), sum);
  this->layout().constraints->condense_diagonal(sum);
  this->layout().collect(sum.data());
  return sum;
}

template <class Number>
std::size_t BoxGridOperator<Number>::bytes() const {
  std::size_t numbers = 0;
  for (const Layer& layer : layers_)
    numbers += layer.blocks.size() + layer.factor.size() + layer.shear.size();
  return numbers * sizeof(Number);
}

template class BoxGridOperator<float>;
template class BoxGridOperator<double>;

} // namespace asperity::fem

#undef ASPERITY_UNROLL
