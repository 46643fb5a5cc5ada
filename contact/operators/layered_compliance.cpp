#include "contact/operators/layered_compliance.hpp"

#include "base/require.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Layers up to this q t use (L.7), thicker ones (L.6); at this value each of
/// the two loses at most one digit.
constexpr double thickest_by_transfer = 1.0;

/// Beyond this q t the effect of the bottom of a layer, 4 x^2 exp(-2 x), is
/// below roundoff.
constexpr double deep = 40.0;

/// Columns of displacements and tractions on a plane, in the units of a layer.
template <class Columns>
struct Plane {
  Columns displacement;
  Columns traction;
};

/// (U, T): the response of the material below a plane.
using Answer = Plane<Matrix2d>;

Matrix2d matrix(double a, double b, double c, double d) {
  Matrix2d result;
  result << a, b, c, d;
  return result;
}

/// H of (L.3). H' is obtained from 2 - k in place of k, which changes the sign
/// of 1 - k.
Matrix2d downward(const StackLayer& layer) {
  const double coupling = 1.0 - layer.lateral_ratio;
  return matrix(2.0, coupling, coupling, 2.0);
}

Matrix2d upward(const StackLayer& layer) {
  const double coupling = layer.lateral_ratio - 1.0;
  return matrix(2.0, coupling, coupling, 2.0);
}

/// D(x) of (L.4); its transpose is D'(x) of (L.5).
Matrix2d decay(double x) {
  if (x > 700.0) // exp(-x) underflows, and an infinite x would give a NaN
    return Matrix2d::Zero();
  return std::exp(-x) * matrix(1.0 - x, -x, x, 1.0 + x);
}

/// exp(-M x) of (L.7) applied to (v, w; s, n), |x| <= 1; x > 0 leads upwards.
/// With the double roots 1 and -1 it is c_0 - c_1 M + c_2 M^2 - c_3 M^3.
template <class Columns>
Plane<Columns> across_thin(double k, double x, const Plane<Columns>& from) {
  double c3 = 0.0; // (x cosh x - sinh x)/2, by its series
  double term = x;
  for (int n = 1; std::abs(term) > 1e-19 * std::abs(c3); ++n) {
    term *= x * x / (2 * n * (2 * n + 1));
    c3 += n * term;
  }
  const double c2 = 0.5 * x * std::sinh(x);
  const double c0 = std::cosh(x) - c2;
  const double c1 = std::sinh(x) - c3;
  const double along = c0 + (2.0 + k) * c2;
  const double down = c0 - k * c2;
  const double turn = c1 + (2.0 + k) * c3;
  const double shrink = k * c1 + (1.0 + 2.0 * k) * c3;
  const double bend = (1.0 + k) * (1.0 + k) * c2;
  const Matrix2d displacement_of_displacement =
      matrix(along, turn, -shrink, down);
  const Matrix2d displacement_of_traction =
      matrix((1.0 + k) * (2.0 * c1 + (3.0 + k) * c3), bend, -bend,
             (1.0 + k) * ((1.0 - k) * c1 - 2.0 * k * c3));
  const Matrix2d traction_of_displacement = matrix(c1 + 2.0 * c3, c2, -c2, -c3);
  const Matrix2d traction_of_traction = matrix(along, shrink, -turn, down);
  return {displacement_of_displacement * from.displacement +
              displacement_of_traction * from.traction,
          traction_of_displacement * from.displacement +
              traction_of_traction * from.traction};
}

/// Solution in one layer, for amplitudes c of the two columns at its top.
struct Crossing {
  Answer top;       ///< the columns at the top
  Matrix2d falling; ///< maps c to a at the top; thick layers only
  Matrix2d rising;  ///< maps c to b at the bottom; thick layers only
  Matrix2d descent; ///< maps c to the amplitudes of the columns at the bottom
};

/// Scales the columns at the top to order 1.
void normalise(Crossing& crossing) {
  Answer& top = crossing.top;
  const Matrix2d scale = (top.displacement + top.traction).inverse();
  top.displacement = top.displacement * scale;
  top.traction = top.traction * scale;
  crossing.falling = crossing.falling * scale;
  crossing.rising = crossing.rising * scale;
  crossing.descent = crossing.descent * scale;
}

Crossing across_thick(const StackLayer& layer, double wavevector,
                      const Answer& bottom) {
  const Matrix2d down = downward(layer);
  const Matrix2d up = upward(layer);
  const Matrix2d fall = decay(wavevector * layer.thickness);
  const Matrix2d arriving =
      (bottom.displacement + up * bottom.traction).inverse();
  const Matrix2d reflected =
      (bottom.displacement - down * bottom.traction) * arriving * fall;
  const Matrix2d returning = fall.transpose() * reflected; // Q of (L.6)
  return {{down + up * returning, Matrix2d::Identity() - returning},
          Matrix2d::Identity(),
          reflected,
          4.0 * arriving * fall};
}

Crossing across(const StackLayer& layer, double wavevector,
                const Answer& bottom) {
  const double x = wavevector * layer.thickness;
  Crossing crossing;
  if (x <= thickest_by_transfer)
    crossing = {across_thin(layer.lateral_ratio, x, bottom), Matrix2d::Zero(),
                Matrix2d::Zero(), Matrix2d::Identity()};
  else
    crossing = across_thick(layer, wavevector, bottom);
  normalise(crossing);
  return crossing;
}

/// (U, T) on the far boundary.
Answer far_answer(mechanics::FarBoundary far_boundary) {
  switch (far_boundary) {
  case mechanics::FarBoundary::sliding:
    return {matrix(1.0, 0.0, 0.0, 0.0), matrix(0.0, 0.0, 0.0, 1.0)};
  case mechanics::FarBoundary::pressure:
    return {Matrix2d::Identity(), Matrix2d::Zero()};
  case mechanics::FarBoundary::clamped:
    break;
  }
  return {Matrix2d::Zero(), Matrix2d::Identity()};
}

/// Visits the layers that affect the surface, from the lowest upwards, with
/// (U, T) at the bottom of each. Returns what visit() returned for the first
/// layer.
template <class Visit>
Answer climb(std::span<const StackLayer> layers,
             mechanics::FarBoundary far_boundary, double wavevector,
             const Visit& visit) {
  const auto deep_layer =
      std::find_if(layers.begin(), layers.end(), [&](const StackLayer& layer) {
        return wavevector * layer.thickness > deep;
      });
  Answer answer = far_answer(far_boundary);
  std::size_t above = layers.size();
  if (deep_layer != layers.end()) {
    // This layer acts as a half-space: no mode is reflected from its bottom,
    // and D(x) = 0 removes the layers below it.
    answer = {downward(*deep_layer), Matrix2d::Identity()};
    above = static_cast<std::size_t>(deep_layer - layers.begin()) + 1;
  }
  for (std::size_t i = above; i-- > 0;) {
    answer = visit(i, answer);
    if (i > 0)
      answer.displacement *=
          layers[i - 1].contact_modulus / layers[i].contact_modulus;
  }
  return answer;
}

/// Amplitudes of the columns at the surface that give zero shear traction and
/// unit pressure.
Vector2d under_pressure(const Answer& face) {
  return face.traction.inverse().col(1);
}

void require_layer(double thickness, double modulus, double poisson_ratio) {
  if (!(thickness > 0.0))
    refuse_argument("thickness", thickness, "> 0 [m]");
  require_positive("modulus", modulus, "Pa");
  if (!(poisson_ratio > -1.0 && poisson_ratio <= 0.5))
    refuse_argument("poisson_ratio", poisson_ratio, "> -1 and <= 0.5");
}

} // namespace

LayerStack::LayerStack(const mechanics::ElasticBlock& block)
    : thickness_(block.thickness), far_face_(block.far_boundary) {
  double depth = 0.0;
  const auto add = [&](double thickness, double contact_modulus, double nu) {
    require_layer(thickness, contact_modulus, nu);
    layers_.push_back({depth, thickness, contact_modulus, nu, nu / (1.0 - nu)});
    depth += thickness;
  };
  for (const mechanics::BondedLayer& layer : block.layers) {
    require_positive("thickness", layer.thickness, "m");
    add(layer.thickness,
        layer.youngs_modulus /
            (1.0 - layer.poisson_ratio * layer.poisson_ratio),
        layer.poisson_ratio);
  }
  if (!(block.thickness > depth))
    refuse_argument("thickness", block.thickness,
                    "above the total thickness of the layers, " +
                        std::to_string(depth) + " m");
  add(block.thickness - depth, block.contact_modulus, block.poisson_ratio);
}

double LayerStack::compliance(double wavevector) const {
  const Answer face = climb(layers_, far_face_, wavevector,
                            [&](std::size_t i, const Answer& bottom) {
                              return across(layers_[i], wavevector, bottom).top;
                            });
  const Vector2d displacement = face.displacement * under_pressure(face);
  return displacement(1) / (layers_[0].contact_modulus * wavevector); // (L.8)
}

void LayerStack::find_waves(double wavevector, std::span<Wave> waves) const {
  std::vector<Crossing> crossings(layers_.size());
  std::size_t n_reached = 0;
  const Answer face = climb(
      layers_, far_face_, wavevector, [&](std::size_t i, const Answer& bottom) {
        n_reached = std::max(n_reached, i + 1);
        crossings[i] = across(layers_[i], wavevector, bottom);
        return crossings[i].top;
      });
  std::fill(waves.begin(), waves.end(), Wave{});
  Vector2d amplitudes = under_pressure(face);
  for (std::size_t i = 0; i < n_reached; ++i) {
    const Crossing& crossing = crossings[i];
    const bool is_thin =
        wavevector * layers_[i].thickness <= thickest_by_transfer;
    const Vector2d first =
        (is_thin ? crossing.top.displacement : crossing.falling) * amplitudes;
    const Vector2d second =
        (is_thin ? crossing.top.traction : crossing.rising) * amplitudes;
    waves[i] = {first(0), first(1), second(0), second(1)};
    amplitudes = crossing.descent * amplitudes;
  }
}

LayerStack::Stress LayerStack::stress(std::size_t index, const Wave& wave,
                                      double wavevector, double depth) const {
  const StackLayer& layer = layers_[index];
  const Vector2d first(wave[0], wave[1]);
  const Vector2d second(wave[2], wave[3]);
  const double below_top = wavevector * (depth - layer.top);
  Vector2d displacement = first;
  Vector2d traction = second;
  if (wavevector * layer.thickness <= thickest_by_transfer) {
    const Plane<Vector2d> here =
        across_thin<Vector2d>(layer.lateral_ratio, -below_top, {first, second});
    displacement = here.displacement;
    traction = here.traction;
  } else {
    const Vector2d falling = decay(below_top) * first; // (L.4)
    const Vector2d rising =
        decay(wavevector * layer.thickness - below_top).transpose() *
        second; // (L.5)
    displacement = downward(layer) * falling + upward(layer) * rising;
    traction = falling - rising;
  }
  const double zz = -traction(1);
  const double qq = -displacement(0) - layer.lateral_ratio * traction(1);
  return {zz, qq, -traction(0), layer.poisson_ratio * (qq + zz)};
}

double layered_compliance(double wavevector,
                          const mechanics::ElasticBlock& block) {
  require_positive("wavevector", wavevector, "rad/m");
  return LayerStack(block).compliance(wavevector);
}

} // namespace asperity::contact
