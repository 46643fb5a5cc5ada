#include "contact/operators/free_halfspace.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::contact {
namespace {

/// Distance of the centre of a rectangle, in its longer sides, from which its
/// moments are used. The sum over corners is of the order of the distance r,
/// so that differences lose digits as eps r^2/(side_x side_y); the moments that
/// are left out are 2e-3 (side/r)^6 of the integral.
constexpr double far_sides = 64.0;

bool is_far(double x, double y, double side_x, double side_y) {
  const double far = far_sides * std::max(side_x, side_y);
  return x * x + y * y > far * far;
}

/// The integral of 1/r over a rectangle by its corners: the double integral of
/// 1/r is x asinh(y/|x|) + y asinh(x/|y|).
double integral_by_corners(double x, double y, double side_x, double side_y) {
  const auto term = [](double a, double b) {
    return a == 0.0 ? 0.0 : a * std::asinh(b / std::abs(a));
  };
  const auto corner = [&](double a, double b) {
    return term(a, b) + term(b, a);
  };
  const double east = x + 0.5 * side_x;
  const double west = x - 0.5 * side_x;
  const double north = y + 0.5 * side_y;
  const double south = y - 0.5 * side_y;
  return corner(east, north) - corner(west, north) - corner(east, south) +
         corner(west, south);
}

/// The same by the moments of the rectangle up to the fourth order:
///
///     side_x side_y [1 + sx^2 d_xx/24 + sy^2 d_yy/24 + sx^4 d_xxxx/1920
///                    + sx^2 sy^2 d_xxyy/576 + sy^4 d_yyyy/1920] 1/r
double integral_by_moments(double x, double y, double side_x, double side_y) {
  const double square = x * x + y * y;
  // Squares of the sides, and of the cosines of the direction, over r^2.
  const double sx = side_x * side_x / square, sy = side_y * side_y / square;
  const double cx = x * x / square, cy = y * y / square;
  const auto fourth = [](double c) {
    return (9.0 - 90.0 * c + 105.0 * c * c) / 1920.0;
  };
  const double second = (sx * (3.0 * cx - 1.0) + sy * (3.0 * cy - 1.0)) / 24.0;
  return side_x * side_y *
         (1.0 + second + sx * sx * fourth(cx) + sy * sy * fourth(cy) +
          sx * sy * (105.0 * cx * cy - 12.0) / 576.0) /
         std::sqrt(square);
}

} // namespace

double rectangle_displacement(double x, double y, double side_x, double side_y,
                              double contact_modulus) {
  require_positive("side_x", side_x, "m");
  require_positive("side_y", side_y, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  return (is_far(x, y, side_x, side_y)
              ? integral_by_moments(x, y, side_x, side_y)
              : integral_by_corners(x, y, side_x, side_y)) /
         (std::numbers::pi * contact_modulus);
}

EvenSymbol::KernelRow rectangle_kernel(const Grid& wide,
                                       double contact_modulus) {
  return [=](int iy, std::span<double> of_ix) {
    for (std::size_t ix = 0; ix < of_ix.size(); ++ix)
      of_ix[ix] = rectangle_displacement(
          static_cast<double>(ix) * wide.spacing_x(), iy * wide.spacing_y(),
          wide.spacing_x(), wide.spacing_y(), contact_modulus);
  };
}

FourierOperator free_halfspace(const Grid& grid, double contact_modulus,
                               int threads) {
  return FourierOperator(
      grid,
      [=](const Grid& wide) { return rectangle_kernel(wide, contact_modulus); },
      threads);
}

} // namespace asperity::contact
