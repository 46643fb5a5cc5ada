#pragma once

// Transforms between fields on the nodes of a surface and their Fourier
// amplitudes by cell wavevector and node class, and their storage in SIMD
// batches.

#include "base/fourier.hpp"
#include "fem/waves/layer_symbol.hpp"

#include <algorithm>
#include <complex>
#include <span>
#include <vector>

namespace asperity::fem {

/// Four neighbouring wavevectors in jx for one |jy|, with both signs of jy.
/// Lanes beyond the last column repeat it and are not stored.
struct WaveBatch {
  std::size_t row, first, count; ///< |jy|, jx of lane 0, number of lanes in use
  std::size_t opposite;          ///< row of -jy; equal to `row` if -jy and jy
                                 ///< coincide
  SimdBatch theta_x, theta_y;    ///< q times the node spacing, jy > 0 [1]
  /// Cosine and sine of q.x for each node class, for jy and for -jy.
  std::array<std::array<SimdBatch, 4>, 2> cosine, sine;
};

/// Number of columns of values: real and imaginary part for jy, then for -jy.
constexpr std::size_t wave_columns = 4;

/// Computes p_k(q) = 1/cells sum_cells f(x) exp(-i q.x), where x are the actual
/// places of the nodes of class k and q lies in the Brillouin zone of the
/// cells, by a transform of one class at a time. Objects of this class are
/// immutable, so threads may share one.
class NodeClassSpectra {
public:
  /// @param grid  grid of the nodes; its point counts are multiples of the
  ///              degree
  NodeClassSpectra(const Grid& grid, int degree);

  const Grid& grid() const { return grid_; }

  std::size_t node_classes() const { return node_classes_of(degree_); }

  /// Number of values of |jy|.
  std::size_t rows() const { return cells_y_ / 2 + 1; }

  std::size_t batches() const; ///< number per row

  std::size_t size() const; ///< complex numbers per field

  WaveBatch batch(std::size_t row, std::size_t number) const;

  /// Calls visit(first, count) for each contiguous range of one field's spectra
  /// that holds the waves of |jy| = begin..end-1, each wave once.
  template <class Visit>
  void each_stretch(std::size_t begin, std::size_t end,
                    const Visit& visit) const {
    const std::size_t columns = cells_x_ / 2 + 1;
    // Wavenumber 0 and, if their number is even, half of it are their own
    // opposites.
    const std::size_t from = std::max<std::size_t>(begin, 1);
    const std::size_t to = std::min(end, (cells_y_ + 1) / 2);
    for (std::size_t node_class = 0; node_class < node_classes();
         ++node_class) {
      const std::size_t first = node_class * cells_y_ * columns;
      if (begin < end)
        visit(first + begin * columns, (end - begin) * columns);
      if (from < to)
        visit(first + (cells_y_ - to + 1) * columns, (to - from) * columns);
    }
  }

  /// @param field    grid().size() values
  /// @param spectra  size() numbers, overwritten
  /// @param scratch  scratch memory, one per thread
  void forward(std::span<const double> field,
               std::span<std::complex<double>> spectra,
               std::vector<double>& scratch) const;
  /// @param spectra  overwritten
  void backward(std::span<std::complex<double>> spectra,
                std::span<double> field, std::vector<double>& scratch) const;

  /// Loads the columns of each class:
  /// values[node_class * stride * wave_columns + column].
  void load(std::span<const std::complex<double>> spectra,
            const WaveBatch& batch, std::size_t stride,
            SimdBatch* values) const;
  void store(const SimdBatch* values, const WaveBatch& batch,
             std::size_t stride, std::span<std::complex<double>> spectra) const;

private:
  Grid grid_;
  std::size_t degree_;
  std::size_t cells_x_, cells_y_;
  RealFourier fourier_; ///< of one node class
};

} // namespace asperity::fem
