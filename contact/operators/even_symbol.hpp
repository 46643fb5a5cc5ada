#pragma once

// The symbol of a convolution that is even in both directions.

#include "base/grid.hpp"
#include "base/ranks/convolution.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// Some columns of a symbol that is real and even in q_x and q_y, as the
/// transform of a real and even kernel is: the values of jx = 0..points_x/2 and
/// jy = 0..points_y/2 are all. It is immutable, and copies share the values.
class EvenSymbol {
public:
  /// The kernel at iy and ix = 0..points_x/2. Threads call it at the same time.
  using KernelRow = std::function<void(int iy, std::span<double> of_ix)>;

  /// Transforms a kernel; the result does not depend on the number of threads.
  /// @param grid   of the periodic convolution
  /// @par Accuracy  roundoff of two one-dimensional transforms
  EvenSymbol(const Grid& grid, const KernelRow& kernel, int threads);

  /// A symbol whose columns are known.
  /// @param own  columns of this process
  EvenSymbol(const Grid& grid, const EvenColumn& columns, SpectrumColumns own,
             int threads);

  /// The part that a coarser grid resolves, if all columns are there. It shares
  /// the values.
  EvenSymbol coarsened(const Grid& coarse) const;

  const Grid& grid() const { return grid_; }

  /// The values for jy = 0..points_y/2.
  /// @param jx  of a column of this process
  std::span<const double> column(int jx) const {
    return {values_.get() +
                (static_cast<std::size_t>(jx) - own_.first) * stride_,
            height()};
  }

  bool has_column(int jx) const {
    const auto at = static_cast<std::size_t>(jx);
    return at >= own_.first && at < own_.first + own_.count;
  }

  /// The largest value of this process; 0 if it has no column.
  double largest() const;

private:
  EvenSymbol(const Grid& grid, SpectrumColumns own);

  template <class DoColumn>
  void each_own_column(int threads, const DoColumn& do_column);

  /// Values of a column.
  std::size_t height() const {
    return static_cast<std::size_t>(grid_.points_y) / 2 + 1;
  }

  Grid grid_;
  SpectrumColumns own_;
  std::size_t stride_;               ///< values from one column to the next
  std::shared_ptr<double[]> values_; ///< set by the constructors
};

/// The columns of a symbol, which must outlive them.
inline EvenColumn columns_of(const EvenSymbol& symbol) {
  return [&symbol](int jx, std::span<double> of_jy) {
    std::ranges::copy(symbol.column(jx).first(of_jy.size()), of_jy.begin());
  };
}

/// The columns of the inverse of a symbol, which must outlive them: 0 where the
/// symbol is 0, as in the uniform mode.
inline EvenColumn inverse_columns_of(const EvenSymbol& symbol) {
  return [&symbol](int jx, std::span<double> of_jy) {
    columns_of(symbol)(jx, of_jy);
    for (double& value : of_jy)
      value = value > 0.0 ? 1.0 / value : 0.0;
  };
}

/// All columns of the half spectrum of a grid.
inline SpectrumColumns all_columns(const Grid& grid) {
  return {0, grid.half_spectrum_columns()};
}

/// The columns of (C + c)^-1.
/// @param compliance        C [m/Pa] > 0; must outlive them
/// @param local_compliance  c [m/Pa] >= 0
inline EvenColumn inverse_columns_of(const EvenColumn& compliance,
                                     double local_compliance) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  return [&compliance, local_compliance](int jx, std::span<double> of_jy) {
    compliance(jx, of_jy);
    for (double& value : of_jy)
      value = 1.0 / (value + local_compliance);
  };
}

} // namespace asperity::contact
