#include "contact/operators/free_halfspace.hpp"

#include "base/require.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity::contact {
namespace {

/// Points per side of a coarse grid, at least.
constexpr int least_coarse_points = 32;

/// The points of the wide grid along a line of n: a quarter more, which was as
/// good as twice as many, see docs/numerics/solver.md. The wide
/// grid of a coarse grid is the coarse one of the wide grid.
int with_margin(int n) {
  int halvings = 1;
  while (n % (2 * halvings) == 0 && n / (2 * halvings) >= least_coarse_points)
    halvings *= 2;
  return n + (n / halvings + 3) / 4 * halvings;
}

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

Grid padded_grid(const Grid& grid) {
  return {2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
          2.0 * grid.length_y};
}

Grid grid_with_margin(const Grid& grid) {
  const int x = with_margin(grid.points_x);
  const int y = with_margin(grid.points_y);
  return {x, y, x * grid.spacing_x(), y * grid.spacing_y()};
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

struct FreeHalfspace::Shared {
  Grid grid, wide;
  Convolution<double> exact;
  Convolution<float> convolution, wide_convolution;
  EvenSymbol compliance;      ///< symbol on the padded grid [m/Pa] > 0
  EvenSymbol wide_compliance; ///< the same on the wide grid
  double short_wave;          ///< C at half the Nyquist wavevector [m/Pa]
  Convolution<float>::Symbol symbol;
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse = nullptr;

  /// @param make  make(grid, is_wide) finds the symbol on the padded grid or on
  ///              the wide grid
  template <class Make>
  Shared(const Grid& grid_, int threads, const Make& make)
      : grid(grid_),
        wide(grid_with_margin(grid)),
        exact(grid, padded_grid(grid), threads),
        convolution(grid, padded_grid(grid), threads),
        wide_convolution(wide, threads),
        compliance(make(padded_grid(grid), false)),
        wide_compliance(make(wide, true)),
        // A quarter of the points of the padded grid.
        short_wave(compliance.column(grid.points_x / 2)[0]),
        symbol(convolution.arranged(columns(compliance))) {}

  static EvenColumn columns(const EvenSymbol& of) {
    return [&of](int jx, std::span<double> of_jy) {
      std::ranges::copy(of.column(jx).first(of_jy.size()), of_jy.begin());
    };
  }
};

FreeHalfspace::FreeHalfspace(const Grid& grid, double contact_modulus,
                             int threads)
    : FreeHalfspace(std::make_shared<const Shared>(
          grid, threads, [&](const Grid& wide, bool /*is_wide*/) {
            return EvenSymbol(wide, rectangle_kernel(wide, contact_modulus),
                              threads);
          })) {}

FreeHalfspace::FreeHalfspace(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)),
      exact_(shared_->exact),
      convolution_(shared_->convolution),
      wide_convolution_(shared_->wide_convolution) {}

std::unique_ptr<SurfaceOperator> FreeHalfspace::clone() const {
  return std::unique_ptr<SurfaceOperator>(new FreeHalfspace(shared_));
}

const Grid& FreeHalfspace::grid() const {
  return shared_->grid;
}

const Grid& FreeHalfspace::wide_grid() const {
  return shared_->wide;
}

double FreeHalfspace::short_wave_compliance() const {
  return shared_->short_wave;
}

std::unique_ptr<SurfaceOperator> FreeHalfspace::coarsened() const {
  const std::optional<Grid> coarse = coarse_grid(grid());
  if (!coarse)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    shared_->coarse = std::make_shared<const Shared>(
        *coarse, threads(), [&](const Grid& grid, bool is_wide) {
          return (is_wide ? shared_->wide_compliance : shared_->compliance)
              .coarsened(grid);
        });
  });
  return std::unique_ptr<SurfaceOperator>(new FreeHalfspace(shared_->coarse));
}

std::unique_ptr<SurfaceOperator> FreeHalfspace::periodic_extension() const {
  return std::make_unique<FourierOperator>(
      padded_grid(grid()), Shared::columns(shared_->compliance), threads());
}

void FreeHalfspace::displacement(std::span<const double> pressure,
                                 std::span<double> displacement) {
  // A step needs it two or three times: its spectrum, of 16 bytes per node, and
  // those in single precision are not kept at the same time.
  convolution_.free_scratch();
  wide_convolution_.free_scratch();
  exact_.apply(pressure, Shared::columns(shared_->compliance), displacement);
  exact_.free_scratch();
}

void FreeHalfspace::displacement_change(std::span<const float> pressure_change,
                                        std::span<float> displacement_change) {
  convolution_.apply(pressure_change, shared_->symbol, displacement_change);
}

void FreeHalfspace::pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
  convolution_.apply(gap,
                     inverse_.of(convolution_,
                                 Shared::columns(shared_->compliance),
                                 local_compliance),
                     pressure);
}

void FreeHalfspace::wide_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  wide_convolution_.apply(
      gap,
      wide_inverse_.of(wide_convolution_,
                       Shared::columns(shared_->wide_compliance),
                       local_compliance),
      pressure);
}

} // namespace asperity::contact
