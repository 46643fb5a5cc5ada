#include "surfaces/analysis/autocorrelation.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"
#include "base/special_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace asperity::surfaces {
namespace {

constexpr double decay_threshold = 0.2; // ISO 25178-2
constexpr int n_directions = 180;       // over half a turn

/// Correlation at the lags of the half plane y >= 0, normalised to 1 at lag 0.
class LagPlane {
public:
  LagPlane(const HeightMap& map, bool is_periodic)
      : spacing_x_(map.grid.spacing_x()),
        spacing_y_(map.grid.spacing_y()),
        most_x_(map.grid.points_x / 2),
        most_y_(map.grid.points_y / 2),
        grid_(is_periodic ? map.grid : padded(map.grid)) {
    correlation_ = products(map);
    const double norm = correlation_[0] / static_cast<double>(map.grid.size());
    if (!(norm > 0.0))
      refuse_argument("rms height", 0.0, "> 0 [m]");
    for (int j = 0; j < grid_.points_y; ++j)
      for (int i = 0; i < grid_.points_x; ++i) {
        const double pairs = is_periodic ? static_cast<double>(map.grid.size())
                                         : pairs_at(map.grid, i, j);
        correlation_[grid_.index(i, j)] /= norm * std::max(pairs, 1.0);
      }
  }

  /// Correlation at a lag, |i| <= most_x, 0 <= j <= most_y.
  double at(int i, int j) const {
    return correlation_[grid_.index((i + grid_.points_x) % grid_.points_x,
                                    (j + grid_.points_y) % grid_.points_y)];
  }

  /// Bilinear interpolation; NaN beyond the largest lags.
  double at(double x, double y) const {
    const double column = x / spacing_x_;
    const double row = y / spacing_y_;
    if (!(std::abs(column) < most_x_ && row < most_y_))
      return not_a_number;
    const int i = static_cast<int>(std::floor(column));
    const int j = static_cast<int>(std::floor(row));
    const double right = column - i;
    const double above = row - j;
    return (1.0 - above) * ((1.0 - right) * at(i, j) + right * at(i + 1, j)) +
           above * ((1.0 - right) * at(i, j + 1) + right * at(i + 1, j + 1));
  }

  int most_x() const { return most_x_; }

  int most_y() const { return most_y_; }

private:
  /// Half of each side is added, so that no lag up to half a side wraps around.
  static Grid padded(const Grid& grid) {
    const auto more = [](int points) { return 2 * ((3 * points + 3) / 4 + 1); };
    return {more(grid.points_x), more(grid.points_y),
            more(grid.points_x) * grid.spacing_x(),
            more(grid.points_y) * grid.spacing_y()};
  }

  double pairs_at(const Grid& grid, int i, int j) const {
    const int lag_x = std::abs(signed_wavenumber(i, grid_.points_x));
    const int lag_y = std::abs(signed_wavenumber(j, grid_.points_y));
    return std::max(0.0, static_cast<double>(grid.points_x - lag_x)) *
           std::max(0.0, static_cast<double>(grid.points_y - lag_y));
  }

  /// Sum over the nodes of h(x) h(x + lag).
  std::vector<double> products(const HeightMap& map) const {
    const double mean = mean_height(map);
    std::vector<double> field(grid_.size(), 0.0);
    for (int iy = 0; iy < map.grid.points_y; ++iy)
      for (int ix = 0; ix < map.grid.points_x; ++ix)
        field[grid_.index(ix, iy)] = map.heights[map.grid.index(ix, iy)] - mean;
    std::vector<std::complex<double>> modes(grid_.half_spectrum_size());
    const RealFourier fourier(grid_);
    fourier.forward(field, modes);
    for (std::complex<double>& mode : modes)
      mode = std::norm(mode) / static_cast<double>(grid_.size());
    fourier.backward(modes, field);
    return field;
  }

  double spacing_x_, spacing_y_;
  int most_x_, most_y_;
  Grid grid_;
  std::vector<double> correlation_;
};

/// Distance at which the correlation along a direction first falls to the
/// decay_threshold; NaN if it does not within the lags. The steps are half of
/// the spacing in this direction, so that their number is some four times the
/// lags of a direction, whatever the ratio of the spacings.
double decay_length(const LagPlane& plane, const Grid& grid, double angle) {
  const double step = 0.5 / std::hypot(std::cos(angle) / grid.spacing_x(),
                                       std::sin(angle) / grid.spacing_y());
  double before = 1.0;
  for (int k = 1;; ++k) {
    const double value =
        plane.at(k * step * std::cos(angle), k * step * std::sin(angle));
    if (std::isnan(value))
      return not_a_number;
    if (value <= decay_threshold)
      return step * (k - 1 + (before - decay_threshold) / (before - value));
    before = value;
  }
}

std::vector<CorrelationPoint> averaged(const LagPlane& plane,
                                       const Grid& grid) {
  const double width = std::max(grid.spacing_x(), grid.spacing_y());
  const double furthest = 0.5 * std::min(grid.length_x, grid.length_y);

  struct Ring {
    double distance = 0.0;
    double correlation = 0.0;
    double count = 0.0;
  };

  std::vector<Ring> rings(static_cast<std::size_t>(furthest / width) + 1);
  for (int j = 0; j <= plane.most_y(); ++j)
    for (int i = -plane.most_x(); i <= plane.most_x(); ++i) {
      const double distance =
          std::hypot(i * grid.spacing_x(), j * grid.spacing_y());
      const bool is_zero = i == 0 && j == 0; // the only lag of ring 0
      const auto ring = static_cast<std::size_t>(
          is_zero ? 0 : std::max(1L, std::lround(distance / width)));
      if (distance > furthest || ring >= rings.size())
        continue;
      rings[ring].distance += distance;
      rings[ring].correlation += plane.at(i, j);
      rings[ring].count += 1.0;
    }
  std::vector<CorrelationPoint> points;
  for (const Ring& ring : rings)
    if (ring.count > 0.0)
      points.push_back(
          {ring.distance / ring.count, ring.correlation / ring.count});
  return points;
}

} // namespace

Autocorrelation autocorrelation(const HeightMap& map, bool is_periodic) {
  const LagPlane plane(map, is_periodic);
  Autocorrelation result;
  result.points = averaged(plane, map.grid);
  result.shortest = result.longest = not_a_number;
  bool has_open_direction = false;
  for (int k = 0; k < n_directions; ++k) {
    const double length =
        decay_length(plane, map.grid, std::numbers::pi * k / n_directions);
    has_open_direction |= std::isnan(length);
    result.shortest = std::fmin(result.shortest, length);
    result.longest = std::fmax(result.longest, length);
  }
  if (has_open_direction)
    result.longest = not_a_number;
  result.aspect_ratio = result.shortest / result.longest;
  return result;
}

} // namespace asperity::surfaces
