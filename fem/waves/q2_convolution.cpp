#include "fem/waves/q2_convolution.hpp"

#include "base/parallel_rows.hpp"
#include "fem/waves/cell_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::fem {
namespace {

/// exp(i q d) of a wavenumber on n cells, where d is half a cell.
template <class Real>
std::complex<Real> half_turn(double wavenumber, int n) {
  const double phase = std::numbers::pi * wavenumber / n;
  return {static_cast<Real>(std::cos(phase)),
          static_cast<Real>(std::sin(phase))};
}

/// The product of complex numbers without the treatment of infinite ones.
template <class Real>
std::complex<Real> times(const std::complex<Real>& a,
                         const std::complex<Real>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(),
          a.real() * b.imag() + a.imag() * b.real()};
}

} // namespace

template <class Real>
Q2Convolution<Real>::Q2Convolution(const SharedRows& nodes,
                                   const SharedRows& cells, int threads)
    : nodes_(nodes),
      cells_(cells),
      threads_(threads),
      height_(static_cast<std::size_t>(cells.grid().points_y)),
      transforms_(cells, threads),
      turns_y_(height_) {
  const std::vector<double> weights = relative_nodal_areas(2);
  for (std::size_t k = 0; k < node_classes; ++k)
    factors_[k] = static_cast<Real>(weights[k] /
                                    static_cast<double>(cells.grid().size()));
  const int n = cells.grid().points_y;
  for (int jy = 0; jy < n; ++jy)
    turns_y_[static_cast<std::size_t>(jy)] =
        half_turn<Real>(signed_wavenumber(jy, n), n);
}

template <class Real>
void Q2Convolution<Real>::apply(std::span<const Block> blocks,
                                std::span<const Real> field,
                                std::span<Real> answer) {
  values_.resize(cells_.size());
  for (std::size_t node_class = 0; node_class < node_classes; ++node_class) {
    std::vector<Complex>& spectrum = spectra_[node_class];
    spectrum.resize(columns().count * height_);
    take_class(node_class, field);
    transforms_.analyse(values_, [&](int jx, std::span<const Complex> column) {
      std::ranges::copy(column, spectrum.begin() +
                                    static_cast<std::ptrdiff_t>(column_at(jx)));
    });
  }
  parallel_rows(static_cast<int>(columns().count), threads_, [&](int k) {
    multiply_column(static_cast<std::size_t>(k), blocks);
  });
  for (std::size_t node_class = 0; node_class < node_classes; ++node_class) {
    const std::vector<Complex>& spectrum = spectra_[node_class];
    transforms_.synthesise(
        [&](int jx, std::span<Complex> column) {
          std::copy_n(spectrum.begin() +
                          static_cast<std::ptrdiff_t>(column_at(jx)),
                      height_, column.begin());
        },
        values_);
    return_class(node_class, answer);
  }
}

template <class Real>
void Q2Convolution<Real>::take_class(std::size_t node_class,
                                     std::span<const Real> field) {
  const std::size_t width = cells_.width();
  parallel_rows(cells_.count(), threads_, [&](int row) {
    const std::size_t y = static_cast<std::size_t>(row);
    const Real* const from =
        &field[(2 * y + node_class / 2) * nodes_.width() + node_class % 2];
    for (std::size_t x = 0; x < width; ++x)
      values_[y * width + x] = from[2 * x];
  });
}

template <class Real>
void Q2Convolution<Real>::return_class(std::size_t node_class,
                                       std::span<Real> field) const {
  const std::size_t width = cells_.width();
  parallel_rows(cells_.count(), threads_, [&](int row) {
    const std::size_t y = static_cast<std::size_t>(row);
    Real* const to =
        &field[(2 * y + node_class / 2) * nodes_.width() + node_class % 2];
    for (std::size_t x = 0; x < width; ++x)
      to[2 * x] = values_[y * width + x];
  });
}

/// Multiplies the amplitudes of an own column: those by the places of the cells
/// are turned by exp(-i q.d), where d leads from the vertex of a cell to the
/// node of the class, and the answers are turned back.
template <class Real>
void Q2Convolution<Real>::multiply_column(std::size_t k,
                                          std::span<const Block> blocks) {
  const std::size_t half = height_ / 2 + 1;
  const Complex turn_x = half_turn<Real>(
      static_cast<double>(columns().first + k), cells_.grid().points_x);
  for (std::size_t jy = 0; jy < height_; ++jy) {
    const Complex turn_y = turns_y_[jy];
    const std::array<Complex, node_classes> turns{1, turn_x, turn_y,
                                                  times(turn_x, turn_y)};
    const Block& block = blocks[k * half + std::min(jy, height_ - jy)];
    std::array<Complex, node_classes> amplitudes;
    for (std::size_t j = 0; j < node_classes; ++j)
      amplitudes[j] = factors_[j] *
                      times(std::conj(turns[j]), spectra_[j][k * height_ + jy]);
    for (std::size_t i = 0; i < node_classes; ++i) {
      Complex sum{};
      for (std::size_t j = 0; j < node_classes; ++j)
        sum += block[node_classes * i + j] * amplitudes[j];
      spectra_[i][k * height_ + jy] = times(turns[i], sum);
    }
  }
}

template class Q2Convolution<float>;
template class Q2Convolution<double>;

} // namespace asperity::fem
