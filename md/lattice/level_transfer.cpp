#include "md/lattice/level_transfer.hpp"

#include <cassert>
#include <cmath>
#include <vector>

namespace asperity::md {
namespace {

/// Returns the index of the coarse row after row iy, periodically.
int next(int iy, int n_y) {
  return iy + 1 == n_y ? 0 : iy + 1;
}

} // namespace

void interpolate(const AtomPlane<const double>& coarse,
                 const AtomPlane<double>& fine) {
  assert(fine.n_x == 2 * coarse.n_x && fine.n_y == 2 * coarse.n_y);
  const auto n = static_cast<std::size_t>(coarse.n_x);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int iy = 0; iy < coarse.n_y; ++iy) {
      const double* const here = coarse.row(axis, iy);
      const double* const above = coarse.row(axis, next(iy, coarse.n_y));
      double* const even = fine.row(axis, 2 * iy);
      double* const odd = fine.row(axis, 2 * iy + 1);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t right = i + 1 == n ? 0 : i + 1;
        even[2 * i] = here[i];
        even[2 * i + 1] = 0.5 * (here[i] + here[right]);
        odd[2 * i] = 0.5 * (here[i] + above[i]);
        odd[2 * i + 1] =
            0.25 * (here[i] + here[right] + above[i] + above[right]);
      }
    }
  }
}

void add_restricted(const AtomPlane<const double>& fine,
                    const AtomPlane<double>& coarse) {
  assert(fine.n_x == 2 * coarse.n_x && fine.n_y == 2 * coarse.n_y);
  const auto n = static_cast<std::size_t>(coarse.n_x);
  std::vector<double> gathered(2 * n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int iy = 0; iy < coarse.n_y; ++iy) {
      const double* const here = fine.row(axis, 2 * iy);
      const double* const above = fine.row(axis, 2 * iy + 1);
      const double* const below =
          fine.row(axis, iy == 0 ? fine.n_y - 1 : 2 * iy - 1);
      for (std::size_t i = 0; i < 2 * n; ++i)
        gathered[i] = here[i] + 0.5 * (above[i] + below[i]);
      double* const out = coarse.row(axis, iy);
      for (std::size_t i = 0; i < n; ++i)
        out[i] +=
            gathered[2 * i] + 0.5 * (gathered[2 * i + 1] +
                                     gathered[i == 0 ? 2 * n - 1 : 2 * i - 1]);
    }
  }
}

double interpolated_share(double fine_angle_x, double fine_angle_y) {
  return 0.25 * (1.0 + std::cos(fine_angle_x)) * (1.0 + std::cos(fine_angle_y));
}

} // namespace asperity::md
