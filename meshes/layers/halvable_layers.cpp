#include "meshes/layers/halvable_layers.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::meshes {
namespace {

/// Distance of interfaces over the edge above which layers of their own are
/// nearly cubes: between sqrt(1/2) and sqrt(2), rounded.
constexpr double nearly_cubic = 0.7;

/// Roundoff of sums of depths, relative to the depth of the block.
constexpr double same_depth = 1e-12;

/// Whether the interfaces inside of the layer are planes of its halved cells.
bool divides(double top, double thickness, int halvings,
             std::span<const double> boundaries, double tolerance) {
  const double finest = std::ldexp(thickness, -halvings);
  return std::ranges::all_of(boundaries, [&](double boundary) {
    if (boundary < top + tolerance || boundary > top + thickness - tolerance)
      return true;
    const double planes = (boundary - top) / finest;
    return std::abs(planes - std::round(planes)) * finest < tolerance;
  });
}

/// The thickness of a layer at `top` of which the distance to the next boundary
/// is a fraction 1/2^m.
double layer_with_fraction(double top, double edge, int halvings,
                           std::span<const double> boundaries,
                           double tolerance) {
  const double distance = boundaries.front() - top;
  const double bottom = boundaries.back();
  const int wanted = std::clamp(
      static_cast<int>(std::ceil(std::log2(nearly_cubic * edge / distance))), 0,
      halvings);
  for (int m = wanted; m > 0; --m) {
    const double thickness = std::ldexp(distance, m);
    const double end = top + thickness;
    if (end > bottom + tolerance ||
        !divides(top, thickness, halvings, boundaries, tolerance))
      continue;
    // What remains up to the next boundary must not be a sliver.
    const auto next = std::ranges::find_if(boundaries, [&](double boundary) {
      return boundary > end - tolerance;
    });
    const double rest = next == boundaries.end() ? 0.0 : *next - end;
    if (rest < tolerance || rest > 0.5 * distance)
      return thickness;
  }
  return distance;
}

} // namespace

std::vector<double> halvable_layers(double edge, int halvings,
                                    std::span<const double> interfaces,
                                    double depth) {
  require_positive("edge", edge, "m");
  require_positive("depth", depth, "m");
  require_between("halvings", halvings, 0, 12, "1");
  require_between(Argument{"ratio of depth to cell edge", "method.depth"},
                  depth / edge, 0.0, 1e6, "1");
  std::vector<double> boundaries(interfaces.begin(), interfaces.end());
  boundaries.push_back(depth);
  double above = 0.0;
  for (const double boundary : boundaries) {
    if (!(boundary > above))
      refuse_argument(Argument{"interface between layers", "material.layers"},
                      boundary, "increasing, > 0 and less than the depth [m]");
    above = boundary;
  }

  const double tolerance = same_depth * depth;
  std::vector<double> thicknesses;
  std::span<const double> below = boundaries;
  double top = 0.0;
  while (!below.empty()) {
    const double distance = below.front() - top;
    if (distance < nearly_cubic * edge) {
      thicknesses.push_back(
          layer_with_fraction(top, edge, halvings, below, tolerance));
      top += thicknesses.back();
    } else {
      const double layers = std::max(1.0, std::round(distance / edge));
      thicknesses.insert(thicknesses.end(), static_cast<std::size_t>(layers),
                         distance / layers);
      top = below.front();
    }
    while (!below.empty() && below.front() < top + tolerance)
      below = below.subspan(1);
  }
  return thicknesses;
}

} // namespace asperity::meshes
