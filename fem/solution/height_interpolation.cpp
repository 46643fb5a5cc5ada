#include "fem/solution/height_interpolation.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>

namespace asperity::fem {
namespace {

using mechanics::HeightInterpolation;

/// Weights of the nodes -1, 0, 1, 2 at the fraction t of the distance from
/// 0 to 1.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)),
          1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

std::array<double, 4> linear_weights(double t) {
  return {0.0, 1.0 - t, t, 0.0};
}

/// Sums 4 x 4 nodes around a place with products of weights.
double local_sum(const Grid& grid, std::span<const double> field,
                 std::array<double, 4> (*weights)(double),
                 const SurfacePlace& place) {
  const double across = place[0] / grid.spacing_x();
  const double along = place[1] / grid.spacing_y();
  const int ix = static_cast<int>(std::floor(across));
  const int iy = static_cast<int>(std::floor(along));
  const std::array<double, 4> by_column = weights(across - ix);
  const std::array<double, 4> by_row = weights(along - iy);
  double value = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      value += by_row[static_cast<std::size_t>(j)] *
               by_column[static_cast<std::size_t>(i)] *
               field[grid.periodic_index(ix - 1 + i, iy - 1 + j)];
  return value;
}

/// D(t) of (F.3) at the nodes of one period.
/// @param place  in spacings
std::vector<double> band_limited_weights(double place, int n) {
  std::vector<double> weights(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double distance = place - i;
    const double angle = std::numbers::pi * distance / n;
    const double scale = n % 2 == 0 ? std::tan(angle) : std::sin(angle);
    // sin(N a) is that of the distance to the nearest node, up to the sign:
    // written so, it vanishes there exactly.
    const double nearest = std::round(distance);
    const double wave = std::sin(std::numbers::pi * (distance - nearest)) *
                        (std::fmod(nearest, 2.0) == 0.0 ? 1.0 : -1.0);
    weights[static_cast<std::size_t>(i)] =
        std::abs(std::sin(angle)) < 1e-14 ? 1.0 : wave / (n * scale);
  }
  return weights;
}

/// The numbers that places of equal x, or of equal y, share. Those of a mesh of
/// boxes fit into it; for other meshes it is emptied from time to time.
class KeptLines {
public:
  template <typename Make>
  const std::vector<double>& at(double coordinate, const Make& make) {
    constexpr std::size_t most = 4096;
    if (lines_.size() == most)
      lines_.clear();
    const auto [found, is_new] = lines_.try_emplace(coordinate);
    if (is_new)
      found->second = make();
    return found->second;
  }

private:
  std::map<double, std::vector<double>> lines_;
};

class BandLimitedField {
public:
  BandLimitedField(const Grid& grid, std::span<const double> field)
      : grid_(grid), field_(field) {}

  double at(const SurfacePlace& place) {
    const std::vector<double>& column =
        columns_.at(place[0], [&] { return column_at(place[0]); });
    const std::vector<double>& weights = weights_.at(place[1], [&] {
      return band_limited_weights(place[1] / grid_.spacing_y(), grid_.points_y);
    });
    return std::inner_product(column.begin(), column.end(), weights.begin(),
                              0.0);
  }

private:
  /// The field at this x and at each y of the grid.
  std::vector<double> column_at(double x) const {
    const std::vector<double> weights =
        band_limited_weights(x / grid_.spacing_x(), grid_.points_x);
    std::vector<double> column;
    column.reserve(static_cast<std::size_t>(grid_.points_y));
    for (int iy = 0; iy < grid_.points_y; ++iy)
      column.push_back(std::inner_product(
          weights.begin(), weights.end(),
          field_.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, iy)),
          0.0));
    return column;
  }

  const Grid& grid_;
  std::span<const double> field_;
  KeptLines columns_; ///< by x
  KeptLines weights_; ///< by y
};

} // namespace

std::vector<double> interpolated(const Grid& grid,
                                 std::span<const double> field,
                                 HeightInterpolation between,
                                 std::span<const SurfacePlace> places) {
  std::vector<double> values;
  values.reserve(places.size());
  BandLimitedField waves(grid, field);
  for (const SurfacePlace& place : places)
    values.push_back(between == HeightInterpolation::band_limited
                         ? waves.at(place)
                     : between == HeightInterpolation::bilinear
                         ? local_sum(grid, field, linear_weights, place)
                         : local_sum(grid, field, cubic_weights, place));
  return values;
}

} // namespace asperity::fem
