#include "fem/waves/lattice_factors.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/layer_elimination.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

template <std::size_t degree>
class Factors final : public LatticeFactors {
public:
  Factors(const NodeClassSpectra& spectra, const LayeredBlock& block,
          Range rows, int threads);

  std::size_t bytes() const override {
    return packs_.size() * sizeof(SimdBatch);
  }

  void go_down(const WaveBatch& batch, SimdBatch* values) const override;
  void solve_face(const WaveBatch& batch, SimdBatch* values) const override;
  void go_up(const WaveBatch& batch, SimdBatch* values) const override;

  void face_compliance(const WaveBatch& batch,
                       SimdBatch* block) const override {
    Elimination::face_compliance(of_batch(batch) + n_layers_ * layer_packs,
                                 block);
  }

private:
  using Elimination = LayerElimination<degree>;
  static constexpr std::size_t plane = Elimination::plane;
  static constexpr std::size_t group = Elimination::group;
  static constexpr std::size_t layer_packs =
      Elimination::packs - Elimination::first_gg;

  void factorise_batch(const BlockSymbol& layers,
                       mechanics::FarBoundary far_boundary, double spring,
                       const WaveBatch& batch);

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
Factors<degree>::Factors(const NodeClassSpectra& spectra,
                         const LayeredBlock& block, Range rows, int threads)
    : rows_(rows),
      batches_(spectra.batches()),
      n_layers_(block.layers.size()),
      packs_(rows.size() * batches_ *
             (n_layers_ * layer_packs + triangle(plane))) {
  const Grid& grid = spectra.grid();
  const BlockSymbol layers(grid, static_cast<int>(degree), block,
                           Elimination::packs, Elimination::layout);
  const double spring = block.layers.back().shear_modulus * grid.spacing_x();
  parallel_rows(static_cast<int>(rows.size()), threads, [&](int turn) {
    const std::size_t row = rows.begin + static_cast<std::size_t>(turn);
    for (std::size_t number = 0; number < batches_; ++number)
      factorise_batch(layers, block.far_boundary, spring,
                      spectra.batch(row, number));
  });
}

/// Applies (L.1) from the far boundary down to T_0.
template <std::size_t degree>
void Factors<degree>::factorise_batch(const BlockSymbol& layers,
                                      mechanics::FarBoundary far_boundary,
                                      double spring, const WaveBatch& batch) {
  const std::vector<SimdBatch> materials =
      layers.at(batch.theta_x, batch.theta_y);
  SimdBatch* const first = const_cast<SimdBatch*>(of_batch(batch));
  std::array<SimdBatch, Elimination::packs> symbol;
  std::array<SimdBatch, triangle(plane)> stiffness{};
  SimdBatch uniform_mode{};
  if (batch.row == 0 && batch.first == 0)
    uniform_mode[0] = spring;
  for (std::size_t l = n_layers_; l-- > 0;) {
    layers.evaluate(l, materials.data(), symbol.data());
    Elimination::take_layer(symbol.data(),
                            layers.is_last(l) ? &far_boundary : nullptr,
                            uniform_mode, stiffness.data());
    std::copy_n(&symbol[Elimination::first_gg], layer_packs,
                first + l * layer_packs);
  }
  factorise<plane>(stiffness.data());
  std::copy_n(stiffness.data(), triangle(plane),
              first + n_layers_ * layer_packs);
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

} // namespace

std::unique_ptr<const LatticeFactors>
make_lattice_factors(const NodeClassSpectra& spectra, int degree,
                     const LayeredBlock& block, Range rows, int threads) {
  if (degree == 1)
    return std::make_unique<Factors<1>>(spectra, block, rows, threads);
  return std::make_unique<Factors<2>>(spectra, block, rows, threads);
}

} // namespace asperity::fem
