#include "base/convolution.hpp"

#include "base/fourier_plans.hpp"
#include "base/parallel_rows.hpp"

#include <algorithm>
#include <cassert>

namespace asperity {
namespace {

/// Pairs of rows by which memory is asked for ahead: a block of columns touches
/// two or three cache lines of each pair, far apart from those of the next one.
constexpr std::size_t pairs_ahead = 8;

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
struct PairTransforms<Real>::Plans {
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
PairTransforms<Real>::PairTransforms(const Grid& grid, int rows, int width,
                                     bool is_dense)
    : width_(static_cast<std::size_t>(grid.points_x)),
      held_rows_(static_cast<std::size_t>(rows)),
      held_width_(static_cast<std::size_t>(width)),
      is_dense_(is_dense),
      pair_stride_(is_dense ? width_ : rounded_up(width_ + 1)),
      n_columns_(rounded_up(grid.half_spectrum_columns())),
      column_stride_(rounded_up(static_cast<std::size_t>(grid.points_y))),
      plans_(std::make_unique<Plans>(grid, pair_stride_, column_stride_)) {}

template <class Real>
PairTransforms<Real>::~PairTransforms() = default;

template <class Real>
std::size_t PairTransforms<Real>::spectrum_size() const {
  return pair_stride_ * ((held_rows_ + 1) / 2);
}

/// Calls do_pair(first node, whether there is no second row, rows, modes).
template <class Real>
template <class DoPair>
void PairTransforms<Real>::each_pair(int threads, Complex* rows,
                                     Complex* spectrum,
                                     const DoPair& do_pair) const {
  const int pairs = static_cast<int>((held_rows_ + 1) / 2);
  const int turns = (pairs + pairs_a_turn - 1) / pairs_a_turn;
  parallel_turns(turns, threads, [&](int turn, int worker) {
    Complex* const own = rows + static_cast<std::size_t>(worker) * pair_stride_;
    const int end = std::min(pairs, (turn + 1) * pairs_a_turn);
    for (int pair = turn * pairs_a_turn; pair < end; ++pair) {
      const auto at = static_cast<std::size_t>(pair);
      do_pair(2 * at * held_width_, 2 * at + 1 == held_rows_, own,
              spectrum + at * pair_stride_);
    }
  });
}

template <class Real>
void PairTransforms<Real>::forward(std::span<const Real> field, int threads,
                                   Complex* rows, Complex* spectrum) const {
  each_pair(
      threads, rows, spectrum,
      [&](std::size_t first, bool is_single, Complex* both, Complex* modes) {
        const Real* const one = &field[first];
        if (is_single)
          for (std::size_t ix = 0; ix < held_width_; ++ix)
            both[ix] = one[ix];
        else
          for (std::size_t ix = 0; ix < held_width_; ++ix)
            both[ix] = {one[ix], one[held_width_ + ix]};
        std::fill(both + held_width_, both + width_, Complex{});
        Plans::Library::columns(plans_->pair, as_fftw(both), as_fftw(modes));
        // Z(-k) is then at width - k for every k.
        if (!is_dense_)
          modes[width_] = modes[0];
      });
}

template <class Real>
void PairTransforms<Real>::backward(Complex* spectrum, int threads,
                                    Complex* rows,
                                    std::span<Real> answer) const {
  each_pair(
      threads, rows, spectrum,
      [&](std::size_t first, bool is_single, Complex* both, Complex* modes) {
        Plans::Library::columns(plans_->pair_back, as_fftw(modes),
                                as_fftw(both));
        Real* const one = &answer[first];
        for (std::size_t ix = 0; ix < held_width_; ++ix)
          one[ix] = both[ix].real();
        if (!is_single)
          for (std::size_t ix = 0; ix < held_width_; ++ix)
            one[held_width_ + ix] = both[ix].imag();
      });
}

template <class Real>
void PairTransforms<Real>::separate(const Complex* spectrum, std::size_t first,
                                    std::size_t n, std::size_t stride,
                                    Complex* columns) const {
  const Real half = Real{0.5};
  const std::size_t last_pair = (held_rows_ - 1) / 2;
  for (std::size_t jy = 0; jy < held_rows_; jy += 2) {
    const Complex* const modes = spectrum + jy / 2 * pair_stride_;
    const Complex* const plus = modes + first;
    const Complex* const minus = modes + (width_ - first);
    const Complex* const ahead =
        spectrum + std::min(jy / 2 + pairs_ahead, last_pair) * pair_stride_;
    __builtin_prefetch(ahead + first);
    __builtin_prefetch(ahead + (width_ - first + 1 - n));
    __builtin_prefetch(ahead + std::min(width_ - first, pair_stride_ - 1));
    Complex* column = columns + jy;
    for (std::size_t k = 0; k < n; ++k, column += stride) {
      const Complex z = plus[k];
      const Complex mirror = is_dense_ && first + k == 0 ? z : *(minus - k);
      column[0] = {half * (z.real() + mirror.real()),
                   half * (z.imag() - mirror.imag())};
      column[1] = {half * (z.imag() + mirror.imag()),
                   half * (mirror.real() - z.real())};
    }
  }
}

template <class Real>
void PairTransforms<Real>::join(const Complex* columns, std::size_t first,
                                std::size_t n, std::size_t stride,
                                Complex* spectrum) const {
  for (std::size_t jy = 0; jy < held_rows_; jy += 2) {
    Complex* const modes = spectrum + jy / 2 * pair_stride_;
    Complex* const plus = modes + first;
    Complex* const minus = modes + (width_ - first);
    const Complex* column = columns + jy;
    for (std::size_t k = 0; k < n; ++k, column += stride) {
      const Complex a = column[0], b = column[1];
      if (!is_dense_ || first + k > 0)
        *(minus - k) = {a.real() + b.imag(), b.real() - a.imag()};
      plus[k] = {a.real() - b.imag(), b.real() + a.imag()};
    }
  }
}

template <class Real>
void PairTransforms<Real>::transform_columns(Complex* columns) const {
  Plans::Library::columns(plans_->columns, as_fftw(columns), as_fftw(columns));
}

template <class Real>
void PairTransforms<Real>::transform_columns_back(Complex* columns) const {
  Plans::Library::columns(plans_->columns_back, as_fftw(columns),
                          as_fftw(columns));
}

template <class Real>
void PairTransforms<Real>::convolve(Complex* columns,
                                    const Real* multiplier) const {
  transform_columns(columns);
  for (std::size_t i = 0; i < block_width * column_stride_; ++i)
    columns[i] *= multiplier[i];
  transform_columns_back(columns);
}

template <class Real>
Convolution<Real>::Convolution(const Grid& grid, int threads)
    : Convolution(grid, grid, threads) {}

template <class Real>
Convolution<Real>::Convolution(const Grid& grid, const Grid& held, int threads)
    : grid_(grid),
      held_(held),
      threads_(threads),
      transforms_(std::make_unique<PairTransforms<Real>>(grid, held.points_y,
                                                         held.points_x)) {}

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
  const std::size_t stride = transforms_->column_stride();
  const double normalise = 1.0 / static_cast<double>(grid_.size());
  Symbol symbol;
  symbol.values_.resize(transforms_->n_columns() * stride);
  for (std::size_t jy = 0; jy < rows; ++jy)
    for (std::size_t jx = 0; jx < columns; ++jx)
      symbol.values_[jx * stride + jy] =
          static_cast<Real>(normalise * multiplier[jy * columns + jx]);
  return symbol;
}

template <class Real>
auto Convolution<Real>::arranged(const MultiplierAt& multiplier_at) const
    -> Symbol {
  const auto rows = static_cast<std::size_t>(grid_.points_y);
  const std::size_t stride = transforms_->column_stride();
  const double normalise = 1.0 / static_cast<double>(grid_.size());
  Symbol symbol;
  symbol.values_.resize(transforms_->n_columns() * stride);
  const int columns = static_cast<int>(grid_.half_spectrum_columns());
  parallel_rows(columns, threads_, [&](int jx) {
    Real* const column = &symbol.values_[static_cast<std::size_t>(jx) * stride];
    for (std::size_t jy = 0; jy <= rows / 2; ++jy) {
      column[jy] = static_cast<Real>(normalise *
                                     multiplier_at(jx, static_cast<int>(jy)));
      column[(rows - jy) % rows] = column[jy];
    }
  });
  return symbol;
}

template <class Real>
void Convolution<Real>::prepare(Scratch& scratch) const {
  const auto workers = static_cast<std::size_t>(threads_);
  scratch.spectrum_.resize(transforms_->spectrum_size());
  scratch.columns_.resize(workers * block_width * transforms_->column_stride());
  scratch.pairs_.resize(workers * transforms_->pair_stride());
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field, const Symbol& symbol,
                              Scratch& scratch, std::span<Real> answer) const {
  assert(field.size() == held_.size() && answer.size() == held_.size());
  prepare(scratch);
  transforms_->forward(field, threads_, scratch.pairs_.data(),
                       scratch.spectrum_.data());
  transform_columns(symbol, scratch);
  transforms_->backward(scratch.spectrum_.data(), threads_,
                        scratch.pairs_.data(), answer);
}

template <class Real>
void Convolution<Real>::transform_columns(const Symbol& symbol,
                                          Scratch& scratch) const {
  const std::size_t stride = transforms_->column_stride();
  const std::size_t n_modes = grid_.half_spectrum_columns();
  const auto held_rows = static_cast<std::size_t>(held_.points_y);
  const auto height = static_cast<std::size_t>(grid_.points_y);
  const int blocks = static_cast<int>(transforms_->n_columns() / block_width);
  parallel_turns(blocks, threads_, [&](int turn, int worker) {
    const std::size_t first = static_cast<std::size_t>(turn) * block_width;
    const std::size_t n = std::min(block_width, n_modes - first);
    std::complex<Real>* const columns =
        &scratch
             .columns_[static_cast<std::size_t>(worker) * block_width * stride];
    transforms_->separate(scratch.spectrum_.data(), first, n, stride, columns);
    for (std::size_t k = 0; k < n; ++k)
      std::fill(columns + k * stride + held_rows, columns + k * stride + height,
                std::complex<Real>{});
    std::fill(columns + n * stride, columns + block_width * stride,
              std::complex<Real>{});
    transforms_->convolve(columns, &symbol.values_[first * stride]);
    transforms_->join(columns, first, n, stride, scratch.spectrum_.data());
  });
}

template class PairTransforms<float>;
template class PairTransforms<double>;
template class Convolution<float>;
template class Convolution<double>;

} // namespace asperity
