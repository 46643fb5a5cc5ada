#include "surfaces/maps/round_form.hpp"

#include "base/symmetric_eigen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity::surfaces {
namespace {

/// Height and its derivatives by the n parameters, at a point.
template <int n>
struct FormValue {
  double height = 0.0;
  std::array<double, n> by_parameter{};
};

/// A surface over the plane, with lengths in units of the map's larger half
/// side. A value that is not finite is outside the form.
template <int n>
using RoundForm = FormValue<n> (*)(const Eigen::VectorXd& parameters, double x,
                                   double y);

/// The circle z = 2 C / (1 + sqrt(1 - 2 k C)) and 1/(1 - k z) = dz/dC.
struct CircleValue {
  double height;
  double by_offset;
};

CircleValue circle(double curvature, double offset) {
  const double root = std::sqrt(1.0 - 2.0 * curvature * offset);
  return {2.0 * offset / (1.0 + root), 1.0 / root};
}

/// Parameters k, p, q, d.
FormValue<4> sphere_value(const Eigen::VectorXd& at, double x, double y) {
  const double square = x * x + y * y;
  const auto [z, slope] =
      circle(at[0], 0.5 * at[0] * square - at[1] * x - at[2] * y + at[3]);
  return {z, {0.5 * (square + z * z) * slope, -x * slope, -y * slope, slope}};
}

/// Parameters k, p, d, b, phi.
FormValue<5> cylinder_value(const Eigen::VectorXd& at, double x, double y) {
  const double along = x * std::cos(at[4]) + y * std::sin(at[4]);
  const double across = y * std::cos(at[4]) - x * std::sin(at[4]);
  const auto [z, slope] =
      circle(at[0], 0.5 * at[0] * across * across - at[1] * across + at[2]);
  const double by_across = (at[0] * across - at[1]) * slope;
  return {z + at[3] * along,
          {0.5 * (across * across + z * z) * slope, -across * slope, slope,
           along, at[3] * across - by_across * along}};
}

/// Heights and positions of a map, in units of its larger half side. All sums
/// are over the rows in their order.
template <int n>
class RoundFit {
public:
  RoundFit(HeightMap& map, RoundForm<n> form)
      : map_(map),
        form_(form),
        unit_(0.5 * std::max(map.grid.length_x, map.grid.length_y)) {
    remove_mean(map_);
    for (double& height : map_.heights)
      height /= unit_;
  }

  /// Coefficients of 1, x, y, x^2, x y, y^2 of the least-squares form.
  Eigen::VectorXd second_order() const {
    return least_squares<6>([](double x, double y, double height) {
      return std::pair(std::array{1.0, x, y, x * x, x * y, y * y}, height);
    });
  }

  /// Improves the parameters and subtracts the form. A step that leaves the
  /// form or increases the deviation is halved.
  void subtract(Eigen::VectorXd parameters, const char* name) {
    double deviation = mean_square(parameters);
    // A paraboloid may be too curved for a circle over the whole map.
    for (int halving = 0; halving < 60 && !std::isfinite(deviation);
         ++halving) {
      parameters[0] *= 0.5;
      deviation = mean_square(parameters);
    }
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
      Eigen::VectorXd change = gauss_newton_step(parameters);
      double next = mean_square(parameters + change);
      for (int halving = 0; halving < 40 && !(next <= deviation); ++halving) {
        change *= 0.5;
        next = mean_square(parameters + change);
      }
      if (!(next <= deviation))
        break; // no smaller deviation: roundoff, or never inside the form
      parameters += change;
      const bool is_done = deviation - next <= 1e-15 * deviation;
      deviation = next;
      if (is_done)
        break;
    }
    if (!std::isfinite(deviation))
      throw std::domain_error(std::string("no ") + name +
                              " reaches over the whole map");
    for (int row = 0; row < map_.grid.points_y; ++row)
      for_each(row, [&](double x, double y, double& height) {
        height = (height - form_(parameters, x, y).height) * unit_;
      });
    remove_mean(map_);
  }

private:
  /// Calls work(x, y, height) for the points of a row.
  template <class Work>
  void for_each(int row, Work work) const {
    const Grid& grid = map_.grid;
    const double y =
        (row - 0.5 * (grid.points_y - 1)) * grid.spacing_y() / unit_;
    for (int ix = 0; ix < grid.points_x; ++ix)
      work((ix - 0.5 * (grid.points_x - 1)) * grid.spacing_x() / unit_, y,
           map_.heights[grid.index(ix, row)]);
  }

  double mean_square(const Eigen::VectorXd& parameters) const {
    double sum = 0.0;
    for (int row = 0; row < map_.grid.points_y; ++row) {
      double of_row = 0.0;
      for_each(row, [&](double x, double y, double height) {
        const double left = height - form_(parameters, x, y).height;
        of_row += left * left;
      });
      sum += of_row;
    }
    return sum / static_cast<double>(map_.grid.size());
  }

  Eigen::VectorXd gauss_newton_step(const Eigen::VectorXd& parameters) const {
    return least_squares<n>([&](double x, double y, double height) {
      const FormValue<n> value = form_(parameters, x, y);
      return std::pair(value.by_parameter, height - value.height);
    });
  }

  /// Solves the normal equations of m functions.
  /// @param at  at(x, y, height) returns the functions and what they fit
  template <int m, class At>
  Eigen::VectorXd least_squares(const At& at) const {
    using Equations = Eigen::Matrix<double, m, m + 1, Eigen::RowMajor>;
    Equations equations = Equations::Zero();
    for (int row = 0; row < map_.grid.points_y; ++row) {
      Equations of_row = Equations::Zero();
      for_each(row, [&](double x, double y, double height) {
        const auto [functions, fitted] = at(x, y, height);
        double* sum = of_row.data();
        for (const double function : functions) {
          for (const double other : functions)
            *sum++ += function * other;
          *sum++ += function * fitted;
        }
      });
      equations += of_row;
    }
    return symmetric_eigen(equations.template leftCols<m>())
        .solve(equations.col(m));
  }

  HeightMap& map_;
  RoundForm<n> form_;
  double unit_; ///< [m]
};

} // namespace

void remove_sphere(HeightMap& map) {
  RoundFit<4> fit(map, sphere_value);
  const Eigen::VectorXd start = fit.second_order();
  Eigen::VectorXd parameters(4);
  parameters << start[3] + start[5], -start[1], -start[2], start[0];
  fit.subtract(parameters, "sphere");
}

void remove_cylinder(HeightMap& map) {
  RoundFit<5> fit(map, cylinder_value);
  const Eigen::VectorXd start = fit.second_order();
  // The axis is the direction of the smaller curvature.
  Eigen::Matrix2d curvature;
  curvature << 2.0 * start[3], start[4], start[4], 2.0 * start[5];
  const SymmetricEigen principal = symmetric_eigen(curvature);
  const int axis =
      std::abs(principal.values[0]) < std::abs(principal.values[1]) ? 0 : 1;
  const Eigen::Vector2d along = principal.vectors.col(axis);
  const Eigen::Vector2d across(-along[1], along[0]);
  const Eigen::Vector2d slope(start[1], start[2]);
  Eigen::VectorXd parameters(5);
  parameters << principal.values[1 - axis], -slope.dot(across), start[0],
      slope.dot(along), std::atan2(along[1], along[0]);
  fit.subtract(parameters, "cylinder");
}

} // namespace asperity::surfaces
