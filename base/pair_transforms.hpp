#pragma once

// The two passes of a transform of a real field on a Grid, by pairs of rows and
// by blocks of columns, and their inverses.

#include "base/grid.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Columns that are transformed together: in single precision one row of them
/// is a cache line.
inline constexpr std::size_t block_width = 8;

/// The transforms of Convolution (base/ranks/convolution.hpp) on some rows of a
/// grid. It is immutable, so that threads may share it.
///
/// Rows are transformed in pairs: a + i b has the transform Z, and
///
///     A(k) = (Z(k) + conj Z(-k))/2,   B(k) = (Z(k) - conj Z(-k))/(2i),
///
/// which takes less time than two real transforms. FFTW only sees single pairs
/// and single blocks of columns, with plans by FFTW_ESTIMATE, so that the
/// result is bitwise independent of the number of threads and the same in every
/// run.
template <class Real>
class PairTransforms {
public:
  using Complex = std::complex<Real>;

  /// @param rows   number of rows that are held, >= 1
  /// @param width  number of their values that are not always 0
  PairTransforms(const Grid& grid, int rows, int width);
  ~PairTransforms();
  PairTransforms(const PairTransforms&) = delete;
  PairTransforms& operator=(const PairTransforms&) = delete;

  /// Complex values of scratch memory that a thread needs for a pair of rows.
  std::size_t pair_scratch() const { return 2 * pair_stride_; }

  /// Number of columns of the half spectrum, rounded up to blocks.
  std::size_t n_columns() const { return n_columns_; }

  /// Values of one column of a block.
  std::size_t column_stride() const { return column_stride_; }

  /// Where the modes of the pairs are: of each pair the first half, rounded up,
  /// in one array, and the others in another one.
  struct Spectrum {
    Complex* low;
    std::size_t low_stride; ///< from one pair to the next
    Complex* high;
    std::size_t high_stride;
  };

  /// Number of complex values of a spectrum in memory of its own.
  std::size_t spectrum_size() const { return n_pairs() * pair_stride_; }

  /// @param memory  spectrum_size() values
  Spectrum spectrum_in(Complex* memory) const {
    return {memory, pair_stride_, memory + n_low_, pair_stride_};
  }

  /// Number of complex values of the modes that do not fit into a field: none
  /// if it has the width of the grid.
  std::size_t size_beyond_field() const;

  /// The spectrum in the memory of a field of rows * width values, of which
  /// each pair of rows holds its own modes.
  /// @param beyond  size_beyond_field() values
  Spectrum spectrum_in(std::span<Real> field, Complex* beyond) const;

  /// Transforms the rows in pairs.
  /// @param field     rows * width values
  /// @param rows      pair_scratch() values of scratch memory for each thread
  /// @param spectrum  overwritten; may be in the memory of the field
  void forward(std::span<const Real> field, int threads, Complex* rows,
               const Spectrum& spectrum) const;

  /// The inverse; the spectrum is destroyed, and may be in the memory of the
  /// answer.
  void backward(const Spectrum& spectrum, int threads, Complex* rows,
                std::span<Real> answer) const;

  /// Separates the rows of each pair, for n columns from the column `first`.
  /// @param stride  values from one column to the next, at least the number of
  ///                rows that are held, rounded up to an even number
  void separate(const Spectrum& spectrum, std::size_t first, std::size_t n,
                std::size_t stride, Complex* columns) const;

  /// The inverse of separate(): Z(k) = A(k) + i B(k), Z(-k) = conj A(k) + i
  /// conj B(k).
  void join(const Complex* columns, std::size_t first, std::size_t n,
            std::size_t stride, const Spectrum& spectrum) const;

  /// Transforms a block of block_width * column_stride() values.
  void transform_columns(Complex* columns) const;

  /// The inverse, without a factor.
  void transform_columns_back(Complex* columns) const;

  /// Transforms a block of columns, multiplies and transforms back.
  /// @param columns     block_width * column_stride() values
  /// @param multiplier  as many values
  void convolve(Complex* columns, const Real* multiplier) const;

private:
  struct Plans;

  /// One mode of each pair.
  struct Place {
    Complex* half;            ///< of the first pair
    std::size_t stride;       ///< from one pair to the next
    std::size_t number, size; ///< in the half, and of it

    /// Where it is in the half of a pair.
    std::size_t slot(std::size_t shift) const {
      return number + shift < size ? number + shift : number + shift - size;
    }

    Complex* of(std::size_t pair, std::size_t shift) const {
      return half + pair * stride + slot(shift);
    }
  };

  Place place_of(const Spectrum& spectrum, std::size_t k) const;

  /// Slots by which the modes of a pair are further on than those of the one
  /// before, round the end of their half: at distances of a power of two, those
  /// of one column would take turns in a few lines of the cache. Blocks of
  /// columns stay together.
  std::size_t step() const {
    return n_low_ % block_width == 0 && 2 * n_low_ == width_ ? block_width : 0;
  }

  std::size_t shift_of(std::size_t pair) const {
    return step() * pair % n_low_;
  }

  template <class Value, class Change>
  void each_mode(const Spectrum& spectrum, std::size_t first, std::size_t n,
                 std::size_t stride, Value* columns,
                 const Change& change) const;

  std::size_t n_pairs() const { return (held_rows_ + 1) / 2; }

  template <class DoPair>
  void each_pair(int threads, Complex* rows, const DoPair& do_pair) const;

  std::size_t width_; ///< points_x of the grid
  std::size_t n_low_; ///< modes of the first half
  std::size_t held_rows_, held_width_;
  std::size_t pair_stride_, n_columns_, column_stride_;
  std::unique_ptr<Plans> plans_;
};

extern template class PairTransforms<float>;
extern template class PairTransforms<double>;

} // namespace asperity
