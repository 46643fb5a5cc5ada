#include "md/lattice/block_solver.hpp"

#include "base/grid.hpp"
#include "base/parallel_rows.hpp"
#include "base/require.hpp"
#include "md/lattice/level_transfer.hpp"
#include "md/lattice/slab_symbol.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
#include <complex>
#include <cstddef>

namespace asperity::md {

using WaveBlock = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using WaveVector = Eigen::Matrix<std::complex<double>, 3, 1>;

inline WaveBlock full(const SymmetricBlock& block) {
  WaveBlock matrix;
  matrix << block.xx, block.xy, block.xz, block.xy, block.yy, block.yz,
      block.xz, block.yz, block.zz;
  return matrix;
}

inline WaveBlock full(const std::array<double, 9>& block) {
  return Eigen::Map<const WaveBlock>(block.data());
}

/// Adds the block, or the block of the mode -q, to the sum.
inline void add(SymmetricBlock& sum, const SymmetricBlock& block,
                bool is_conjugate) {
  const double sign = is_conjugate ? -1.0 : 1.0;
  sum.xx += block.xx;
  sum.yy += block.yy;
  sum.zz += block.zz;
  sum.xy += block.xy;
  sum.xz += sign * block.xz;
  sum.yz += sign * block.yz;
}

/// Returns the amplitudes of the same real fields at -q if `is_conjugate` is
/// set, and the vector itself otherwise.
inline WaveVector conjugated(const WaveVector& vector, bool is_conjugate) {
  if (!is_conjugate)
    return vector;
  return {-std::conj(vector(0)), -std::conj(vector(1)), std::conj(vector(2))};
}

/// Three spectra of a layer, each with n modes, stored contiguously.
struct WavePlanes {
  std::complex<double>* x = nullptr;
  std::size_t n = 0;

  WaveVector at(std::size_t mode) const {
    return {x[mode], x[n + mode], x[2 * n + mode]};
  }

  void set(std::size_t mode, const WaveVector& vector) const {
    x[mode] = vector(0);
    x[n + mode] = vector(1);
    x[2 * n + mode] = vector(2);
  }
};

/// A mode of a half spectrum, or the conjugate of such a mode.
struct HalfMode {
  std::size_t index = 0; ///< index into the half spectrum
  bool is_conjugate = false;
};

/// Returns the entry of the half spectrum that represents the mode (jx, jy) of
/// the full spectrum. Both numbers may be any non-negative integers.
inline HalfMode half_mode(const Grid& grid, int jx, int jy) {
  int x = jx % grid.points_x;
  int y = jy % grid.points_y;
  const bool is_conjugate = x > grid.points_x / 2;
  if (is_conjugate) {
    x = grid.points_x - x;
    y = (grid.points_y - y) % grid.points_y;
  }
  const std::size_t columns = grid.half_spectrum_columns();
  return {static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x),
          is_conjugate};
}

/// Returns the four modes of the fine grid that alias to the mode (jx, jy) of
/// the coarse grid.
inline std::array<HalfMode, 4> aliases(const Grid& fine, int jx, int jy) {
  const int x = jx + fine.points_x / 2;
  const int y = jy + fine.points_y / 2;
  return {half_mode(fine, jx, jy), half_mode(fine, x, jy),
          half_mode(fine, jx, y), half_mode(fine, x, y)};
}

namespace {

double angle(int wavenumber, int points) {
  return wavevector(signed_wavenumber(wavenumber, points), points);
}

} // namespace

BlockSolver::BlockSolver(const MultiscaleBlock& block,
                         const BlockSupport& support, int threads)
    : block_(&block), support_(support), threads_(threads) {
  require_not_negative("contact_stiffness", support.contact_stiffness, "N/m");
  if (!support.is_height_held)
    require_positive("contact_stiffness", support.contact_stiffness, "N/m");
  std::vector<SymmetricBlock> below;
  for (int level = 0; level < block.shape().levels; ++level) {
    const Grid grid = block.level_grid(level);
    levels_.emplace_back(grid);
    if (level == 0) {
      const double stiffness =
          support.contact_stiffness * static_cast<double>(grid.size());
      below.assign(
          grid.half_spectrum_size(),
          SymmetricBlock{stiffness, stiffness, stiffness, 0.0, 0.0, 0.0});
    } else {
      const Grid fine = block.level_grid(level - 1);
      const std::vector<SymmetricBlock> lifted = std::move(below);
      below.assign(grid.half_spectrum_size(), {});
      for (int jy = 0; jy < grid.points_y; ++jy)
        for (int jx = 0; jx <= grid.points_x / 2; ++jx)
          for (const HalfMode& alias : aliases(fine, jx, jy))
            add(below[half_mode(grid, jx, jy).index], lifted[alias.index],
                alias.is_conjugate);
    }
    below = factor_level(level, below);
  }
  plate_stiffness_ = below[0].zz;
}

/// Factorises the layers of one level, from the lowest upwards.
/// @return  the contribution of this level to the stiffness of the layer above
///          it, per mode
std::vector<SymmetricBlock>
BlockSolver::factor_level(int at, const std::vector<SymmetricBlock>& below) {
  Level& level = levels_[static_cast<std::size_t>(at)];
  const SlabCouplings& slab = block_->couplings(at);
  const Grid grid = block_->level_grid(at);
  const int layers = block_->shape().layers;
  const std::size_t modes = grid.half_spectrum_size();
  const auto atoms = static_cast<double>(grid.size());
  level.share.resize(modes);
  level.upwards.resize(modes);
  level.inverse.resize(modes * static_cast<std::size_t>(layers));
  std::vector<SymmetricBlock> above(modes);
  parallel_rows(grid.points_y, threads_, [&](int jy) {
    for (int jx = 0; jx <= grid.points_x / 2; ++jx) {
      const std::size_t mode = half_mode(grid, jx, jy).index;
      const double x = angle(jx, grid.points_x);
      const double y = angle(jy, grid.points_y);
      const auto stiffness = [&](const LayerCoupling& coupling) -> WaveBlock {
        return atoms * full(coupling.symbol(x, y));
      };
      const WaveBlock upwards = stiffness(slab.to_lower);
      const WaveBlock inside = stiffness(slab.inside);
      WaveBlock own = stiffness(slab.within_lower) + full(below[mode]);
      WaveBlock inverse = own.inverse();
      if (at == 0 && mode == 0) {
        inverse(0, 0) = inverse(1, 1) = 0.0; // held, i.e. infinitely stiff
        if (support_.is_height_held)
          inverse(2, 2) = 0.0;
      }
      for (int layer = 0; layer < layers; ++layer) {
        if (layer > 0)
          inverse = (inside - upwards.transpose() * inverse * upwards)
                        .inverse()
                        .eval();
        level.inverse[static_cast<std::size_t>(layer) * modes + mode] =
            symmetric_part(inverse);
      }
      // The last level is attached to the plate directly, without
      // interpolation.
      const bool is_last = at + 1 == block_->shape().levels;
      const double share = is_last ? 1.0 : interpolated_share(x, y);
      level.share[mode] = share;
      Eigen::Map<WaveBlock>(level.upwards[mode].data()) = upwards;
      above[mode] =
          symmetric_part(WaveBlock(share * share *
                                   (stiffness(slab.within_upper) -
                                    upwards.transpose() * inverse * upwards)));
    }
  });
  return above;
}

BlockSolver::Spectra
BlockSolver::spectra_of(std::span<const double> forces) const {
  const int layers = block_->shape().layers;
  Spectra spectra(levels_.size());
  for (int at = 0; at < block_->shape().levels; ++at) {
    const Grid grid = block_->level_grid(at);
    const std::size_t modes = grid.half_spectrum_size();
    std::vector<Complex>& layer_spectra = spectra[static_cast<std::size_t>(at)];
    layer_spectra.resize(3 * modes * static_cast<std::size_t>(layers));
    parallel_rows(3 * layers, threads_, [&](int plane) {
      const auto i = static_cast<std::size_t>(plane);
      const double* const begin =
          forces.data() + block_->begin_of(at, 0) + i * grid.size();
      const std::vector<double> field(begin, begin + grid.size());
      const std::span modes_of_plane(layer_spectra.data() + i * modes, modes);
      levels_[static_cast<std::size_t>(at)].fourier.forward(field,
                                                            modes_of_plane);
      if (plane % 3 < 2)
        for (Complex& amplitude : modes_of_plane)
          amplitude *= Complex(0.0, -1.0);
    });
  }
  return spectra;
}

/// The spectra are overwritten.
void BlockSolver::fields_of(Spectra& spectra, std::span<double> answer) const {
  for (int at = 0; at < block_->shape().levels; ++at) {
    const Grid grid = block_->level_grid(at);
    const std::size_t modes = grid.half_spectrum_size();
    std::vector<Complex>& layer_spectra = spectra[static_cast<std::size_t>(at)];
    parallel_rows(3 * block_->shape().layers, threads_, [&](int plane) {
      const auto i = static_cast<std::size_t>(plane);
      const std::span modes_of_plane(layer_spectra.data() + i * modes, modes);
      if (plane % 3 < 2)
        for (Complex& amplitude : modes_of_plane)
          amplitude *= Complex(0.0, 1.0);
      std::vector<double> field(grid.size());
      levels_[static_cast<std::size_t>(at)].fourier.backward(modes_of_plane,
                                                             field);
      std::ranges::copy(field, answer.data() + block_->begin_of(at, 0) +
                                   i * grid.size());
    });
  }
}

/// Forward elimination within one level. On return, `layers` holds the forces
/// on each layer after elimination of the layers below it; the returned value
/// is the force on the layer above the level.
std::vector<std::complex<double>>
BlockSolver::eliminate(int at, std::vector<Complex>& layers) const {
  const Level& level = levels_[static_cast<std::size_t>(at)];
  const Grid grid = block_->level_grid(at);
  const std::size_t modes = grid.half_spectrum_size();
  const std::size_t row = grid.half_spectrum_columns();
  const auto n_layers = static_cast<std::size_t>(block_->shape().layers);
  std::vector<Complex> above(3 * modes);
  parallel_rows(grid.points_y, threads_, [&](int jy) {
    const std::size_t first = static_cast<std::size_t>(jy) * row;
    for (std::size_t layer = 0; layer < n_layers; ++layer) {
      const WavePlanes here{layers.data() + 3 * modes * layer, modes};
      const bool is_last = layer + 1 == n_layers;
      const WavePlanes next{is_last ? above.data() : here.x + 3 * modes, modes};
      for (std::size_t mode = first; mode < first + row; ++mode) {
        const WaveBlock inverse = full(level.inverse[layer * modes + mode]);
        const WaveVector lifted =
            full(level.upwards[mode]).transpose() * (inverse * here.at(mode));
        next.set(mode,
                 next.at(mode) - (is_last ? level.share[mode] : 1.0) * lifted);
      }
    }
  });
  return above;
}

/// Back substitution within one level: computes the displacements of each layer
/// from those above it, which are the displacements of the coarser level's
/// lowest layer or of the plate.
void BlockSolver::substitute(int at, Complex* coarse, double plate,
                             std::vector<Complex>& layers) const {
  const Level& level = levels_[static_cast<std::size_t>(at)];
  const Grid grid = block_->level_grid(at);
  const std::size_t modes = grid.half_spectrum_size();
  const std::size_t row = grid.half_spectrum_columns();
  const bool is_last = at + 1 == block_->shape().levels;
  const Grid coarse_grid = block_->level_grid(is_last ? at : at + 1);
  const WavePlanes above{coarse, coarse_grid.half_spectrum_size()};
  parallel_rows(grid.points_y, threads_, [&](int jy) {
    const std::size_t first = static_cast<std::size_t>(jy) * row;
    std::vector<WaveVector> next(row, WaveVector::Zero());
    for (std::size_t jx = 0; jx < row && !is_last; ++jx) {
      const HalfMode mode = half_mode(coarse_grid, static_cast<int>(jx), jy);
      next[jx] = level.share[first + jx] *
                 conjugated(above.at(mode.index), mode.is_conjugate);
    }
    if (is_last && jy == 0)
      next[0](2) = plate;
    for (int layer = block_->shape().layers - 1; layer >= 0; --layer) {
      const std::size_t begin = static_cast<std::size_t>(layer) * modes;
      const WavePlanes here{layers.data() + 3 * begin, modes};
      for (std::size_t jx = 0; jx < row; ++jx) {
        const std::size_t mode = first + jx;
        next[jx] = full(level.inverse[begin + mode]) *
                   (here.at(mode) - full(level.upwards[mode]) * next[jx]);
        here.set(mode, next[jx]);
      }
    }
  });
}

/// Adds to the forces on the lowest layer of a level those that the elimination
/// of the finer level transfers to it.
void BlockSolver::gather(int at, std::vector<Complex>& lifted,
                         std::vector<Complex>& layers) const {
  const Grid grid = block_->level_grid(at);
  const Grid fine = block_->level_grid(at - 1);
  const WavePlanes lowest{layers.data(), grid.half_spectrum_size()};
  const WavePlanes from{lifted.data(), fine.half_spectrum_size()};
  for (int jy = 0; jy < grid.points_y; ++jy) {
    for (int jx = 0; jx <= grid.points_x / 2; ++jx) {
      const std::size_t mode = half_mode(grid, jx, jy).index;
      WaveVector sum = lowest.at(mode);
      for (const HalfMode& alias : aliases(fine, jx, jy))
        sum += conjugated(from.at(alias.index), alias.is_conjugate);
      lowest.set(mode, sum);
    }
  }
}

void BlockSolver::solve(std::span<const double> forces,
                        std::span<double> answer) const {
  assert(forces.size() == block_->size() && answer.size() == block_->size());
  Spectra spectra = spectra_of(forces);
  const int last = block_->shape().levels - 1;
  std::vector<Complex> lifted;
  for (int at = 0; at <= last; ++at) {
    std::vector<Complex>& layers = spectra[static_cast<std::size_t>(at)];
    if (at > 0)
      gather(at, lifted, layers);
    lifted = eliminate(at, layers);
  }

  const std::size_t top_modes = block_->level_grid(last).half_spectrum_size();
  const double plate =
      (forces[block_->plate()] + lifted[2 * top_modes].real()) /
      plate_stiffness_;
  for (int at = last; at >= 0; --at) {
    const auto here = static_cast<std::size_t>(at);
    substitute(at, at == last ? nullptr : spectra[here + 1].data(), plate,
               spectra[here]);
  }
  answer[block_->plate()] = plate;
  fields_of(spectra, answer);
}

} // namespace asperity::md
