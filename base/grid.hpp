#pragma once

// The periodic rectangular grid of all fields: points, spacings, wavevectors,
// the storage order and the wavenumber convention of the DFT.

#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity {

/// A periodic rectangle of points_x * points_y nodes. Node (ix, iy) lies at
/// (ix * spacing_x, iy * spacing_y); fields are flat, x fastest:
/// index = iy * points_x + ix.
struct Grid {
  int points_x = 0;      ///< [1] >= 1
  int points_y = 0;      ///< [1] >= 1
  double length_x = 0.0; ///< period in x [m] > 0
  double length_y = 0.0; ///< period in y [m] > 0

  std::size_t size() const {
    return static_cast<std::size_t>(points_x) *
           static_cast<std::size_t>(points_y);
  }

  /// Number of columns jx = 0..points_x/2 of the half spectrum.
  std::size_t half_spectrum_columns() const {
    return static_cast<std::size_t>(points_x) / 2 + 1;
  }

  /// Number of independent wavevectors of a real field, as FFTW stores them:
  /// rows jy = 0..points_y-1 of columns jx = 0..points_x/2, jx fastest.
  std::size_t half_spectrum_size() const {
    return half_spectrum_columns() * static_cast<std::size_t>(points_y);
  }

  double spacing_x() const { return length_x / points_x; } ///< [m]

  double spacing_y() const { return length_y / points_y; } ///< [m]

  double cell_area() const { return spacing_x() * spacing_y(); } ///< [m^2]

  double area() const { return length_x * length_y; } ///< [m^2]

  bool is_square() const {
    return points_x == points_y && length_x == length_y;
  }

  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(points_x) +
           static_cast<std::size_t>(ix);
  }

  /// The index of a node that may lie outside, on the periodic continuation.
  std::size_t periodic_index(int ix, int iy) const {
    const auto within = [](int i, int n) { return (i % n + n) % n; };
    return index(within(ix, points_x), within(iy, points_y));
  }

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Signed integer wavenumber of DFT row j of n: j, or j - n if j > n/2. The
/// Nyquist row n/2 of an even n counts as positive.
inline int signed_wavenumber(int j, int n) {
  return j <= n / 2 ? j : j - n;
}

/// Whether two lengths are equal up to the roundoff of a product: 10 um and 100
/// times 0.1 um are.
inline bool is_same_length(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::abs(b);
}

/// Wavevector q = 2 pi j / length [rad/m] of the integer wavenumber j.
inline double wavevector(int wavenumber, double length) {
  return 2.0 * std::numbers::pi * wavenumber / length;
}

/// |q| [rad/m] of row jy and column jx of the half spectrum.
inline double wavevector_size(const Grid& grid, int jx, int jy) {
  return std::hypot(
      wavevector(jx, grid.length_x),
      wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y));
}

} // namespace asperity
