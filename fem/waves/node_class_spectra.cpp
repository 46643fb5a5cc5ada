#include "fem/waves/node_class_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::fem {

NodeClassSpectra::NodeClassSpectra(const Grid& grid, int degree)
    : grid_(grid),
      degree_(static_cast<std::size_t>(degree)),
      cells_x_(static_cast<std::size_t>(grid.points_x / degree)),
      cells_y_(static_cast<std::size_t>(grid.points_y / degree)),
      fourier_(Grid{grid.points_x / degree, grid.points_y / degree,
                    grid.length_x, grid.length_y}) {}

std::size_t NodeClassSpectra::batches() const {
  return (cells_x_ / 2 + lanes) / lanes;
}

std::size_t NodeClassSpectra::size() const {
  return node_classes() * fourier_.grid().half_spectrum_size();
}

WaveBatch NodeClassSpectra::batch(std::size_t row, std::size_t number) const {
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
    for (std::size_t node_class = 0; node_class < node_classes(); ++node_class)
      for (std::size_t side = 0; side < 2; ++side) {
        const double in_x = node_class % 2 == 1 ? batch.theta_x[lane] : 0.0;
        const double in_y = node_class / 2 == 1 ? batch.theta_y[lane] : 0.0;
        const double phase = side == 0 ? in_x + in_y : in_x - in_y;
        batch.cosine[side][node_class][lane] = std::cos(phase);
        batch.sine[side][node_class][lane] = std::sin(phase);
      }
  }
  return batch;
}

void NodeClassSpectra::forward(std::span<const double> field,
                               std::span<std::complex<double>> spectra,
                               std::vector<double>& scratch) const {
  const std::size_t half = fourier_.grid().half_spectrum_size();
  const auto points_x = static_cast<std::size_t>(grid_.points_x);
  const double normalise = 1.0 / static_cast<double>(cells_x_ * cells_y_);
  scratch.resize(cells_x_ * cells_y_);
  for (std::size_t node_class = 0; node_class < node_classes(); ++node_class) {
    const double* const first =
        &field[node_class / 2 * points_x + node_class % 2];
    for (std::size_t y = 0; y < cells_y_; ++y)
      for (std::size_t x = 0; x < cells_x_; ++x)
        scratch[y * cells_x_ + x] =
            normalise * first[degree_ * (y * points_x + x)];
    fourier_.forward(scratch, spectra.subspan(node_class * half, half));
  }
}

void NodeClassSpectra::backward(std::span<std::complex<double>> spectra,
                                std::span<double> field,
                                std::vector<double>& scratch) const {
  const std::size_t half = fourier_.grid().half_spectrum_size();
  const auto points_x = static_cast<std::size_t>(grid_.points_x);
  scratch.resize(cells_x_ * cells_y_);
  for (std::size_t node_class = 0; node_class < node_classes(); ++node_class) {
    fourier_.backward(spectra.subspan(node_class * half, half), scratch);
    double* const first = &field[node_class / 2 * points_x + node_class % 2];
    for (std::size_t y = 0; y < cells_y_; ++y)
      for (std::size_t x = 0; x < cells_x_; ++x)
        first[degree_ * (y * points_x + x)] = scratch[y * cells_x_ + x];
  }
}

void NodeClassSpectra::load(std::span<const std::complex<double>> spectra,
                            const WaveBatch& batch, std::size_t stride,
                            SimdBatch* values) const {
  const std::size_t columns = cells_x_ / 2 + 1;
  const std::size_t half = fourier_.grid().half_spectrum_size();
  for (std::size_t node_class = 0; node_class < node_classes(); ++node_class)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t row = side == 0 ? batch.row : batch.opposite;
      const std::complex<double>* const from =
          &spectra[node_class * half + row * columns + batch.first];
      SimdBatch real{}, imaginary{};
      for (std::size_t lane = 0; lane < batch.count; ++lane) {
        real[lane] = from[lane].real();
        imaginary[lane] = from[lane].imag();
      }
      const SimdBatch& cosine = batch.cosine[side][node_class];
      const SimdBatch& sine = batch.sine[side][node_class];
      SimdBatch* const to =
          values + node_class * stride * wave_columns + 2 * side;
      to[0] = real * cosine + imaginary * sine;
      to[1] = imaginary * cosine - real * sine;
    }
}

void NodeClassSpectra::store(const SimdBatch* values, const WaveBatch& batch,
                             std::size_t stride,
                             std::span<std::complex<double>> spectra) const {
  const std::size_t columns = cells_x_ / 2 + 1;
  const std::size_t half = fourier_.grid().half_spectrum_size();
  for (std::size_t node_class = 0; node_class < node_classes(); ++node_class)
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t row = side == 0 ? batch.row : batch.opposite;
      if (side == 1 && row == batch.row)
        continue;
      const SimdBatch& cosine = batch.cosine[side][node_class];
      const SimdBatch& sine = batch.sine[side][node_class];
      const SimdBatch* const from =
          values + node_class * stride * wave_columns + 2 * side;
      const SimdBatch real = from[0] * cosine - from[1] * sine;
      const SimdBatch imaginary = from[1] * cosine + from[0] * sine;
      std::complex<double>* const to =
          &spectra[node_class * half + row * columns + batch.first];
      for (std::size_t lane = 0; lane < batch.count; ++lane)
        to[lane] = {real[lane], imaginary[lane]};
    }
}

} // namespace asperity::fem
