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
      n_low_((width_ + 1) / 2),
      held_rows_(static_cast<std::size_t>(rows)),
      held_width_(static_cast<std::size_t>(width)),
      pair_stride_(rounded_up(width_ + 1)),
      n_columns_(rounded_up(grid.half_spectrum_columns())),
      column_stride_(rounded_up(static_cast<std::size_t>(grid.points_y))),
      plans_(std::make_unique<Plans>(grid, pair_stride_, column_stride_)) {}

template <class Real>
PairTransforms<Real>::~PairTransforms() = default;

template <class Real>
std::size_t PairTransforms<Real>::size_beyond_field() const {
  if (held_rows_ % 2 == 0 && held_width_ >= width_)
    return 0;
  if (held_rows_ % 2 == 0 && held_width_ >= n_low_)
    return n_pairs() * (width_ - n_low_ + (step() > 0 ? 0 : 1));
  return spectrum_size();
}

template <class Real>
auto PairTransforms<Real>::spectrum_in(std::span<Real> field,
                                       Complex* beyond) const -> Spectrum {
  const std::size_t size = size_beyond_field();
  if (size == spectrum_size())
    return spectrum_in(beyond);
  // std::complex allows this, the other way round too on all compilers.
  auto* const own = reinterpret_cast<Complex*>(field.data());
  if (size == 0)
    return {own, held_width_, own + n_low_, held_width_};
  return {own, held_width_, beyond, size / n_pairs()};
}

template <class Real>
auto PairTransforms<Real>::place_of(const Spectrum& spectrum,
                                    std::size_t k) const -> Place {
  if (k < n_low_)
    return {spectrum.low, spectrum.low_stride, k, n_low_};
  return {spectrum.high, spectrum.high_stride, k - n_low_, width_ - n_low_};
}

/// Calls do_pair(pair, first node, whether there is no second row, memory for
/// the rows, memory for the modes).
template <class Real>
template <class DoPair>
void PairTransforms<Real>::each_pair(int threads, Complex* rows,
                                     const DoPair& do_pair) const {
  const int pairs = static_cast<int>(n_pairs());
  const int turns = (pairs + pairs_a_turn - 1) / pairs_a_turn;
  parallel_turns(turns, threads, [&](int turn, int worker) {
    Complex* const own =
        rows + static_cast<std::size_t>(worker) * pair_scratch();
    const int end = std::min(pairs, (turn + 1) * pairs_a_turn);
    for (int pair = turn * pairs_a_turn; pair < end; ++pair) {
      const auto at = static_cast<std::size_t>(pair);
      do_pair(at, 2 * at * held_width_, 2 * at + 1 == held_rows_, own,
              own + pair_stride_);
    }
  });
}

template <class Real>
void PairTransforms<Real>::forward(std::span<const Real> field, int threads,
                                   Complex* rows,
                                   const Spectrum& spectrum) const {
  each_pair(
      threads, rows,
      [&](std::size_t pair, std::size_t first, bool is_single, Complex* both,
          Complex* modes) {
        Complex* const low = spectrum.low + pair * spectrum.low_stride;
        Complex* const high = spectrum.high + pair * spectrum.high_stride;
        const Real* const one = &field[first];
        if (std::all_of(one, one + (is_single ? 1 : 2) * held_width_,
                        [](Real value) { return value == Real{0}; })) {
          std::fill_n(low, n_low_, Complex{});
          std::fill_n(high, width_ - n_low_, Complex{});
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
        const std::size_t shift = shift_of(pair);
        std::rotate_copy(modes, modes + (n_low_ - shift), modes + n_low_, low);
        std::rotate_copy(modes + n_low_, modes + (width_ - shift),
                         modes + width_, high);
      });
}

template <class Real>
void PairTransforms<Real>::backward(const Spectrum& spectrum, int threads,
                                    Complex* rows,
                                    std::span<Real> answer) const {
  each_pair(threads, rows,
            [&](std::size_t pair, std::size_t first, bool is_single,
                Complex* both, Complex* modes) {
              const Complex* const low =
                  spectrum.low + pair * spectrum.low_stride;
              const Complex* const high =
                  spectrum.high + pair * spectrum.high_stride;
              const std::size_t shift = shift_of(pair);
              std::rotate_copy(low, low + shift, low + n_low_, modes);
              std::rotate_copy(high, high + shift, high + (width_ - n_low_),
                               modes + n_low_);
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

/// Calls change(Z(k), Z(-k), two values of the column k) for n columns and each
/// pair of rows.
template <class Real>
template <class Value, class Change>
void PairTransforms<Real>::each_mode(const Spectrum& spectrum,
                                     std::size_t first, std::size_t n,
                                     std::size_t stride, Value* columns,
                                     const Change& change) const {
  if (first < n_low_ && first + n > n_low_) { // the last is in the other half
    each_mode(spectrum, n_low_, 1, stride, columns + (n - 1) * stride, change);
    --n;
  }
  const Place plus = place_of(spectrum, first);
  const Place minus = place_of(spectrum, (width_ - first) % width_);
  const Place further = place_of(spectrum, width_ - first - 1);
  const std::size_t plus_step = plus.stride + step();
  const std::size_t minus_step = minus.stride + step();
  const std::size_t further_step = further.stride + step();
  for (std::size_t pair = 0; pair < n_pairs();) {
    const std::size_t shift = shift_of(pair);
    std::size_t end = n_pairs(); // or where one begins another round
    for (const Place* place : {&plus, &minus, &further})
      if (step() > 0)
        end = std::min(
            end, pair + (place->size - place->slot(shift) + block_width - 1) /
                            block_width);
    Complex* own = plus.of(pair, shift);
    Complex* opposite = minus.of(pair, shift);
    Complex* next = further.of(pair, shift); // opposite to the second column
    for (; pair < end; ++pair) {
      const std::size_t ahead = pair + pairs_ahead < end ? pairs_ahead : 0;
      __builtin_prefetch(own + ahead * plus_step);
      __builtin_prefetch(opposite + ahead * minus_step);
      __builtin_prefetch(next + ahead * further_step - (block_width - 2));
      Value* column = columns + 2 * pair;
      change(own[0], *opposite, column);
      for (std::size_t k = 1; k < n; ++k)
        change(own[k], *(next + 1 - k), column += stride);
      own += plus_step;
      opposite += minus_step;
      next += further_step;
    }
  }
}

template <class Real>
void PairTransforms<Real>::separate(const Spectrum& spectrum, std::size_t first,
                                    std::size_t n, std::size_t stride,
                                    Complex* columns) const {
  each_mode(spectrum, first, n, stride, columns,
            [half = Real{0.5}](const Complex& z, const Complex& mirror,
                               Complex* column) {
              column[0] = {half * (z.real() + mirror.real()),
                           half * (z.imag() - mirror.imag())};
              column[1] = {half * (z.imag() + mirror.imag()),
                           half * (mirror.real() - z.real())};
            });
}

template <class Real>
void PairTransforms<Real>::join(const Complex* columns, std::size_t first,
                                std::size_t n, std::size_t stride,
                                const Spectrum& spectrum) const {
  each_mode(spectrum, first, n, stride, columns,
            [](Complex& z, Complex& mirror, const Complex* column) {
              const Complex a = column[0], b = column[1];
              mirror = {a.real() + b.imag(), b.real() - a.imag()};
              z = {a.real() - b.imag(), b.real() + a.imag()};
            });
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
