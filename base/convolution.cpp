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

/// Pairs of rows that a thread processes at a time.
constexpr int pairs_a_turn = 4;

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
  typename Library::Plan pair, pair_back, columns, columns_back;

  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  Plans(const Grid& grid, std::size_t pair_stride, std::size_t column_stride) {
    // Only the alignment of these arrays matters: FFTW_ESTIMATE does not access
    // them, and the plans are executed on other arrays.
    std::vector<std::complex<Real>> rows(pair_stride);
    std::vector<std::complex<Real>> spectrum(
        std::max(pair_stride, block_width * column_stride));
    const int row_length = grid.points_x;
    const int height = grid.points_y;
    const int distance = static_cast<int>(column_stride);
    const int width = static_cast<int>(block_width);
    auto* modes = as_fftw(spectrum.data());
    const std::lock_guard lock(planner_mutex());
    const auto plan_pair = [&](auto* from, auto* to, int sign) {
      return Library::plan_columns(1, &row_length, 1, from, nullptr, 1, 1, to,
                                   nullptr, 1, 1, sign, FFTW_ESTIMATE);
    };
    pair = plan_pair(as_fftw(rows.data()), modes, FFTW_FORWARD);
    pair_back = plan_pair(modes, as_fftw(rows.data()), FFTW_BACKWARD);
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
    for (const auto plan : {pair, pair_back, columns, columns_back})
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
      pair_stride_(rounded_up(static_cast<std::size_t>(grid.points_x) + 1)),
      n_columns_(rounded_up(grid.half_spectrum_columns())),
      column_stride_(rounded_up(static_cast<std::size_t>(grid.points_y))),
      plans_(std::make_unique<Plans>(grid, pair_stride_, column_stride_)) {}

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
  symbol.values_.resize(n_columns_ * column_stride_);
  for (std::size_t jy = 0; jy < rows; ++jy)
    for (std::size_t jx = 0; jx < columns; ++jx)
      symbol.values_[jx * column_stride_ + jy] =
          static_cast<Real>(normalise * multiplier[jy * columns + jx]);
  return symbol;
}

template <class Real>
void Convolution<Real>::prepare(Scratch& scratch) const {
  const auto workers = static_cast<std::size_t>(threads_);
  const std::size_t pairs = (static_cast<std::size_t>(held_.points_y) + 1) / 2;
  scratch.spectrum_.resize(pair_stride_ * pairs);
  scratch.columns_.resize(workers * block_width * column_stride_);
  scratch.pairs_.resize(workers * pair_stride_);
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field, const Symbol& symbol,
                              Scratch& scratch, std::span<Real> answer) const {
  assert(field.size() == held_.size() && answer.size() == held_.size());
  prepare(scratch);
  const auto width = static_cast<std::size_t>(grid_.points_x);
  const auto held_width = static_cast<std::size_t>(held_.points_x);
  const int pairs = (held_.points_y + 1) / 2;
  const int turns = (pairs + pairs_a_turn - 1) / pairs_a_turn;
  // Calls do_pair(first node, second row or the first again, rows, modes).
  const auto each_pair = [&](const auto& do_pair) {
    parallel_turns(turns, threads_, [&](int turn, int worker) {
      std::complex<Real>* const rows =
          &scratch.pairs_[static_cast<std::size_t>(worker) * pair_stride_];
      const int end = std::min(pairs, (turn + 1) * pairs_a_turn);
      for (int pair = turn * pairs_a_turn; pair < end; ++pair) {
        const auto at = static_cast<std::size_t>(pair);
        const bool is_single = 2 * pair + 1 == held_.points_y;
        do_pair(2 * at * held_width, is_single, rows,
                &scratch.spectrum_[at * pair_stride_]);
      }
    });
  };

  each_pair([&](std::size_t first, bool is_single, std::complex<Real>* rows,
                std::complex<Real>* modes) {
    const Real* const one = &field[first];
    if (is_single)
      for (std::size_t ix = 0; ix < held_width; ++ix)
        rows[ix] = one[ix];
    else
      for (std::size_t ix = 0; ix < held_width; ++ix)
        rows[ix] = {one[ix], one[held_width + ix]};
    std::fill(rows + held_width, rows + width, std::complex<Real>{});
    Plans::Library::columns(plans_->pair, as_fftw(rows), as_fftw(modes));
    modes[width] = modes[0]; // so that Z(-k) is at width - k for every k
  });
  transform_columns(symbol, scratch);
  each_pair([&](std::size_t first, bool is_single, std::complex<Real>* rows,
                std::complex<Real>* modes) {
    Plans::Library::columns(plans_->pair_back, as_fftw(modes), as_fftw(rows));
    Real* const one = &answer[first];
    for (std::size_t ix = 0; ix < held_width; ++ix)
      one[ix] = rows[ix].real();
    if (!is_single)
      for (std::size_t ix = 0; ix < held_width; ++ix)
        one[held_width + ix] = rows[ix].imag();
  });
}

/// Separates the rows of each pair, for n columns from the column `first`.
template <class Real>
void Convolution<Real>::gather(const std::complex<Real>* spectrum,
                               std::size_t first, std::size_t n,
                               std::complex<Real>* columns) const {
  const auto width = static_cast<std::size_t>(grid_.points_x);
  const auto rows = static_cast<std::size_t>(held_.points_y);
  const Real half = Real{0.5};
  for (std::size_t jy = 0; jy < rows; jy += 2) {
    const std::complex<Real>* const modes = spectrum + jy / 2 * pair_stride_;
    const std::complex<Real>* const plus = modes + first;
    const std::complex<Real>* const minus = modes + (width - first);
    std::complex<Real>* column = columns + jy;
    for (std::size_t k = 0; k < n; ++k, column += column_stride_) {
      const std::complex<Real> z = plus[k];
      const std::complex<Real> mirror = *(minus - k);
      column[0] = {half * (z.real() + mirror.real()),
                   half * (z.imag() - mirror.imag())};
      column[1] = {half * (z.imag() + mirror.imag()),
                   half * (mirror.real() - z.real())};
    }
  }
  const auto height = static_cast<std::size_t>(grid_.points_y);
  for (std::size_t k = 0; k < n; ++k)
    std::fill(columns + k * column_stride_ + rows,
              columns + k * column_stride_ + height, std::complex<Real>{});
}

/// The inverse of gather(): Z(k) = A(k) + i B(k), Z(-k) = conj A(k) + i conj
/// B(k).
template <class Real>
void Convolution<Real>::scatter(const std::complex<Real>* columns,
                                std::size_t first, std::size_t n,
                                std::complex<Real>* spectrum) const {
  const auto width = static_cast<std::size_t>(grid_.points_x);
  const auto rows = static_cast<std::size_t>(held_.points_y);
  for (std::size_t jy = 0; jy < rows; jy += 2) {
    std::complex<Real>* const modes = spectrum + jy / 2 * pair_stride_;
    std::complex<Real>* const plus = modes + first;
    std::complex<Real>* const minus = modes + (width - first);
    const std::complex<Real>* column = columns + jy;
    for (std::size_t k = 0; k < n; ++k, column += column_stride_) {
      const std::complex<Real> a = column[0], b = column[1];
      *(minus - k) = {a.real() + b.imag(), b.real() - a.imag()};
      plus[k] = {a.real() - b.imag(), b.real() + a.imag()};
    }
  }
}

template <class Real>
void Convolution<Real>::transform_columns(const Symbol& symbol,
                                          Scratch& scratch) const {
  const std::size_t block_size = block_width * column_stride_;
  const std::size_t n_modes = grid_.half_spectrum_columns();
  const int blocks = static_cast<int>(n_columns_ / block_width);
  parallel_turns(blocks, threads_, [&](int turn, int worker) {
    const std::size_t first = static_cast<std::size_t>(turn) * block_width;
    const std::size_t n = std::min(block_width, n_modes - first);
    std::complex<Real>* const columns =
        &scratch.columns_[static_cast<std::size_t>(worker) * block_size];
    gather(scratch.spectrum_.data(), first, n, columns);
    std::fill(columns + n * column_stride_, columns + block_size,
              std::complex<Real>{});

    Plans::Library::columns(plans_->columns, as_fftw(columns),
                            as_fftw(columns));
    const Real* const multiplier = &symbol.values_[first * column_stride_];
    for (std::size_t i = 0; i < block_size; ++i)
      columns[i] *= multiplier[i];
    Plans::Library::columns(plans_->columns_back, as_fftw(columns),
                            as_fftw(columns));
    scatter(columns, first, n, scratch.spectrum_.data());
  });
}

template class Convolution<float>;
template class Convolution<double>;

} // namespace asperity
