#include "surfaces/maps/levelling.hpp"

#include "surfaces/maps/round_form.hpp"

#include <numeric>
#include <stdexcept>
#include <vector>

#include "ranks/in_order.hpp"

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

void subtract(const Polynomials& polynomials, const TrendTerm& term, int first,
              std::span<double> heights) {
  const std::vector<double>& along_x = of_degree(polynomials.x, term.degree_x);
  const std::vector<double>& along_y = of_degree(polynomials.y, term.degree_y);
  const std::size_t columns = along_x.size();
  for (std::size_t row = 0; row < heights.size() / columns; ++row)
    for (std::size_t x = 0; x < columns; ++x)
      heights[row * columns + x] -=
          term.factor * along_x[x] *
          along_y[row + static_cast<std::size_t>(first)];
}

/// Projects the heights and subtracts the projections, one after another.
class TrendRemoval {
public:
  TrendRemoval(const SharedRows& rows, std::span<double> heights)
      : rows_(rows), heights_(heights), polynomials_(rows.grid()) {}

  void remove_product(int degree_x, int degree_y) {
    const std::vector<double>& along_x = of_degree(polynomials_.x, degree_x);
    const std::vector<double>& along_y = of_degree(polynomials_.y, degree_y);
    // A side of one or two points has no linear or quadratic form of its own;
    // the roundoff that remains of its polynomial must not be projected on.
    const double norm = sum_of_squares(along_x) * sum_of_squares(along_y);
    if (norm < 1e-20)
      return;
    const auto first = static_cast<std::size_t>(rows_.first());
    const double projection = in_order(&rows_, 0.0, [&](double& sum) {
      for (std::size_t row = 0; row < heights_.size() / along_x.size(); ++row)
        sum += along_y[first + row] *
               std::inner_product(along_x.begin(), along_x.end(),
                                  &heights_[row * along_x.size()], 0.0);
    });
    remove({projection / norm, degree_x, degree_y});
  }

  /// The second pass removes the roundoff of a large first mean.
  void remove_twice_the_mean() {
    for (int pass = 0; pass < 2; ++pass)
      remove({mean_height(rows_, heights_), 0, 0});
  }

  std::vector<TrendTerm> removed() const { return terms_; }

private:
  void remove(const TrendTerm& term) {
    subtract(polynomials_, term, rows_.first(), heights_);
    terms_.push_back(term);
  }

  const SharedRows& rows_;
  std::span<double> heights_;
  Polynomials polynomials_;
  std::vector<TrendTerm> terms_;
};

} // namespace

void remove_trend(HeightMap& map, mechanics::Levelling levelling) {
  if (levelling == mechanics::Levelling::sphere) {
    remove_mean(map);
    return remove_sphere(map);
  }
  if (levelling == mechanics::Levelling::cylinder) {
    remove_mean(map);
    return remove_cylinder(map);
  }
  remove_trend(SharedRows(map.grid), map.heights, levelling);
}

std::vector<TrendTerm> remove_trend(const SharedRows& rows,
                                    std::span<double> heights,
                                    mechanics::Levelling levelling) {
  if (levelling == mechanics::Levelling::sphere ||
      levelling == mechanics::Levelling::cylinder)
    throw std::domain_error("a sphere or a cylinder is fitted to a whole map");
  TrendRemoval trend(rows, heights);
  trend.remove_twice_the_mean();
  if (levelling == mechanics::Levelling::none)
    return trend.removed();
  trend.remove_product(1, 0);
  trend.remove_product(0, 1);
  if (levelling == mechanics::Levelling::bow) {
    trend.remove_product(2, 0);
    trend.remove_product(0, 2);
    trend.remove_product(1, 1);
  }
  trend.remove_twice_the_mean(); // roundoff that remains of a steep trend
  return trend.removed();
}

void subtract_trend(const Grid& grid, std::span<const TrendTerm> terms,
                    int first, std::span<double> heights) {
  const Polynomials polynomials(grid);
  for (const TrendTerm& term : terms)
    subtract(polynomials, term, first, heights);
}

} // namespace asperity::surfaces
