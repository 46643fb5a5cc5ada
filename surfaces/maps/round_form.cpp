#include "surfaces/maps/round_form.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace asperity::surfaces {
namespace {

/// Height and its derivatives by the parameters, at a point.
struct FormValue {
  double height = 0.0;
  std::array<double, 5> by_parameter{}; ///< the first n_parameters are used
};

/// A surface over the plane, with lengths in units of the map's larger half
/// side. A value that is not finite is outside the form.
struct RoundForm {
  int n_parameters = 0;
  FormValue (*value)(const Eigen::VectorXd& parameters, double x, double y);
};

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
FormValue sphere_value(const Eigen::VectorXd& at, double x, double y) {
  const double square = x * x + y * y;
  const auto [z, slope] =
      circle(at[0], 0.5 * at[0] * square - at[1] * x - at[2] * y + at[3]);
  return {z, {0.5 * (square + z * z) * slope, -x * slope, -y * slope, slope}};
}

/// Parameters k, p, d, b, phi.
FormValue cylinder_value(const Eigen::VectorXd& at, double x, double y) {
  const double along = x * std::cos(at[4]) + y * std::sin(at[4]);
  const double across = y * std::cos(at[4]) - x * std::sin(at[4]);
  const auto [z, slope] =
      circle(at[0], 0.5 * at[0] * across * across - at[1] * across + at[2]);
  const double by_across = (at[0] * across - at[1]) * slope;
  return {z + at[3] * along,
          {0.5 * (across * across + z * z) * slope, -across * slope, slope,
           along, at[3] * across - by_across * along}};
}

/// Heights and positions of a map, in units of its larger half side.
class RoundFit {
public:
  RoundFit(HeightMap& map, const RoundForm& form)
      : map_(map),
        form_(form),
        unit_(0.5 * std::max(map.grid.length_x, map.grid.length_y)) {}

  /// Coefficients of 1, x, y, x^2, x y, y^2 of the least-squares form.
  Eigen::VectorXd second_order() const {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6);
    for_each([&](double x, double y, double& height) {
      Eigen::Matrix<double, 6, 1> basis;
      basis << 1.0, x, y, x * x, x * y, y * y;
      normal += basis * basis.transpose();
      right += basis * height;
    });
    return normal.completeOrthogonalDecomposition().solve(right);
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
    for_each([&](double x, double y, double& height) {
      height -= form_.value(parameters, x, y).height;
    });
    for (double& height : map_.heights)
      height *= unit_;
    remove_mean(map_);
  }

  /// Divides the heights by the unit, in which the fit works.
  void scale() {
    remove_mean(map_);
    for (double& height : map_.heights)
      height /= unit_;
  }

private:
  template <class Work>
  void for_each(Work work) const {
    const Grid& grid = map_.grid;
    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix)
        work((ix - 0.5 * (grid.points_x - 1)) * grid.spacing_x() / unit_,
             (iy - 0.5 * (grid.points_y - 1)) * grid.spacing_y() / unit_,
             map_.heights[grid.index(ix, iy)]);
  }

  double mean_square(const Eigen::VectorXd& parameters) const {
    double sum = 0.0;
    for_each([&](double x, double y, double& height) {
      const double left = height - form_.value(parameters, x, y).height;
      sum += left * left;
    });
    return sum / static_cast<double>(map_.heights.size());
  }

  Eigen::VectorXd gauss_newton_step(const Eigen::VectorXd& parameters) const {
    const int n = form_.n_parameters;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for_each([&](double x, double y, double& height) {
      const FormValue value = form_.value(parameters, x, y);
      const Eigen::Map<const Eigen::VectorXd> slope(value.by_parameter.data(),
                                                    n);
      normal.noalias() += slope * slope.transpose();
      right.noalias() += slope * (height - value.height);
    });
    return normal.completeOrthogonalDecomposition().solve(right);
  }

  HeightMap& map_;
  RoundForm form_;
  double unit_; ///< [m]
};

} // namespace

void remove_sphere(HeightMap& map) {
  RoundFit fit(map, {4, sphere_value});
  fit.scale();
  const Eigen::VectorXd start = fit.second_order();
  Eigen::VectorXd parameters(4);
  parameters << start[3] + start[5], -start[1], -start[2], start[0];
  fit.subtract(parameters, "sphere");
}

void remove_cylinder(HeightMap& map) {
  RoundFit fit(map, {5, cylinder_value});
  fit.scale();
  const Eigen::VectorXd start = fit.second_order();
  // The axis is the direction of the smaller curvature.
  Eigen::Matrix2d curvature;
  curvature << 2.0 * start[3], start[4], start[4], 2.0 * start[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(curvature);
  const int axis = std::abs(principal.eigenvalues()[0]) <
                           std::abs(principal.eigenvalues()[1])
                       ? 0
                       : 1;
  const Eigen::Vector2d along = principal.eigenvectors().col(axis);
  const Eigen::Vector2d across(-along[1], along[0]);
  const Eigen::Vector2d slope(start[1], start[2]);
  Eigen::VectorXd parameters(5);
  parameters << principal.eigenvalues()[1 - axis], -slope.dot(across), start[0],
      slope.dot(along), std::atan2(along[1], along[0]);
  fit.subtract(parameters, "cylinder");
}

} // namespace asperity::surfaces
