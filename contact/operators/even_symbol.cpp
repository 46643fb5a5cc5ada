#include "contact/operators/even_symbol.hpp"

#include "base/fourier.hpp"
#include "base/parallel_rows.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <complex>
#include <limits>

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

SpectrumColumns common(const SpectrumColumns& a, const SpectrumColumns& b) {
  const std::size_t first = std::max(a.first, b.first);
  const std::size_t end = std::min(a.first + a.count, b.first + b.count);
  return {first, std::max(first, end) - first};
}

} // namespace

EvenSymbol::EvenSymbol(const Grid& grid, SpectrumColumns own)
    : grid_(grid), own_(own), values_(own.count * height()) {}

EvenSymbol::EvenSymbol(const Grid& grid, RankGroup& ranks,
                       const KernelRow& kernel, SpectrumColumns own,
                       int threads)
    : EvenSymbol(grid, own) {
  const auto n = static_cast<std::size_t>(ranks.size());
  const auto rank = static_cast<std::size_t>(ranks.rank());
  std::vector<int> bounds;
  for (std::size_t r = 0; r <= n; ++r)
    bounds.push_back(static_cast<int>(height() * r / n));
  const int first = bounds[rank];
  const int count = bounds[rank + 1] - first;
  const std::vector<double> rows =
      transformed_rows(kernel, first, count, threads);
  const std::vector<SpectrumColumns> columns =
      values_of_ranks<SpectrumColumns>(&ranks, std::span(&own, 1));
  std::vector<std::size_t> sent, received;
  for (std::size_t r = 0; r < n; ++r) {
    sent.push_back(columns[r].count * static_cast<std::size_t>(count) *
                   sizeof(double));
    received.push_back(own.count *
                       static_cast<std::size_t>(bounds[r + 1] - bounds[r]) *
                       sizeof(double));
  }
  std::vector<double> by_ranks(values_.size());
  ranks.exchange(std::as_bytes(std::span(rows)), sent,
                 std::as_writable_bytes(std::span(by_ranks)), received);
  transform_columns(by_ranks, bounds, threads);
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

double EvenSymbol::value_on_all(int jx, int jy, RankGroup* ranks) const {
  const auto at = static_cast<std::size_t>(jx);
  const bool has_column = at >= own_.first && at < own_.first + own_.count;
  return rank_max(ranks, has_column ? column(jx)[static_cast<std::size_t>(jy)]
                                    : -std::numeric_limits<double>::infinity());
}

std::vector<double> EvenSymbol::transformed_rows(const KernelRow& kernel,
                                                 int first, int count,
                                                 int threads) const {
  const EvenTransform transform(grid_.points_x);
  const auto rows = static_cast<std::size_t>(count);
  std::vector<double> by_columns(rows * grid_.half_spectrum_columns());
  parallel_rows(count, threads, [&](int row) {
    transform([&](std::span<double> half) { kernel(first + row, half); },
              [&](std::span<const double> found) {
                for (std::size_t jx = 0; jx < found.size(); ++jx)
                  by_columns[jx * rows + static_cast<std::size_t>(row)] =
                      found[jx];
              });
  });
  return by_columns;
}

/// @param by_ranks  the own columns of the rows of each rank
/// @param bounds    of the rows of each rank
void EvenSymbol::transform_columns(std::span<const double> by_ranks,
                                   std::span<const int> bounds, int threads) {
  const EvenTransform transform(grid_.points_y);
  parallel_rows(static_cast<int>(own_.count), threads, [&](int column) {
    const auto k = static_cast<std::size_t>(column);
    const auto assemble = [&](std::span<double> half) {
      std::size_t of_rank = 0;
      for (std::size_t r = 0; r + 1 < bounds.size(); ++r) {
        const auto first = static_cast<std::size_t>(bounds[r]);
        const std::size_t rows =
            static_cast<std::size_t>(bounds[r + 1]) - first;
        std::ranges::copy(by_ranks.subspan(of_rank + k * rows, rows),
                          half.subspan(first).begin());
        of_rank += own_.count * rows;
      }
    };
    transform(assemble, [&](std::span<const double> found) {
      std::ranges::copy(found,
                        std::span(values_).subspan(k * height()).begin());
    });
  });
}

EvenSymbol EvenSymbol::coarsened(const Grid& coarse, RankGroup& ranks,
                                 SpectrumColumns own) const {
  EvenSymbol kept(coarse, own);
  const std::size_t rows = kept.height();
  const std::vector<SpectrumColumns> have =
      values_of_ranks<SpectrumColumns>(&ranks, std::span(&own_, 1));
  const std::vector<SpectrumColumns> wanted =
      values_of_ranks<SpectrumColumns>(&ranks, std::span(&own, 1));
  std::vector<double> sent;
  std::vector<std::size_t> to, from;
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    const SpectrumColumns part = common(own_, wanted[r]);
    for (std::size_t jx = part.first; jx < part.first + part.count; ++jx) {
      const auto column =
          std::span(values_).subspan((jx - own_.first) * height(), rows);
      sent.insert(sent.end(), column.begin(), column.end());
    }
    to.push_back(part.count * rows * sizeof(double));
    from.push_back(common(have[r], own).count * rows * sizeof(double));
  }
  ranks.exchange(std::as_bytes(std::span(sent)), to,
                 std::as_writable_bytes(std::span(kept.values_)), from);
  return kept;
}

} // namespace asperity::contact
