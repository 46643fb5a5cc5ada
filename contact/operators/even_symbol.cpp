#include "contact/operators/even_symbol.hpp"

#include "base/fourier.hpp"
#include "base/parallel_rows.hpp"

#include <algorithm>
#include <complex>

namespace asperity::contact {
namespace {

/// The transform of even lines of n values, of which n/2 + 1 determine the
/// others. Threads may share it.
class EvenTransform {
public:
  explicit EvenTransform(int n) : fourier_({n, 1, 1.0, 1.0}) {}

  /// @param half  called with the values 0..n/2, to be set
  /// @param take  called with the transform at 0..n/2
  template <class Half, class Take>
  void operator()(const Half& half, const Take& take) const {
    const std::size_t n = fourier_.grid().size();
    std::vector<double> line(n);
    const std::span<double> own = std::span(line).first(n / 2 + 1);
    half(own);
    for (std::size_t i = 1; i < own.size(); ++i)
      line[n - i] = own[i];
    std::vector<std::complex<double>> spectrum(own.size());
    fourier_.forward(line, spectrum);
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] = spectrum[i].real();
    take(std::span<const double>(own));
  }

private:
  RealFourier fourier_;
};

} // namespace

/// With memory for the values.
EvenSymbol::EvenSymbol(const Grid& grid, SpectrumColumns own)
    : grid_(grid),
      own_(own),
      stride_(height()),
      values_(std::make_shared<double[]>(own.count * stride_)) {}

EvenSymbol::EvenSymbol(const Grid& grid, const KernelRow& kernel, int threads)
    : EvenSymbol(grid, all_columns(grid)) {
  const EvenTransform along_x(grid.points_x), along_y(grid.points_y);
  parallel_rows(static_cast<int>(stride_), threads, [&](int row) {
    along_x([&](std::span<double> half) { kernel(row, half); },
            [&](std::span<const double> found) {
              for (std::size_t jx = 0; jx < found.size(); ++jx)
                values_[jx * stride_ + static_cast<std::size_t>(row)] =
                    found[jx];
            });
  });
  each_own_column(threads, [&](int /*jx*/, std::span<double> column) {
    along_y(
        [&](std::span<double> half) {
          std::ranges::copy(column, half.begin());
        },
        [&](std::span<const double> found) {
          std::ranges::copy(found, column.begin());
        });
  });
}

EvenSymbol::EvenSymbol(const Grid& grid, const EvenColumn& columns,
                       SpectrumColumns own, int threads)
    : EvenSymbol(grid, own) {
  each_own_column(threads, columns);
}

/// Calls do_column(jx, its values) for each column of this process.
template <class DoColumn>
void EvenSymbol::each_own_column(int threads, const DoColumn& do_column) {
  parallel_rows(static_cast<int>(own_.count), threads, [&](int k) {
    do_column(
        static_cast<int>(own_.first) + k,
        std::span(&values_[static_cast<std::size_t>(k) * stride_], height()));
  });
}

double EvenSymbol::largest() const {
  double largest = 0.0;
  for (std::size_t k = 0; k < own_.count; ++k)
    largest = std::max(
        largest, std::ranges::max(column(static_cast<int>(own_.first + k))));
  return largest;
}

EvenSymbol EvenSymbol::coarsened(const Grid& coarse) const {
  EvenSymbol kept = *this;
  kept.grid_ = coarse;
  kept.own_ = all_columns(coarse);
  return kept;
}

} // namespace asperity::contact
