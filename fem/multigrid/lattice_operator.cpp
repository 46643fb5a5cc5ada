#include "fem/multigrid/lattice_operator.hpp"

#include "fem/multigrid/box_stiffness.hpp"
#include "fem/multigrid/cell_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

/// Smallest and largest lambda / mu of a layer.
struct RatioRange {
  double low = 0.0, high = 0.0;

  RatioRange(const BoxLattice& lattice, int layer) {
    const auto ratio = [&](int x, int y) {
      const CellModuli& moduli = lattice.moduli_of(x, y, layer);
      return moduli.lame / moduli.shear;
    };
    low = high = ratio(0, 0);
    if (lattice.is_layered())
      return;
    for (int y = 0; y < lattice.cells_y; ++y)
      for (int x = 0; x < lattice.cells_x; ++x) {
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
LatticeOperator<Number>::LatticeOperator(const BoxLattice& lattice,
                                         const LatticeSlab& slab,
                                         UnknownLayout unknowns)
    : MeshOperator<Number>(std::move(unknowns)),
      degree_(lattice.degree),
      cells_x_(static_cast<std::size_t>(lattice.cells_x)),
      cells_y_(static_cast<std::size_t>(slab.count())),
      layout_(slab.layout(lattice)) {
  for (int layer = 0; layer < lattice.layers(); ++layer)
    add_layer(lattice, slab, layer);
}

template <class Number>
void LatticeOperator<Number>::add_layer(const BoxLattice& lattice,
                                        const LatticeSlab& slab, int layer) {
  const RatioRange ratio(lattice, layer);
  const std::array<double, 3> size = lattice.cell_size(layer);
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
  take_factors(lattice, slab, layer, own);
  layers_.push_back(std::move(own));
}

template <class Number>
void LatticeOperator<Number>::take_factors(const BoxLattice& lattice,
                                           const LatticeSlab& slab, int layer,
                                           Layer& own) const {
  const bool has_shear = !own.of_shear.empty();
  const std::size_t padded =
      (cells_x_ + most_lanes - 1) / most_lanes * most_lanes;
  const std::size_t rows = lattice.is_layered() ? 1 : cells_y_;
  own.factor_row = lattice.is_layered() ? 0 : padded;
  own.factor.assign(rows * padded, Number(0));
  if (has_shear)
    own.shear = own.factor;
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < cells_x_; ++x) {
      const CellModuli& moduli = lattice.moduli_of(
          static_cast<int>(x), slab.first() + static_cast<int>(y), layer);
      own.factor[y * padded + x] =
          static_cast<Number>(has_shear ? moduli.lame : moduli.shear);
      if (has_shear)
        own.shear[y * padded + x] = static_cast<Number>(moduli.shear);
    }
}

template <class Number>
void LatticeOperator<Number>::add_cells(const Number* displacement,
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
void LatticeOperator<Number>::add_diagonal(const Layer& layer,
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
std::vector<double> LatticeOperator<Number>::diagonal() const {
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
std::size_t LatticeOperator<Number>::bytes() const {
  std::size_t numbers = 0;
  for (const Layer& layer : layers_)
    numbers += layer.blocks.size() + layer.factor.size() + layer.shear.size();
  return numbers * sizeof(Number);
}

template class LatticeOperator<float>;
template class LatticeOperator<double>;

} // namespace asperity::fem
