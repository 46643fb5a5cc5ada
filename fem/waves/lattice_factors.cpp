#include "fem/waves/lattice_factors.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

/// Layout of S_bb and S_gg, lower triangles by columns, and S_gb by rows, one
/// after the other.
template <std::size_t degree>
LayerSymbol::Target three_blocks(std::size_t row, std::size_t column) {
  constexpr std::size_t plane = plane_unknowns(degree);
  constexpr std::size_t group = layer_unknowns(degree);
  if (row < column)
    return {};
  if (row < plane)
    return {in_triangle(plane, row, column)};
  if (column >= plane)
    return {triangle(plane) + in_triangle(group, row - plane, column - plane)};
  return {triangle(plane) + triangle(group) + (row - plane) * plane + column};
}

template <std::size_t degree>
class Factors final : public LatticeFactors {
public:
  Factors(const KindSpectra& spectra, const LayeredBlock& block, Range rows,
          int threads);

  std::size_t bytes() const override {
    return packs_.size() * sizeof(SimdBatch);
  }

  void go_down(const WaveBatch& batch, SimdBatch* values) const override;
  void solve_face(const WaveBatch& batch, SimdBatch* values) const override;
  void go_up(const WaveBatch& batch, SimdBatch* values) const override;
  void face_compliance(const WaveBatch& batch, SimdBatch* block) const override;

private:
  static constexpr std::size_t kinds = kinds_of(degree);
  static constexpr std::size_t plane = plane_unknowns(degree);
  static constexpr std::size_t group = layer_unknowns(degree);
  static constexpr std::size_t layer_packs = triangle(group) + group * plane;

  void factorise_batch(const std::vector<LayerSymbol>& layers,
                       const LayeredBlock& block, double spring,
                       const WaveBatch& batch);
  static void hold_top(mechanics::FarBoundary top, const SimdBatch& spring,
                       SimdBatch* matrix, SimdBatch* to_lower);

  /// The factors of a batch: L, 1/D and R of the layers from the contact
  /// surface upwards, then L and 1/D of T_0.
  const SimdBatch* of_batch(const WaveBatch& batch) const {
    return &packs_[((batch.row - rows_.begin) * batches_ +
                    batch.first / lanes) *
                   (n_layers_ * layer_packs + triangle(plane))];
  }

  Range rows_;
  std::size_t batches_, n_layers_;
  std::vector<SimdBatch> packs_;
};

template <std::size_t degree>
Factors<degree>::Factors(const KindSpectra& spectra, const LayeredBlock& block,
                         Range rows, int threads)
    : rows_(rows),
      batches_(spectra.batches()),
      n_layers_(block.layers.size()),
      packs_(rows.size() * batches_ *
             (n_layers_ * layer_packs + triangle(plane))) {
  const Grid& grid = spectra.grid();
  constexpr auto steps = static_cast<double>(degree);
  std::vector<LayerSymbol> layers;
  for (const ElasticLayer& layer : block.layers)
    layers.emplace_back(cell_stiffness(static_cast<int>(degree),
                                       steps * grid.spacing_x(),
                                       steps * grid.spacing_y(), layer),
                        triangle(plane) + layer_packs, three_blocks<degree>);
  const double spring = block.layers.back().shear_modulus * grid.spacing_x();
  parallel_rows(static_cast<int>(rows.size()), threads, [&](int turn) {
    const std::size_t row = rows.begin + static_cast<std::size_t>(turn);
    for (std::size_t number = 0; number < batches_; ++number)
      factorise_batch(layers, block, spring, spectra.batch(row, number));
  });
}

/// Applies (L.1) from the far boundary down to T_0.
template <std::size_t degree>
void Factors<degree>::factorise_batch(const std::vector<LayerSymbol>& layers,
                                      const LayeredBlock& block, double spring,
                                      const WaveBatch& batch) {
  const WaveProducts products(batch.theta_x, batch.theta_y);
  SimdBatch* const first = const_cast<SimdBatch*>(of_batch(batch));
  std::array<SimdBatch, triangle(plane) + layer_packs> symbol;
  std::array<SimdBatch, triangle(plane)> upper{};
  SimdBatch uniform_mode{};
  if (batch.row == 0 && batch.first == 0)
    uniform_mode[0] = spring;
  SimdBatch* const matrix = &symbol[triangle(plane)];
  SimdBatch* const to_lower = matrix + triangle(group);
  for (std::size_t l = n_layers_; l-- > 0;) {
    layers[l].evaluate(products, symbol.data());
    constexpr std::size_t top_plane = group - plane;
    for (std::size_t j = 0; j < plane; ++j)
      for (std::size_t i = j; i < plane; ++i)
        matrix[in_triangle(group, top_plane + i, top_plane + j)] +=
            upper[in_triangle(plane, i, j)];
    if (l + 1 == n_layers_)
      hold_top(block.top, uniform_mode, matrix, to_lower);
    factorise<group>(matrix);
    solve_lower<group, plane>(matrix, to_lower);
    std::copy_n(symbol.data(), triangle(plane), upper.data());
    take_schur<group, plane>(matrix, to_lower, upper.data());
    std::copy_n(matrix, layer_packs, first + l * layer_packs);
  }
  factorise<plane>(upper.data());
  std::copy_n(upper.data(), triangle(plane), first + n_layers_ * layer_packs);
}

template <std::size_t degree>
void Factors<degree>::hold_top(mechanics::FarBoundary top,
                               const SimdBatch& spring, SimdBatch* matrix,
                               SimdBatch* to_lower) {
  constexpr std::size_t top_plane = group - plane;
  for (std::size_t row = top_plane; row < group; ++row) {
    const std::size_t component = row % 3;
    if (holds(top, component)) {
      for (std::size_t j = 0; j < group; ++j)
        matrix[in_triangle(group, std::max(row, j), std::min(row, j))] =
            SimdBatch{};
      matrix[in_triangle(group, row, row)] += 1.0;
      std::fill_n(to_lower + row * plane, plane, SimdBatch{});
      continue;
    }
    for (std::size_t column = top_plane + component; column <= row; column += 3)
      matrix[in_triangle(group, row, column)] += spring;
  }
}

template <std::size_t degree>
void Factors<degree>::go_down(const WaveBatch& batch, SimdBatch* values) const {
  const SimdBatch* const factors = of_batch(batch);
  for (std::size_t l = n_layers_; l-- > 0;) {
    const SimdBatch* const factor = factors + l * layer_packs;
    const SimdBatch* const to_lower = factor + triangle(group);
    SimdBatch* const below = values + l * group * wave_columns;
    SimdBatch* const above = below + plane * wave_columns;
    solve_lower<group, wave_columns>(factor, above);
    for (std::size_t k = 0; k < group; ++k) {
      const SimdBatch& inverse = factor[in_triangle(group, k, k)];
      std::array<SimdBatch, wave_columns> scaled;
      for (std::size_t j = 0; j < wave_columns; ++j)
        scaled[j] = above[k * wave_columns + j] * inverse;
      for (std::size_t i = 0; i < plane; ++i)
        for (std::size_t j = 0; j < wave_columns; ++j)
          below[i * wave_columns + j] -= to_lower[k * plane + i] * scaled[j];
    }
  }
}

template <std::size_t degree>
void Factors<degree>::solve_face(const WaveBatch& batch,
                                 SimdBatch* values) const {
  const SimdBatch* const factor = of_batch(batch) + n_layers_ * layer_packs;
  solve_lower<plane, wave_columns>(factor, values);
  solve_diagonal<plane, wave_columns>(factor, values);
  solve_upper<plane, wave_columns>(factor, values);
}

template <std::size_t degree>
void Factors<degree>::go_up(const WaveBatch& batch, SimdBatch* values) const {
  const SimdBatch* const factors = of_batch(batch);
  for (std::size_t l = 0; l < n_layers_; ++l) {
    const SimdBatch* const factor = factors + l * layer_packs;
    const SimdBatch* const to_lower = factor + triangle(group);
    const SimdBatch* const below = values + l * group * wave_columns;
    SimdBatch* const above = values + (l * group + plane) * wave_columns;
    for (std::size_t k = 0; k < group; ++k)
      for (std::size_t i = 0; i < plane; ++i)
        for (std::size_t j = 0; j < wave_columns; ++j)
          above[k * wave_columns + j] -=
              to_lower[k * plane + i] * below[i * wave_columns + j];
    solve_diagonal<group, wave_columns>(factor, above);
    solve_upper<group, wave_columns>(factor, above);
  }
}

template <std::size_t degree>
void Factors<degree>::face_compliance(const WaveBatch& batch,
                                      SimdBatch* block) const {
  const SimdBatch* const factor = of_batch(batch) + n_layers_ * layer_packs;
  std::array<SimdBatch, plane * kinds> load{};
  for (std::size_t kind = 0; kind < kinds; ++kind)
    load[(3 * kind + 2) * kinds + kind] += 1.0;
  solve_lower<plane, kinds>(factor, load.data());
  for (std::size_t i = 0; i < kinds; ++i)
    for (std::size_t j = 0; j < kinds; ++j) {
      block[i * kinds + j] = SimdBatch{};
      for (std::size_t k = 0; k < plane; ++k)
        block[i * kinds + j] += load[k * kinds + i] * load[k * kinds + j] *
                                factor[in_triangle(plane, k, k)];
    }
}

} // namespace

std::unique_ptr<const LatticeFactors>
make_lattice_factors(const KindSpectra& spectra, int degree,
                     const LayeredBlock& block, Range rows, int threads) {
  if (degree == 1)
    return std::make_unique<Factors<1>>(spectra, block, rows, threads);
  return std::make_unique<Factors<2>>(spectra, block, rows, threads);
}

} // namespace asperity::fem
