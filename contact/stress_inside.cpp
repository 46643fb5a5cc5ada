#include "contact/stress_inside.hpp"

#include "base/require.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

using Complex = std::complex<double>;

/// Beyond this q d the far face is felt below rounding, and a wave has died out
/// at this q z.
constexpr double deep = 40.0;

/// Unit vector along q; the modes that a grid cannot tell from their opposite
/// have none in that direction.
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

StressInside::StressInside(const Grid& grid, const ElasticBlock& block,
                           std::span<const double> pressure, int threads)
    : grid_(grid),
      block_(block),
      fourier_(grid, threads),
      spectrum_(grid.half_spectrum_size()) {
  if (pressure.size() != grid.size())
    refuse_argument("pressure.size()", static_cast<double>(pressure.size()),
                    "the number of grid nodes");
  if (!(block.thickness > 0.0))
    refuse_argument("thickness", block.thickness, "> 0 [m], or infinite");
  if (!(block.poisson_ratio > -1.0 && block.poisson_ratio <= 0.5))
    refuse_argument("poisson_ratio", block.poisson_ratio, "> -1 and <= 0.5");
  fourier_.forward(pressure, spectrum_);
  for (Complex& mode : spectrum_)
    mode /= static_cast<double>(grid.size());
  if (std::isinf(block.thickness))
    return;
  decays_.resize(spectrum_.size());
  const int columns = grid.points_x / 2 + 1;
  for (std::size_t mode = 1; mode < decays_.size(); ++mode)
    decays_[mode] =
        decay_of(direction_of(grid, static_cast<int>(mode) % columns,
                              static_cast<int>(mode) / columns)
                     .length);
}

StressInside::Decay StressInside::decay_of(double wavevector) const {
  const double x = wavevector * block_.thickness;
  if (x > deep)
    return {};
  const double e = std::exp(-x);
  const double nu = block_.poisson_ratio;
  using Row = Eigen::RowVector4d;
  // f and its derivatives, as rows on (a, b, c, d): face, then far face.
  const Row face_f(1.0, 0.0, e, x * e);
  const Row face_slope(-1.0, 1.0, e, (x - 1.0) * e);
  const Row far_f(e, x * e, 1.0, 0.0);
  const Row far_slope(-e, (1.0 - x) * e, 1.0, -1.0);
  const Row far_second(e, (x - 2.0) * e, 1.0, -2.0);
  const Row far_third(-e, (3.0 - x) * e, 1.0, -3.0);
  // i q u_q and q u_z of the far face, over (1 + nu)/E p.
  const Row far_along = (1.0 - nu) * far_second + nu * far_f;
  const Row far_normal = (1.0 - nu) * far_third - (2.0 - nu) * far_slope;
  Eigen::Matrix4d conditions;
  switch (block_.far_face) {
  case FarFace::clamped:
    conditions << face_f, face_slope, far_along, far_normal;
    break;
  case FarFace::sliding:
    conditions << face_f, face_slope, far_slope, far_normal;
    break;
  case FarFace::pressure:
    conditions << face_f, face_slope, far_f, far_slope;
    break;
  }
  const Eigen::Vector4d shape =
      conditions.fullPivLu().solve(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0));
  return {shape(0), shape(1), shape(2), shape(3)};
}

StressInside::Wave StressInside::wave_at(std::size_t mode, double wavevector,
                                         double depth) const {
  const Decay decay = decays_.empty() ? Decay{} : decays_[mode];
  const double x = wavevector * depth;
  const double down = std::exp(-x);
  const double near = decay.a + decay.b * x;
  Wave wave{-near * down, (near - 2.0 * decay.b) * down,
            (near - decay.b) * down};
  if (decay.c != 0.0 || decay.d != 0.0) {
    const double y = wavevector * (block_.thickness - depth);
    const double up = std::exp(-y);
    const double far = decay.c + decay.d * y;
    wave.stress_zz -= far * up;
    wave.stress_qq += (far - 2.0 * decay.d) * up;
    wave.stress_zq -= (far - decay.d) * up;
  }
  return wave;
}

StressPlane StressInside::at_depth(double depth) const {
  require_between("depth", depth, 0.0, block_.thickness, "m");
  const double nu = block_.poisson_ratio;
  std::array<std::vector<Complex>, 6> waves;
  for (std::vector<Complex>& component : waves)
    component.resize(spectrum_.size());
  auto& [xx, yy, zz, xy, yz, zx] = waves;
  const double sideways = -nu / (1.0 - nu);
  zz[0] = -spectrum_[0];
  xx[0] = yy[0] = sideways * spectrum_[0];
  const int columns = grid_.points_x / 2 + 1;
  for (std::size_t mode = 1; mode < spectrum_.size(); ++mode) {
    const Direction n = direction_of(grid_, static_cast<int>(mode) % columns,
                                     static_cast<int>(mode) / columns);
    if (n.length * depth > deep && n.length * (block_.thickness - depth) > deep)
      continue;
    const Wave wave = wave_at(mode, n.length, depth);
    const Complex pressure = spectrum_[mode];
    const double across = nu * (wave.stress_qq + wave.stress_zz);
    zz[mode] = wave.stress_zz * pressure;
    xx[mode] = (n.x * n.x * wave.stress_qq + n.y * n.y * across) * pressure;
    yy[mode] = (n.y * n.y * wave.stress_qq + n.x * n.x * across) * pressure;
    if (!n.has_sign)
      continue;
    xy[mode] = n.x * n.y * (wave.stress_qq - across) * pressure;
    const Complex shear = Complex(0.0, wave.stress_zq) * pressure;
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

std::vector<double> StressInside::von_mises_at(double depth) const {
  return von_mises(at_depth(depth));
}

StressPeak StressInside::strongest() const {
  const double spacing = std::min(grid_.spacing_x(), grid_.spacing_y());
  const double deepest = std::min(
      block_.thickness, 0.5 * std::max(grid_.length_x, grid_.length_y));
  const auto strength = [&](double depth) {
    const std::vector<double> map = von_mises_at(depth);
    return *std::max_element(map.begin(), map.end());
  };
  constexpr double ratio = 1.25;
  double best_depth = std::min(spacing, deepest);
  double best = 0.0;
  for (double depth = best_depth; depth <= deepest; depth *= ratio)
    if (const double here = strength(depth); here > best) {
      best = here;
      best_depth = depth;
    }
  // In units of the best plane's depth: the search's tolerance is absolute.
  const double low =
      std::max(1.0 / ratio, std::min(spacing, deepest) / best_depth);
  const double high = std::min(ratio, deepest / best_depth);
  constexpr int bits = 10;
  const auto [factor, lowest] = boost::math::tools::brent_find_minima(
      [&](double multiple) { return -strength(multiple * best_depth); }, low,
      high, bits);
  if (-lowest > best)
    best_depth *= factor;
  const std::vector<double> map = von_mises_at(best_depth);
  const auto peak = std::max_element(map.begin(), map.end());
  return {*peak, best_depth, static_cast<std::size_t>(peak - map.begin())};
}

} // namespace asperity::contact
