#include "contact/operators/stress_inside.hpp"

#include "base/require.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::contact {
namespace {

using Complex = std::complex<double>;

/// At this q z a mode has decayed below roundoff.
constexpr double decayed = 40.0;

/// Ratio of the depths of consecutive planes in the search for the largest
/// stress.
constexpr double plane_ratio = 1.25;

/// The only mode of a half-space, (L.4), for a unit pressure on its surface.
constexpr LayerStack::Wave half_space_wave{0.0, 1.0, 0.0, 0.0};

/// Unit vector along q. A Nyquist mode, which equals its opposite on the grid,
/// has no sign.
struct Direction {
  double length = 0.0; ///< q [rad/m]
  double x = 0.0;
  double y = 0.0;
  bool has_sign = true;
};

Direction direction_of(const Grid& grid, int jx, int jy) {
  const double qx = wavevector(jx, grid.length_x);
  const double qy =
      wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y);
  const double q = std::hypot(qx, qy);
  const bool at_nyquist = 2 * jx == grid.points_x || 2 * jy == grid.points_y;
  return {q, qx / q, qy / q, !at_nyquist};
}

Eigen::Matrix3d tensor_at(const StressPlane& plane, std::size_t i) {
  Eigen::Matrix3d stress;
  stress << plane.xx[i], plane.xy[i], plane.zx[i], //
      plane.xy[i], plane.yy[i], plane.yz[i],       //
      plane.zx[i], plane.yz[i], plane.zz[i];
  return stress;
}

} // namespace

std::vector<double> von_mises(const StressPlane& plane) {
  std::vector<double> result(plane.zz.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double xy = plane.xx[i] - plane.yy[i];
    const double yz = plane.yy[i] - plane.zz[i];
    const double zx = plane.zz[i] - plane.xx[i];
    const double shear = plane.xy[i] * plane.xy[i] + plane.yz[i] * plane.yz[i] +
                         plane.zx[i] * plane.zx[i];
    result[i] = std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
  }
  return result;
}

std::vector<double> largest_shear(const StressPlane& plane) {
  std::vector<double> result(plane.zz.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor_at(plane, i),
                                                       Eigen::EigenvaluesOnly)
            .eigenvalues();
    result[i] = 0.5 * (principal(2) - principal(0));
  }
  return result;
}

StressInside::StressInside(const Grid& grid,
                           const mechanics::ElasticBlock& block,
                           std::span<const double> pressure, int threads)
    : grid_(grid),
      stack_(block),
      fourier_(grid, threads),
      spectrum_(grid.half_spectrum_size()) {
  if (pressure.size() != grid.size())
    refuse_argument("pressure.size()", static_cast<double>(pressure.size()),
                    "the number of grid nodes");
  fourier_.forward(pressure, spectrum_);
  for (Complex& mode : spectrum_)
    mode /= static_cast<double>(grid.size());
  const std::size_t n_layers = stack_.size();
  if (n_layers == 1 && std::isinf(block.thickness))
    return;
  waves_.resize(spectrum_.size() * n_layers);
  const int columns = grid.points_x / 2 + 1;
  for (std::size_t mode = 1; mode < spectrum_.size(); ++mode)
    stack_.find_waves(direction_of(grid, static_cast<int>(mode) % columns,
                                   static_cast<int>(mode) / columns)
                          .length,
                      std::span(waves_).subspan(mode * n_layers, n_layers));
}

std::span<const LayerStack::Wave>
StressInside::waves_of(std::size_t mode) const {
  if (waves_.empty())
    return {&half_space_wave, 1};
  return std::span(waves_).subspan(mode * stack_.size(), stack_.size());
}

StressPlane StressInside::stress_in(const Plane& place) const {
  std::array<std::vector<Complex>, 6> waves;
  for (std::vector<Complex>& component : waves)
    component.resize(spectrum_.size());
  auto& [xx, yy, zz, xy, yz, zx] = waves;
  zz[0] = -spectrum_[0];
  xx[0] = yy[0] = -stack_.layer(place.layer).lateral_ratio * spectrum_[0];
  const int columns = grid_.points_x / 2 + 1;
  for (std::size_t mode = 1; mode < spectrum_.size(); ++mode) {
    const Direction n = direction_of(grid_, static_cast<int>(mode) % columns,
                                     static_cast<int>(mode) / columns);
    if (n.length * place.depth > decayed)
      continue;
    const LayerStack::Stress wave = stack_.stress(
        place.layer, waves_of(mode)[place.layer], n.length, place.depth);
    const Complex pressure = spectrum_[mode];
    zz[mode] = wave.zz * pressure;
    xx[mode] = (n.x * n.x * wave.qq + n.y * n.y * wave.tt) * pressure;
    yy[mode] = (n.y * n.y * wave.qq + n.x * n.x * wave.tt) * pressure;
    if (!n.has_sign)
      continue;
    xy[mode] = n.x * n.y * (wave.qq - wave.tt) * pressure;
    const Complex shear = Complex(0.0, wave.zq) * pressure;
    zx[mode] = n.x * shear;
    yz[mode] = n.y * shear;
  }
  StressPlane plane;
  const std::array<std::vector<double>*, 6> maps{
      &plane.xx, &plane.yy, &plane.zz, &plane.xy, &plane.yz, &plane.zx};
  for (std::size_t k = 0; k < maps.size(); ++k) {
    maps[k]->resize(grid_.size());
    fourier_.backward(waves[k], *maps[k]);
  }
  return plane;
}

StressPlane StressInside::at_depth(double depth, InterfaceSide side) const {
  require_between("depth", depth, 0.0, stack_.thickness(), "m");
  std::size_t layer = 0;
  while (layer + 1 < stack_.size() && (depth > stack_.layer(layer + 1).top ||
                                       (depth == stack_.layer(layer + 1).top &&
                                        side == InterfaceSide::lower)))
    ++layer;
  return stress_in({layer, depth});
}

double StressInside::strength_in(const Plane& plane) const {
  const std::vector<double> map = von_mises(stress_in(plane));
  return *std::max_element(map.begin(), map.end());
}

std::vector<StressInside::Plane>
StressInside::planes_to_search(double shallowest, double deepest) const {
  std::vector<Plane> planes;
  double depth = shallowest;
  for (std::size_t i = 0; i < stack_.size(); ++i) {
    const double top = stack_.layer(i).top;
    const bool is_last = i + 1 == stack_.size();
    const double bottom = is_last ? deepest : stack_.layer(i + 1).top;
    if (i > 0 && top >= shallowest && top <= deepest)
      planes.push_back({i, top});
    for (; depth <= std::min(bottom, deepest); depth *= plane_ratio)
      planes.push_back({i, depth});
    if (!is_last && bottom >= shallowest && bottom <= deepest)
      planes.push_back({i, bottom});
  }
  return planes;
}

StressPeak StressInside::strongest() const {
  const double spacing = std::min(grid_.spacing_x(), grid_.spacing_y());
  const StackLayer& last = stack_.layer(stack_.size() - 1);
  const double deepest =
      std::min(last.top + last.thickness,
               0.5 * std::max(grid_.length_x, grid_.length_y));
  const double shallowest = std::min(spacing, deepest);
  Plane best{0, shallowest};
  double strength = 0.0;
  for (const Plane& plane : planes_to_search(shallowest, deepest))
    if (const double here = strength_in(plane); here > strength) {
      strength = here;
      best = plane;
    }
  // The depth is scaled by that of the best plane, because the tolerance of the
  // search is absolute.
  const StackLayer& layer = stack_.layer(best.layer);
  const double low =
      std::max(1.0 / plane_ratio, std::max(shallowest, layer.top) / best.depth);
  const double high = std::min(
      plane_ratio, std::min(deepest, layer.top + layer.thickness) / best.depth);
  constexpr int bits = 10;
  const auto [factor, lowest] = boost::math::tools::brent_find_minima(
      [&](double multiple) {
        return -strength_in({best.layer, multiple * best.depth});
      },
      low, high, bits);
  if (-lowest > strength)
    best.depth *= factor;
  const std::vector<double> map = von_mises(stress_in(best));
  const auto peak = std::max_element(map.begin(), map.end());
  return {*peak, best.depth, static_cast<std::size_t>(peak - map.begin()),
          best.layer > 0 && best.depth == layer.top ? InterfaceSide::lower
                                                    : InterfaceSide::upper};
}

} // namespace asperity::contact
