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

/// The polynomials of both sides of a grid.
struct Polynomials {
  SidePolynomials x, y;

  explicit Polynomials(const Grid& grid) : x(grid.points_x), y(grid.points_y) {}
};

const std::vector<double>& of_degree(const SidePolynomials& side, int degree) {
  return degree == 0 ? side.constant
                     : (degree == 1 ? side.linear : side.quadratic);
}

double sum_of_squares(const std::vector<double>& side) {
  return std::inner_product(side.begin(), side.end(), side.begin(), 0.0);
}

/// Projects the heights and subtracts the projections, one after another.
class TrendRemoval {
public:
  explicit TrendRemoval(HeightMap& map)
      : heights_(map.heights), polynomials_(map.grid) {}

  void remove_product(int degree_x, int degree_y) {
    const std::vector<double>& along_x = of_degree(polynomials_.x, degree_x);
    const std::vector<double>& along_y = of_degree(polynomials_.y, degree_y);
    // A side of one or two points has no linear or quadratic form of its own;
    // the roundoff that remains of its polynomial must not be projected on.
    const double norm = sum_of_squares(along_x) * sum_of_squares(along_y);
    if (norm < 1e-20)
      return;
    double projection = 0.0;
    for (std::size_t row = 0; row < along_y.size(); ++row)
      projection += along_y[row] *
                    std::inner_product(along_x.begin(), along_x.end(),
                                       &heights_[row * along_x.size()], 0.0);
    for (std::size_t row = 0; row < along_y.size(); ++row)
      for (std::size_t x = 0; x < along_x.size(); ++x)
        heights_[row * along_x.size() + x] -=
            projection / norm * along_x[x] * along_y[row];
  }

private:
  std::vector<double>& heights_;
  Polynomials polynomials_;
};

} // namespace

void remove_trend(HeightMap& map, mechanics::Levelling levelling) {
  remove_mean(map);
  if (levelling == mechanics::Levelling::none)
    return;
  if (levelling == mechanics::Levelling::sphere)
    return remove_sphere(map);
  if (levelling == mechanics::Levelling::cylinder)
    return remove_cylinder(map);
  TrendRemoval trend(map);
  trend.remove_product(1, 0);
  trend.remove_product(0, 1);
  if (levelling == mechanics::Levelling::bow) {
    trend.remove_product(2, 0);
    trend.remove_product(0, 2);
    trend.remove_product(1, 1);
  }
  remove_mean(map); // roundoff that remains of a steep trend
}

} // namespace asperity::surfaces
