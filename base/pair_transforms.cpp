#include "base/pair_transforms.hpp"

#include "base/fourier_plans.hpp"
#include "base/parallel_rows.hpp"

#include <algorithm>

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
PairTransforms<Real>::PairTransforms(const Grid& grid, int rows, int width)
    : width_(static_cast<std::size_t>(grid.points_x)),
      held_rows_(static_cast<std::size_t>(rows)),
      held_width_(static_cast<std::size_t>(width)),
      pair_stride_(rounded_up(width_ + 1)),
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
        if (std::all_of(one, one + (is_single ? 1 : 2) * held_width_,
                        [](Real value) { return value == Real{0}; })) {
          std::fill_n(modes, pair_stride_, Complex{});
          return;
        }
        if (is_single)
          for (std::size_t ix = 0; ix < held_width_; ++ix)
            both[ix] = one[ix];
        else
          for (std::size_t ix = 0; ix < held_width_; ++ix)
            both[ix] = {one[ix], one[held_width_ + ix]};
        std::fill(both + held_width_, both + width_, Complex{});
        Plans::Library::columns(plans_->pair, as_fftw(both), as_fftw(modes));
        // Z(-k) is then at width - k for every k.
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
      const Complex mirror = *(minus - k);
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

template class PairTransforms<float>;
template class PairTransforms<double>;

} // namespace asperity
