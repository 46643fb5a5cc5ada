#include "surfaces/maps/mode_power.hpp"

#include "base/fourier.hpp"

#include <cmath>
#include <complex>
#include <vector>

namespace asperity::surfaces {

void for_each_mode(const HeightMap& map,
                   const std::function<void(const ModePower&)>& take) {
  const Grid& grid = map.grid;
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  RealFourier(grid).forward(map.heights, modes);

  const auto count = static_cast<double>(grid.size());
  std::size_t at = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++at) {
      if (jx == 0 && jy == 0)
        continue;
      // Column 0 and an even Nyquist column hold both modes of a pair.
      const int pair = jx == 0 || 2 * jx == grid.points_x ? 1 : 2;
      take({std::hypot(wavevector(jx, grid.length_x),
                       wavevector(signed_wavenumber(jy, grid.points_y),
                                  grid.length_y)),
            pair * std::norm(modes[at] / count), pair});
    }
}

} // namespace asperity::surfaces
