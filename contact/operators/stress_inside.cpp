#include "contact/operators/stress_inside.hpp"

#include "base/parallel_rows.hpp"
#include "base/require.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

/// Half the difference of the largest and the smallest principal stress [Pa].
double shear_in(const Eigen::Matrix3d& stress) {
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stress,
                                                     Eigen::EigenvaluesOnly)
          .eigenvalues();
  return 0.5 * (principal(2) - principal(0));
}

/// The stress of a mode of unit pressure, in the order of StressPlane, without
/// the factor i of yz and zx.
using Components = std::array<double, 6>;

Components components_of(const LayerStack::Stress& wave, const Direction& n) {
  const double sign = n.has_sign ? 1.0 : 0.0;
  return {n.x * n.x * wave.qq + n.y * n.y * wave.tt,
          n.y * n.y * wave.qq + n.x * n.x * wave.tt,
          wave.zz,
          sign * n.x * n.y * (wave.qq - wave.tt),
          sign * n.y * wave.zq,
          sign * n.x * wave.zq};
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
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = shear_in(tensor_at(plane, i));
  return result;
}

StressInside::StressInside(const Grid& grid,
                           const mechanics::ElasticBlock& block,
                           std::span<const double> pressure, int threads)
    : grid_(grid),
      stack_(block),
      fourier_(std::make_unique<Convolution<double>>(grid, threads)) {
  if (pressure.size() != grid.size())
    refuse_argument("pressure.size()", static_cast<double>(pressure.size()),
                    "the number of grid nodes");
  const auto height = static_cast<std::size_t>(grid.points_y);
  spectrum_.resize(grid.half_spectrum_columns() * height);
  fourier_->analyse(pressure, [&](int jx, std::span<const Complex> column) {
    const std::size_t at = static_cast<std::size_t>(jx) * height;
    for (std::size_t jy = 0; jy < height; ++jy)
      spectrum_[at + jy] = column[jy] / static_cast<double>(grid.size());
  });
  const std::size_t n_layers = stack_.size();
  if (n_layers == 1 && std::isinf(block.thickness))
    return;
  waves_.resize(spectrum_.size() * n_layers);
  each_mode([&](int jx, int jy, std::size_t mode) {
    stack_.find_waves(direction_of(grid, jx, jy).length,
                      std::span(waves_).subspan(mode * n_layers, n_layers));
  });
}

template <class Take>
void StressInside::each_mode(const Take& take) const {
  const auto height = static_cast<std::size_t>(grid_.points_y);
  parallel_rows(grid_.points_x / 2 + 1, fourier_->threads(), [&](int jx) {
    for (int jy = jx == 0 ? 1 : 0; jy < grid_.points_y; ++jy)
      take(jx, jy,
           static_cast<std::size_t>(jx) * height +
               static_cast<std::size_t>(jy));
  });
}

std::span<const LayerStack::Wave>
StressInside::waves_of(std::size_t mode) const {
  if (waves_.empty())
    return {&half_space_wave, 1};
  return std::span(waves_).subspan(mode * stack_.size(), stack_.size());
}

StressPlane StressInside::stress_in(const Plane& place) const {
  const Grid& grid = grid_;
  std::vector<Components> stresses(spectrum_.size());
  const double lateral = stack_.layer(place.layer).lateral_ratio;
  stresses[0] = {-lateral, -lateral, -1.0, 0.0, 0.0, 0.0}; // the mean
  each_mode([&](int jx, int jy, std::size_t mode) {
    const Direction n = direction_of(grid, jx, jy);
    if (n.length * place.depth <= decayed)
      stresses[mode] =
          components_of(stack_.stress(place.layer, waves_of(mode)[place.layer],
                                      n.length, place.depth),
                        n);
  });
  StressPlane plane;
  const std::array<std::vector<double>*, 6> maps{
      &plane.xx, &plane.yy, &plane.zz, &plane.xy, &plane.yz, &plane.zx};
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const bool is_shear = maps[k] == &plane.yz || maps[k] == &plane.zx;
    maps[k]->resize(grid.size());
    fourier_->synthesise(
        [&](int jx, std::span<Complex> column) {
          const std::size_t at = static_cast<std::size_t>(jx) * column.size();
          for (std::size_t jy = 0; jy < column.size(); ++jy) {
            const Complex stress = stresses[at + jy][k] * spectrum_[at + jy];
            column[jy] =
                is_shear ? Complex(-stress.imag(), stress.real()) : stress;
          }
        },
        *maps[k]);
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

std::vector<double> StressInside::von_mises_row(double depth, int row) const {
  const std::vector<double> plane = von_mises(at_depth(depth));
  const auto first =
      plane.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, row));
  return {first, first + grid_.points_x};
}

double StressInside::shear_at(const StressPeak& peak) const {
  return shear_in(tensor_at(at_depth(peak.depth, peak.side), peak.node));
}

double StressInside::strength_in(const Plane& plane) const {
  return std::ranges::max(von_mises(stress_in(plane)));
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
  const Grid& grid = grid_;
  const double spacing = std::min(grid.spacing_x(), grid.spacing_y());
  const StackLayer& last = stack_.layer(stack_.size() - 1);
  const double deepest = std::min(last.top + last.thickness,
                                  0.5 * std::max(grid.length_x, grid.length_y));
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
  const auto peak = std::ranges::max_element(map);
  return {*peak, best.depth, static_cast<std::size_t>(peak - map.begin()),
          best.layer > 0 && best.depth == layer.top ? InterfaceSide::lower
                                                    : InterfaceSide::upper};
}

} // namespace asperity::contact
