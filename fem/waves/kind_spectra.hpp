#pragma once

// Fields on the nodes of a face and their waves by cell wavevector and kind of
// node, as blocks of packs take them.

#include "base/fourier.hpp"
#include "fem/waves/layer_symbol.hpp"

#include <algorithm>
#include <complex>
#include <span>
#include <vector>

namespace asperity::fem {

/// Four neighbours in jx of one |jy|, with both signs of jy. Lanes that lie
/// beyond the last column repeat it and are not stored.
struct WaveBatch {
  std::size_t row, first, count; ///< |jy|, jx of lane 0, lanes in use
  std::size_t opposite;          ///< row of -jy; `row` itself if it is the same
  Pack theta_x, theta_y;         ///< q times the node spacing, jy > 0 [1]
  std::array<std::array<Pack, 4>, 2> cosine, sine; ///< of q.x of each kind, for
                                                   ///< jy and for -jy
};

/// Real and imaginary part for jy, then for -jy: four columns of values.
constexpr std::size_t wave_columns = 4;

/// p_k(q) = 1/cells sum_cells f(x) exp(-i q.x), x the true places of the nodes
/// of kind k, q in the cells' Brillouin zone, by transforms of one kind at a
/// time. An instance is immutable: threads share it.
class KindSpectra {
public:
  /// @param grid   of the nodes; its points are multiples of the degree
  KindSpectra(const Grid& grid, int degree);

  const Grid& grid() const { return grid_; }

  std::size_t kinds() const { return kinds_of(degree_); }

  std::size_t rows() const { return cells_y_ / 2 + 1; } ///< of |jy|

  std::size_t batches() const; ///< in a row

  std::size_t size() const; ///< complex numbers of one field

  WaveBatch batch(std::size_t row, std::size_t number) const;

  /// Calls visit(first, count) for the stretches of one field's spectra that
  /// hold the waves of |jy| = begin..end-1, each wave once.
  template <class Visit>
  void each_stretch(std::size_t begin, std::size_t end,
                    const Visit& visit) const {
    const std::size_t columns = cells_x_ / 2 + 1;
    // 0 and, of an even number, the half are their own opposites.
    const std::size_t from = std::max<std::size_t>(begin, 1);
    const std::size_t to = std::min(end, (cells_y_ + 1) / 2);
    for (std::size_t kind = 0; kind < kinds(); ++kind) {
      const std::size_t first = kind * cells_y_ * columns;
      if (begin < end)
        visit(first + begin * columns, (end - begin) * columns);
      if (from < to)
        visit(first + (cells_y_ - to + 1) * columns, (to - from) * columns);
    }
  }

  /// @param field    grid().size() values
  /// @param spectra  size() numbers, overwritten
  /// @param scratch  a thread's own
  void forward(std::span<const double> field,
               std::span<std::complex<double>> spectra,
               std::vector<double>& scratch) const;
  /// @param spectra  destroyed
  void backward(std::span<std::complex<double>> spectra,
                std::span<double> field, std::vector<double>& scratch) const;

  /// Columns of each kind: values[kind * stride * wave_columns + column].
  void load(std::span<const std::complex<double>> spectra,
            const WaveBatch& batch, std::size_t stride, Pack* values) const;
  void store(const Pack* values, const WaveBatch& batch, std::size_t stride,
             std::span<std::complex<double>> spectra) const;

private:
  Grid grid_;
  std::size_t degree_;
  std::size_t cells_x_, cells_y_;
  RealFourier fourier_; ///< of one kind
};

} // namespace asperity::fem
