#include "fem/waves/kind_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::fem {

KindSpectra::KindSpectra(const Grid& grid, int degree)
    : grid_(grid),
      degree_(static_cast<std::size_t>(degree)),
      cells_x_(static_cast<std::size_t>(grid.points_x / degree)),
      cells_y_(static_cast<std::size_t>(grid.points_y / degree)),
      fourier_(Grid{grid.points_x / degree, grid.points_y / degree,
                    grid.length_x, grid.length_y}) {}

std::size_t KindSpectra::batches() const {
  return (cells_x_ / 2 + lanes) / lanes;
}

std::size_t KindSpectra::size() const {
  return kinds() * fourier_.grid().half_spectrum_size();
}

WaveBatch KindSpectra::batch(std::size_t row, std::size_t number) const {
  const std::size_t columns = cells_x_ / 2 + 1;
  WaveBatch batch{};
  batch.row = row;
  batch.opposite = (cells_y_ - row) % cells_y_;
  batch.first = number * lanes;
  batch.count = std::min(lanes, columns - batch.first);
  const double turn = 2.0 * std::numbers::pi;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t column = std::min(batch.first + lane, columns - 1);
    batch.theta_x[lane] = turn * static_cast<double>(column) / grid_.points_x;
    batch.theta_y[lane] = turn * static_cast<double>(row) / grid_.points_y;
    for (std::size_t kind = 0; kind < kinds(); ++kind)
      for (std::size_t side = 0; side < 2; ++side) {
        const double in_x = kind % 2 == 1 ? batch.theta_x[lane] : 0.0;
        const double in_y = kind / 2 == 1 ? batch.theta_y[lane] : 0.0;
        const double phase = side == 0 ? in_x + in_y : in_x - in_y;
        batch.cosine[side][kind][lane] = std::cos(phase);
        batch.sine[side][kind][lane] = std::sin(phase);
      }
  }
  return batch;
}

void KindSpectra::forward(std::span<const double> field,
                          std::span<std::complex<double>> spectra,
                          std::vector<double>& scratch) const {
  const std::size_t half = fourier_.grid().half_spectrum_size();
  const auto points_x = static_cast<std::size_t>(grid_.points_x);
  const double normalise = 1.0 / static_cast<double>(cells_x_ * cells_y_);
  scratch.resize(cells_x_ * cells_y_);
  for (std::size_t kind = 0; kind < kinds(); ++kind) {
    const double* const first = &field[kind / 2 * points_x + kind % 2];
    for (std::size_t y = 0; y < cells_y_; ++y)
      for (std::size_t x = 0; x < cells_x_; ++x)
        scratch[y * cells_x_ + x] =
            normalise * first[degree_ * (y * points_x + x)];
    fourier_.forward(scratch, spectra.subspan(kind * half, half));
  }
}

void KindSpectra::backward(std::span<std::complex<double>> spectra,
                           std::span<double> field,
                           std::vector<double>& scratch) const {
  const std::size_t half = fourier_.grid().half_spectrum_size();
  const auto points_x = static_cast<std::size_t>(grid_.points_x);
  scratch.resize(cells_x_ * cells_y_);
  for (std::size_t kind = 0; kind < kinds(); ++kind) {
    fourier_.backward(spectra.subspan(kind * half, half), scratch);
    double* const first = &field[kind / 2 * points_x + kind % 2];
    for (std::size_t y = 0; y < cells_y_; ++y)
      for (std::size_t x = 0; x < cells_x_; ++x)
        first[degree_ * (y * points_x + x)] = scratch[y * cells_x_ + x];
  }
}

void KindSpectra::load(std::span<const std::complex<double>> spectra,
                       const WaveBatch& batch, std::size_t stride,
                       SimdBatch* values) const {
  const std::size_t columns = cells_x_ / 2 + 1;
  const std::size_t half = fourier_.grid().half_spectrum_size();
  for (std::size_t kind = 0; kind < kinds(); ++kind)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t row = side == 0 ? batch.row : batch.opposite;
      const std::complex<double>* const from =
          &spectra[kind * half + row * columns + batch.first];
      SimdBatch real{}, imaginary{};
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        real[lane] = from[lane].real();
        imaginary[lane] = from[lane].imag();
      }
      const SimdBatch& cosine = batch.cosine[side][kind];
      const SimdBatch& sine = batch.sine[side][kind];
      SimdBatch* const to = values + kind * stride * wave_columns + 2 * side;
      to[0] = real * cosine + imaginary * sine;
      to[1] = imaginary * cosine - real * sine;
    }
}

void KindSpectra::store(const SimdBatch* values, const WaveBatch& batch,
                        std::size_t stride,
                        std::span<std::complex<double>> spectra) const {
  const std::size_t columns = cells_x_ / 2 + 1;
  const std::size_t half = fourier_.grid().half_spectrum_size();
  for (std::size_t kind = 0; kind < kinds(); ++kind)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t row = side == 0 ? batch.row : batch.opposite;
      if (side == 1 && row == batch.row)
        continue;
      const SimdBatch& cosine = batch.cosine[side][kind];
      const SimdBatch& sine = batch.sine[side][kind];
      const SimdBatch* const from =
          values + kind * stride * wave_columns + 2 * side;
      const SimdBatch real = from[0] * cosine - from[1] * sine;
      const SimdBatch imaginary = from[1] * cosine + from[0] * sine;
      std::complex<double>* const to =
          &spectra[kind * half + row * columns + batch.first];
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        to[lane] = {real[lane], imaginary[lane]};
    }
}

} // namespace asperity::fem
