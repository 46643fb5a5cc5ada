#include "base/ranks/mirrored_convolution.hpp"

#include "base/parallel_rows.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// exp(-i pi j/(2 n)) for j = 0..n-1.
template <class Real>
std::vector<std::complex<Real>> quarter_turns(int n) {
  std::vector<std::complex<Real>> turns;
  turns.reserve(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) {
    const double angle = -0.5 * std::numbers::pi * j / n;
    turns.emplace_back(static_cast<Real>(std::cos(angle)),
                       static_cast<Real>(std::sin(angle)));
  }
  return turns;
}

/// a b, of finite numbers: std::complex also asks whether they are.
template <class Real>
std::complex<Real> product(std::complex<Real> a, std::complex<Real> b) {
  return {a.real() * b.real() - a.imag() * b.imag(),
          a.real() * b.imag() + a.imag() * b.real()};
}

/// i a.
template <class Real>
std::complex<Real> turned(std::complex<Real> a) {
  return {-a.imag(), a.real()};
}

/// The i-th of 0, 2, 4, ..., 5, 3, 1 below n.
int in_order(int i, int n) {
  return 2 * i < n ? 2 * i : 2 * (n - i) - 1;
}

} // namespace

Grid quarter_of(const Grid& cell) {
  assert(cell.points_x % 2 == 0 && cell.points_y % 2 == 0);
  return {cell.points_x / 2, cell.points_y / 2, 0.5 * cell.length_x,
          0.5 * cell.length_y};
}

template <class Real>
MirroredConvolution<Real>::MirroredConvolution(const Grid& cell, int threads)
    : quarter_(quarter_of(cell)),
      convolution_(quarter_, threads),
      turn_x_(quarter_turns<Real>(quarter_.points_x)),
      turn_y_(quarter_turns<Real>(quarter_.points_y)) {}

template <class Real>
void MirroredConvolution<Real>::take_columns(int jx,
                                             const EvenColumn& multipliers,
                                             Real* pair) const {
  const double normalise = 1.0 / static_cast<double>(quarter_.size());
  std::vector<double> of_jy(height() + 1);
  for (const int column : {jx, quarter_.points_x - jx}) {
    multipliers(column, of_jy);
    for (std::size_t jy = 0; jy < height(); ++jy)
      *pair++ = static_cast<Real>(normalise * of_jy[jy]);
  }
}

// With P = w_y V(j_y) and Q = conj(w_y) V(n_y - j_y), T(j_y) = w_x (P + Q)/2
// and T(n_y - j_y) = i w_x (P - Q)/2.
template <class Real>
void MirroredConvolution<Real>::multiply(int jx, const Real* pair,
                                         Complex* column) const {
  const Complex turn = turn_x_[static_cast<std::size_t>(jx)];
  const Complex back = std::conj(turn);
  const auto multiplied = [&](std::size_t jy, Complex mode) {
    return Complex(pair[jy] * mode.real(), pair[height() + jy] * mode.imag());
  };
  const auto alone = [&](std::size_t jy) { // n - jy is jy or beyond
    column[jy] = product(back, multiplied(jy, product(turn, column[jy])));
  };
  alone(0);
  const std::size_t n = height();
  for (std::size_t jy = 1; 2 * jy < n; ++jy) {
    const Complex turn_y = turn_y_[jy];
    const Complex back_y = std::conj(turn_y);
    const Complex p = product(turn_y, column[jy]);
    const Complex q = product(back_y, column[n - jy]);
    const Complex sum = product(back, multiplied(jy, product(turn, p + q)));
    const Complex difference = -turned(
        product(back, multiplied(n - jy, turned(product(turn, p - q)))));
    column[jy] = Real(0.5) * product(back_y, sum + difference);
    column[n - jy] = Real(0.5) * product(turn_y, sum - difference);
  }
  if (n % 2 == 0)
    alone(n / 2);
}

template <class Real>
void MirroredConvolution<Real>::apply(std::span<const Real> field,
                                      const EvenColumn& multipliers,
                                      std::span<Real> answer) {
  assert(field.size() == quarter_.size() && answer.size() == quarter_.size());
  reordered_.resize(field.size());
  const int width = quarter_.points_x;
  const auto each_row = [&](const auto& change) {
    parallel_rows(quarter_.points_y, convolution_.threads(), [&](int row) {
      const std::size_t at =
          quarter_.index(0, in_order(row, quarter_.points_y));
      change(at, &reordered_[quarter_.index(0, row)]);
    });
  };
  each_row([&](std::size_t at, Real* to) {
    for (int x = 0; x < width; ++x)
      to[x] = field[at + static_cast<std::size_t>(in_order(x, width))];
  });
  convolution_.change(
      reordered_,
      [&](int jx, std::span<Complex> column) {
        std::vector<Real> pair(2 * height());
        take_columns(jx, multipliers, pair.data());
        multiply(jx, pair.data(), column.data());
      },
      reordered_);
  each_row([&](std::size_t at, const Real* from) {
    for (int x = 0; x < width; ++x)
      answer[at + static_cast<std::size_t>(in_order(x, width))] = from[x];
  });
}

template class MirroredConvolution<float>;
template class MirroredConvolution<double>;

} // namespace asperity
