#include "surfaces/maps/mode_power.hpp"

#include "base/fourier.hpp"

namespace asperity::surfaces {

std::vector<std::complex<double>> modes_of(const HeightMap& map) {
  std::vector<std::complex<double>> modes(map.grid.half_spectrum_size());
  RealFourier(map.grid).forward(map.heights, modes);
  return modes;
}

} // namespace asperity::surfaces
