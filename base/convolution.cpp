#include "base/convolution.hpp"

#include "base/fourier_plans.hpp"
#include "base/parallel_rows.hpp"

#include <algorithm>
#include <cassert>

namespace asperity {
namespace {

/// Columns that are transformed together: in single precision one row of them
/// is a cache line.
constexpr std::size_t block_width = 8;

/// Rows that a thread processes at a time.
constexpr int rows_a_turn = 8;

std::size_t rounded_up(std::size_t n) {
  return (n + block_width - 1) / block_width * block_width;
}

template <class Real>
auto as_fftw(std::complex<Real>* spectrum) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(spectrum);
}

} // namespace

template <class Real>
struct Convolution<Real>::Plans {
  using Library = Fftw<Real>;
  typename Library::Plan row, row_back, columns, columns_back;

  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Plans(const Grid& grid, std::size_t row_stride, std::size_t column_stride) {
    // Only the alignment of these arrays matters: FFTW_ESTIMATE does not access
    // them, and the plans are executed on other arrays.
    std::vector<Real> field(static_cast<std::size_t>(grid.points_x));
    std::vector<std::complex<Real>> spectrum(
        std::max(row_stride, block_width * column_stride));
    const int height = grid.points_y;
    const int distance = static_cast<int>(column_stride);
    const int width = static_cast<int>(block_width);
    auto* modes = as_fftw(spectrum.data());
    const std::lock_guard lock(planner_mutex());
    row = Library::plan_row(grid.points_x, field.data(), modes, FFTW_ESTIMATE);
    row_back = Library::plan_row_back(grid.points_x, modes, field.data(),
                                      FFTW_ESTIMATE);
    const auto plan = [&](int sign) {
      return Library::plan_columns(1, &height, width, modes, nullptr, 1,
                                   distance, modes, nullptr, 1, distance, sign,
                                   FFTW_ESTIMATE);
    };
    columns = plan(FFTW_FORWARD);
    columns_back = plan(FFTW_BACKWARD);
  }

  ~Plans() {
    const std::lock_guard lock(planner_mutex());
    for (const auto plan : {row, row_back, columns, columns_back})
      Library::destroy(plan);
  }
};

template <class Real>
Convolution<Real>::Convolution(const Grid& grid, int threads)
    : Convolution(grid, grid, threads) {}

template <class Real>
Convolution<Real>::Convolution(const Grid& grid, const Grid& held, int threads)
    : grid_(grid),
      held_(held),
      threads_(threads),
      row_stride_(rounded_up(grid.half_spectrum_columns())),
      column_stride_(rounded_up(static_cast<std::size_t>(grid.points_y))),
      plans_(std::make_unique<Plans>(grid, row_stride_, column_stride_)) {}

template <class Real>
Convolution<Real>::~Convolution() = default;
template <class Real>
Convolution<Real>::Convolution(Convolution&&) noexcept = default;
template <class Real>
Convolution<Real>&
Convolution<Real>::operator=(Convolution&&) noexcept = default;

template <class Real>
auto Convolution<Real>::arranged(std::span<const double> multiplier) const
    -> Symbol {
  assert(multiplier.size() == grid_.half_spectrum_size());
  const std::size_t columns = grid_.half_spectrum_columns();
  const auto rows = static_cast<std::size_t>(grid_.points_y);
  const double normalise = 1.0 / static_cast<double>(grid_.size());
  Symbol symbol;
  symbol.values_.resize(row_stride_ * column_stride_);
  for (std::size_t jy = 0; jy < rows; ++jy)
    for (std::size_t jx = 0; jx < columns; ++jx)
      symbol.values_[jx * column_stride_ + jy] =
          static_cast<Real>(normalise * multiplier[jy * columns + jx]);
  return symbol;
}

template <class Real>
void Convolution<Real>::prepare(Scratch& scratch) const {
  const auto workers = static_cast<std::size_t>(threads_);
  scratch.spectrum_.resize(row_stride_ *
                           static_cast<std::size_t>(held_.points_y));
  scratch.columns_.resize(workers * block_width * column_stride_);
  scratch.rows_.resize(workers *
                       rounded_up(static_cast<std::size_t>(grid_.points_x)));
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field, const Symbol& symbol,
                              Scratch& scratch, std::span<Real> answer) const {
  assert(field.size() == held_.size() && answer.size() == held_.size());
  prepare(scratch);
  const auto width = static_cast<std::size_t>(grid_.points_x);
  const auto held_width = static_cast<std::size_t>(held_.points_x);
  const int turns = (held_.points_y + rows_a_turn - 1) / rows_a_turn;
  const auto each_row = [&](const auto& do_row) {
    parallel_turns(turns, threads_, [&](int turn, int worker) {
      Real* const row =
          &scratch.rows_[static_cast<std::size_t>(worker) * rounded_up(width)];
      const int end = std::min(held_.points_y, (turn + 1) * rows_a_turn);
      for (int iy = turn * rows_a_turn; iy < end; ++iy) {
        const auto at = static_cast<std::size_t>(iy);
        do_row(at * held_width, row, as_fftw(&scratch.spectrum_[at * row_stride_]));
      }
    });
  };

  each_row([&](std::size_t first, Real* row, auto* modes) {
    std::copy_n(&field[first], held_width, row);
    std::fill(row + held_width, row + width, Real{0});
    Plans::Library::forward_row(plans_->row, row, modes);
  });
  transform_columns(symbol, scratch);
  each_row([&](std::size_t first, Real* row, auto* modes) {
    Plans::Library::backward_row(plans_->row_back, modes, row);
    std::copy_n(row, held_width, &answer[first]);
  });
}

template <class Real>
void Convolution<Real>::transform_columns(const Symbol& symbol,
                                          Scratch& scratch) const {
  const auto height = static_cast<std::size_t>(grid_.points_y);
  const auto held_height = static_cast<std::size_t>(held_.points_y);
  const std::size_t block_size = block_width * column_stride_;
  const int blocks = static_cast<int>(row_stride_ / block_width);
  parallel_turns(blocks, threads_, [&](int turn, int worker) {
    const auto block = static_cast<std::size_t>(turn);
    std::complex<Real>* const columns =
        &scratch.columns_[static_cast<std::size_t>(worker) * block_size];
    std::complex<Real>* const spectrum =
        &scratch.spectrum_[block * block_width];
    for (std::size_t jy = 0; jy < held_height; ++jy)
      for (std::size_t k = 0; k < block_width; ++k)
        columns[k * column_stride_ + jy] = spectrum[jy * row_stride_ + k];
    for (std::size_t k = 0; k < block_width; ++k)
      std::fill(columns + k * column_stride_ + held_height,
                columns + k * column_stride_ + height, std::complex<Real>{});

    Plans::Library::columns(plans_->columns, as_fftw(columns),
                            as_fftw(columns));
    const Real* const multiplier = &symbol.values_[block * block_size];
    for (std::size_t i = 0; i < block_size; ++i)
      columns[i] *= multiplier[i];
    Plans::Library::columns(plans_->columns_back, as_fftw(columns),
                            as_fftw(columns));

    for (std::size_t jy = 0; jy < held_height; ++jy)
      for (std::size_t k = 0; k < block_width; ++k)
        spectrum[jy * row_stride_ + k] = columns[k * column_stride_ + jy];
  });
}

template class Convolution<float>;
template class Convolution<double>;

} // namespace asperity
