#include "fem/refined/box_flow.hpp"

namespace asperity::fem {
namespace {

constexpr std::size_t in_box = nodes_in_box;

/// Derivatives of the shape functions of the unit box at its Gauss points, by
/// point, axis and node.
using BoxSlopes = std::array<std::array<std::array<double, in_box>, 3>, in_box>;

constexpr BoxSlopes box_slopes() {
  constexpr double near = 0.788675134594812882; // (1 + 1/sqrt(3))/2
  BoxSlopes slopes{};
  for (std::size_t point = 0; point < in_box; ++point)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t node = 0; node < in_box; ++node) {
        double slope = 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
          const bool is_last = (node >> i & 1U) == 1;
          if (i == axis)
            slope *= is_last ? 1.0 : -1.0;
          else
            slope *= is_last == ((point >> i & 1U) == 1) ? near : 1.0 - near;
        }
        slopes[point][axis][node] = slope;
      }
  return slopes;
}

constexpr BoxSlopes unit_slopes = box_slopes();

using Gradient = std::array<std::array<double, 3>, 3>; ///< [component][axis]

/// Replaces a displacement gradient by `scale` times the stress of a tangent
/// (F.6).
void respond_to(Gradient& h, const PointTangent& tangent, double scale) {
  const auto& s = tangent.softening;
  std::array<double, 3> shear{};
  double product = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    shear[i] = h[j][k] + h[k][j];
    product += s[i] * h[i][i] + s[3 + i] * shear[i];
  }
  const double pressure = tangent.lame * (h[0][0] + h[1][1] + h[2][2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    h[i][i] =
        scale * (pressure + 2.0 * tangent.shear * h[i][i] - product * s[i]);
    h[j][k] = h[k][j] = scale * (tangent.shear * shear[i] - product * s[3 + i]);
  }
}

} // namespace

template <class Number>
void add_flow(const FlowingBox& box, const Number* displacement, Number* force,
              double factor) {
  std::array<std::array<double, in_box>, 3> u{}, sum{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t a = 0; a < in_box; ++a)
      u[c][a] = static_cast<double>(displacement[box.nodes[a] + c]);
  const auto& edges = box.edges;
  const double scale = factor * edges[0] * edges[1] * edges[2] / in_box;
  for (std::size_t point = 0; point < in_box; ++point) {
    Gradient h{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t m = 0; m < 3; ++m) {
        for (std::size_t a = 0; a < in_box; ++a)
          h[c][m] += unit_slopes[point][m][a] * u[c][a];
        h[c][m] /= edges[m];
      }
    respond_to(h, box.change[point], scale);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t m = 0; m < 3; ++m) {
        const double stress = h[c][m] / edges[m];
        for (std::size_t a = 0; a < in_box; ++a)
          sum[c][a] += unit_slopes[point][m][a] * stress;
      }
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t a = 0; a < in_box; ++a)
      force[box.nodes[a] + c] += static_cast<Number>(sum[c][a]);
}

template void add_flow(const FlowingBox&, const float*, float*, double);
template void add_flow(const FlowingBox&, const double*, double*, double);

} // namespace asperity::fem
