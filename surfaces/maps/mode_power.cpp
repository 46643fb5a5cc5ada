#include "surfaces/maps/mode_power.hpp"

#include "base/pair_transforms.hpp"
#include "base/parallel_rows.hpp"
#include "base/ranks/convolution.hpp"

#include <algorithm>
#include <complex>
#include <memory>
#include <vector>

namespace asperity::surfaces {
namespace {

using Complex = std::complex<double>;
using Spectrum = PairTransforms<double>::Spectrum;

/// Complex values of the columns that are in memory together.
std::size_t values_in_memory(const Grid& grid) {
  return std::max(std::size_t{1} << 22, grid.half_spectrum_size() / 8);
}

/// The power of the modes of column jx.
std::vector<double> power_of(const Grid& grid, int jx,
                             std::span<const Complex> column) {
  const auto count = static_cast<double>(grid.size());
  const int pair = modes_in_column(grid, jx);
  std::vector<double> power(column.size());
  for (std::size_t jy = jx == 0 ? 1 : 0; jy < column.size(); ++jy)
    power[jy] = pair * std::norm(column[jy] / count);
  return power;
}

/// Transforms the rows of pieces and keeps some columns of them.
class RowTransforms {
public:
  RowTransforms(const Grid& grid, int threads)
      : grid_(grid), threads_(threads) {}

  /// Calls keep(transforms, spectrum, first row) for the pieces of a map.
  template <class Keep>
  void each_piece(const HeightRows& heights, const Keep& keep) {
    const auto width = static_cast<std::size_t>(grid_.points_x);
    std::size_t row = 0;
    heights([&](std::span<const double> piece) {
      const std::size_t n_rows = piece.size() / width;
      if (n_rows != rows_)
        prepare(n_rows);
      const Spectrum spectrum = transforms_->spectrum_in(spectrum_.data());
      transforms_->forward(piece, threads_, pairs_.data(), spectrum);
      keep(*transforms_, spectrum, row);
      row += n_rows;
    });
  }

private:
  void prepare(std::size_t n_rows) {
    rows_ = n_rows;
    transforms_ = std::make_unique<PairTransforms<double>>(
        grid_, static_cast<int>(n_rows), grid_.points_x);
    pairs_.resize(static_cast<std::size_t>(threads_) *
                  transforms_->pair_scratch());
    spectrum_.resize(transforms_->spectrum_size());
  }

  Grid grid_;
  int threads_;
  std::size_t rows_ = 0; ///< of the piece before
  std::unique_ptr<PairTransforms<double>> transforms_;
  std::vector<Complex> pairs_, spectrum_;
};

} // namespace

void each_column(
    const HeightMap& map,
    const std::function<void(int jx, std::span<const double> power)>& take) {
  Convolution<double>(map.grid).analyse(
      map.heights, [&](int jx, std::span<const Complex> own) {
        take(jx, power_of(map.grid, jx, own));
      });
}

void each_column(
    const Grid& grid, const HeightRows& heights, int threads,
    const std::function<void(int jx, std::span<const double> power)>& take) {
  const PairTransforms<double> whole(grid, 1, grid.points_x);
  RowTransforms rows(grid, threads);
  const std::size_t stride = whole.column_stride();
  const std::size_t n_columns = grid.half_spectrum_columns();
  const std::size_t all_blocks = whole.n_columns() / block_width;
  const std::size_t at_a_time =
      std::clamp(values_in_memory(grid) / (block_width * stride),
                 std::size_t{1}, all_blocks);
  std::vector<Complex> columns(at_a_time * block_width * stride);
  for (std::size_t block = 0; block < all_blocks; block += at_a_time) {
    const int n_blocks =
        static_cast<int>(std::min(at_a_time, all_blocks - block));
    const auto each_block = [&](const auto& do_block) {
      parallel_rows(n_blocks, threads, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        do_block((block + at) * block_width,
                 columns.data() + at * block_width * stride);
      });
    };
    rows.each_piece(heights, [&](const PairTransforms<double>& transforms,
                                 const Spectrum& spectrum,
                                 std::size_t first_row) {
      each_block([&](std::size_t first, Complex* own) {
        transforms.separate(spectrum, first,
                            std::min(block_width, n_columns - first), stride,
                            own + first_row);
      });
    });
    each_block(
        [&](std::size_t, Complex* own) { whole.transform_columns(own); });
    const std::size_t first = block * block_width;
    const std::size_t end =
        std::min(n_columns, first + at_a_time * block_width);
    for (std::size_t jx = first; jx < end; ++jx)
      take(static_cast<int>(jx),
           power_of(grid, static_cast<int>(jx),
                    std::span(columns).subspan(
                        (jx - first) * stride,
                        static_cast<std::size_t>(grid.points_y))));
  }
}

} // namespace asperity::surfaces
