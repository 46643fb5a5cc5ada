#include "surfaces/maps/mode_power.hpp"

#include "base/fourier.hpp"

#include "ranks/shared_convolution.hpp"

namespace asperity::surfaces {

std::vector<std::complex<double>> modes_of(const HeightMap& map) {
  std::vector<std::complex<double>> modes(map.grid.half_spectrum_size());
  RealFourier(map.grid).forward(map.heights, modes);
  return modes;
}

void each_column(
    const SharedRows& rows, std::span<const double> heights, int threads,
    const std::function<void(int jx, std::span<const double> power)>& take) {
  const Grid& grid = rows.grid();
  const auto count = static_cast<double>(grid.size());
  SharedConvolution<double>(rows, threads)
      .analyse(heights, [&](int jx, std::span<const std::complex<double>> own) {
        const int pair = modes_in_column(grid, jx);
        std::vector<double> power(own.size());
        for (std::size_t jy = jx == 0 ? 1 : 0; jy < own.size(); ++jy)
          power[jy] = pair * std::norm(own[jy] / count);
        take(jx, power);
      });
}

} // namespace asperity::surfaces
