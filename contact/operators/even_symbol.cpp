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

EvenSymbol::EvenSymbol(const Grid& grid, SpectrumColumns own)
    : grid_(grid), own_(own), values_(own.count * height()) {}

EvenSymbol::EvenSymbol(const Grid& grid, const KernelRow& kernel, int threads)
    : EvenSymbol(grid, all_columns(grid)) {
  const std::size_t rows = height();
  const EvenTransform along_x(grid.points_x), along_y(grid.points_y);
  parallel_rows(static_cast<int>(rows), threads, [&](int row) {
    along_x([&](std::span<double> half) { kernel(row, half); },
            [&](std::span<const double> found) {
              for (std::size_t jx = 0; jx < found.size(); ++jx)
                values_[jx * rows + static_cast<std::size_t>(row)] = found[jx];
            });
  });
  parallel_rows(static_cast<int>(own_.count), threads, [&](int jx) {
    const auto column =
        std::span(values_).subspan(static_cast<std::size_t>(jx) * rows, rows);
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
  parallel_rows(static_cast<int>(own.count), threads, [&](int k) {
    columns(static_cast<int>(own.first) + k,
            std::span(values_).subspan(static_cast<std::size_t>(k) * height(),
                                       height()));
  });
}

EvenSymbol EvenSymbol::coarsened(const Grid& coarse) const {
  EvenSymbol kept(coarse, all_columns(coarse));
  auto to = kept.values_.begin();
  for (int jx = 0; jx <= coarse.points_x / 2; ++jx)
    to = std::ranges::copy(column(jx).first(kept.height()), to).out;
  return kept;
}

} // namespace asperity::contact
