#include "meshes/layers/graded_layers.hpp"

#include "base/refused_argument.hpp"
#include "base/require.hpp"

#include <numeric>

namespace asperity::meshes {
namespace {

constexpr int most_layers = 100000;

/// Computes 1 + g + ... + g^(n-1).
double geometric_sum(double growth, int n_layers) {
  double sum = 0.0;
  for (int i = 0; i < n_layers; ++i)
    sum = sum * growth + 1.0;
  return sum;
}

/// The smallest n with geometric_sum(growth, n) >= ratio, with a tolerance for
/// roundoff.
int layers_needed(double growth, double ratio) {
  int n_layers = 0;
  double sum = 0.0;
  double term = 1.0;
  while (sum < ratio * (1.0 - 1e-12) && n_layers <= most_layers) {
    sum += term;
    term *= growth;
    ++n_layers;
  }
  return n_layers;
}

/// The grading ratio in [0, highest] that solves (M.1), by bisection; the sum
/// increases with it.
double fitted_growth(double highest, int n_layers, double ratio) {
  double low = 0.0;
  double high = highest;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high)
      break;
    (geometric_sum(middle, n_layers) < ratio ? low : high) = middle;
  }
  return high;
}

/// Adds the layers of (M.2), the first of them at most `thickest`, that fill
/// the block from the end of `thickness`, at `top`, down to `bottom`.
void fill(double thickest, double growth, double top, double bottom,
          std::vector<double>& thickness) {
  const double distance = bottom - top;
  const int n_layers = layers_needed(growth, distance / thickest);
  if (n_layers > most_layers)
    refuse_argument("depth", bottom, "reachable with 100000 layers");
  double next = distance / geometric_sum(growth, n_layers);
  double end = top;
  for (int i = 0; i + 1 < n_layers; ++i) {
    thickness.push_back(next);
    end += next;
    next *= growth;
  }
  thickness.push_back(bottom - end);
}

} // namespace

std::vector<double> graded_layers(double surface_thickness, double growth,
                                  double depth) {
  require_positive(Argument{"surface_thickness", "method.surface_cell_depth"},
                   surface_thickness, "m");
  require_between("growth", growth, 1.0, 10.0, "1");
  require_positive("depth", depth, "m");
  const double ratio = depth / surface_thickness;
  if (ratio < 1.0 - 1e-12)
    refuse_argument("depth", depth,
                    "at least the thickness of the surface layer, " +
                        number_text(surface_thickness) + " m");
  const int n_layers = layers_needed(growth, ratio);
  if (n_layers > most_layers)
    refuse_argument("depth", depth, "reachable with 100000 layers");
  if (n_layers == 1)
    return {depth};
  if (ratio < 1.5)
    refuse_argument(
        "depth", depth,
        "either one or at least 1.5 thicknesses of the surface layer, " +
            number_text(1.5 * surface_thickness) + " m");

  const double fitted = fitted_growth(growth, n_layers, ratio);
  std::vector<double> thickness(static_cast<std::size_t>(n_layers));
  double next = surface_thickness;
  for (double& layer : thickness) {
    layer = next;
    next *= fitted;
  }
  const double all_but_last =
      std::accumulate(thickness.begin(), thickness.end() - 1, 0.0);
  thickness.back() = depth - all_but_last;
  return thickness;
}

std::vector<double>
graded_layers_with_interfaces(double surface_thickness, double growth,
                              std::span<const double> interfaces,
                              double depth) {
  if (interfaces.empty())
    return graded_layers(surface_thickness, growth, depth);
  require_positive(Argument{"surface_thickness", "method.surface_cell_depth"},
                   surface_thickness, "m");
  require_between("growth", growth, 1.0, 10.0, "1");
  require_positive("depth", depth, "m");
  std::vector<double> bottoms(interfaces.begin(), interfaces.end());
  bottoms.push_back(depth);
  std::vector<double> thickness;
  double top = 0.0;
  for (const double bottom : bottoms) {
    if (!(bottom > top && bottom <= depth))
      refuse_argument(Argument{"interfaces", "material.layers"}, bottom,
                      "above 0, deeper than the previous interface and "
                      "shallower than the block, " +
                          number_text(depth) + " m");
    if (top == 0.0 && bottom >= 1.5 * surface_thickness)
      thickness = graded_layers(surface_thickness, growth, bottom);
    else if (top == 0.0)
      fill(surface_thickness, 1.0, top, bottom, thickness);
    else
      fill(growth * thickness.back(), growth, top, bottom, thickness);
    top = bottom;
  }
  return thickness;
}

std::vector<double> layers_of_block(const mechanics::BlockSettings& settings,
                                    std::span<const double> interfaces,
                                    double spacing, double depth) {
  return graded_layers_with_interfaces(
      settings.surface_cell_depth * degree_of(settings.element) * spacing,
      settings.growth, interfaces, depth);
}

} // namespace asperity::meshes
