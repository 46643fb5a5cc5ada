#include "surfaces/maps/levelling.hpp"

#include "surfaces/maps/round_form.hpp"

#include <numeric>
#include <vector>

namespace asperity::surfaces {
namespace {

/// The discrete Legendre polynomials of degree 0, 1, 2 on n points.
struct SidePolynomials {
  std::vector<double> constant, linear, quadratic;

  explicit SidePolynomials(int points)
      : constant(static_cast<std::size_t>(points), 1.0) {
    double mean_square = 0.0;
    for (int i = 0; i < points; ++i) {
      const double x =
          points == 1 ? 0.0 : (2.0 * i - (points - 1)) / (points - 1);
      linear.push_back(x);
      quadratic.push_back(x * x);
      mean_square += x * x / points;
    }
    for (double& square : quadratic)
      square -= mean_square;
  }
};

double sum_of_squares(const std::vector<double>& side) {
  return std::inner_product(side.begin(), side.end(), side.begin(), 0.0);
}

void remove_product(HeightMap& map, const std::vector<double>& along_x,
                    const std::vector<double>& along_y) {
  // A side of one or two points has no linear or quadratic form of its own; the
  // roundoff that remains of its polynomial must not be projected on.
  const double norm = sum_of_squares(along_x) * sum_of_squares(along_y);
  if (norm < 1e-20)
    return;
  const auto columns = static_cast<std::size_t>(map.grid.points_x);
  double projection = 0.0;
  for (std::size_t y = 0; y < along_y.size(); ++y)
    projection +=
        along_y[y] * std::inner_product(along_x.begin(), along_x.end(),
                                        &map.heights[y * columns], 0.0);
  for (std::size_t y = 0; y < along_y.size(); ++y)
    for (std::size_t x = 0; x < columns; ++x)
      map.heights[y * columns + x] -=
          projection / norm * along_x[x] * along_y[y];
}

} // namespace

void remove_trend(HeightMap& map, mechanics::Levelling levelling) {
  remove_mean(map);
  if (levelling == mechanics::Levelling::none)
    return;
  if (levelling == mechanics::Levelling::sphere)
    return remove_sphere(map);
  if (levelling == mechanics::Levelling::cylinder)
    return remove_cylinder(map);
  const SidePolynomials x(map.grid.points_x);
  const SidePolynomials y(map.grid.points_y);
  remove_product(map, x.linear, y.constant);
  remove_product(map, x.constant, y.linear);
  if (levelling == mechanics::Levelling::bow) {
    remove_product(map, x.quadratic, y.constant);
    remove_product(map, x.constant, y.quadratic);
    remove_product(map, x.linear, y.linear);
  }
  remove_mean(map); // roundoff that remains of a steep trend
}

} // namespace asperity::surfaces
