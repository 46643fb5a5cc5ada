#include "contact/operators/free_halfspace.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <utility>

namespace asperity::contact {
namespace {

/// Points per side of a coarse grid, at least.
constexpr int least_coarse_points = 32;

/// Twice the points and lengths in both directions.
Grid padded(const Grid& grid) {
  return {2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
          2.0 * grid.length_y};
}

/// The points of the wide grid along a line of n: a quarter more, which was as
/// good as twice as many, see docs/numerics/solver.md. The wide
/// grid of a coarse grid is the coarse one of the wide grid.
int with_margin(int n) {
  int halvings = 1;
  while (n % (2 * halvings) == 0 && n / (2 * halvings) >= least_coarse_points)
    halvings *= 2;
  return n + (n / halvings + 3) / 4 * halvings;
}

Grid with_margin(const Grid& grid) {
  const int x = with_margin(grid.points_x);
  const int y = with_margin(grid.points_y);
  return {x, y, x * grid.spacing_x(), y * grid.spacing_y()};
}

/// The symbol of a convolution on a periodic grid: the transform of the
/// displacement around one pressed cell, which is real because the displacement
/// is even in x and y. It is positive: that of the continuum, which is, differs
/// from it by a few per cent at long and by half at the shortest waves.
std::vector<double> rectangle_symbol(const Grid& wide, double contact_modulus) {
  std::vector<double> kernel(wide.size());
  for (int iy = 0; iy <= wide.points_y / 2; ++iy)
    for (int ix = 0; ix <= wide.points_x / 2; ++ix) {
      const double displacement = rectangle_displacement(
          ix * wide.spacing_x(), iy * wide.spacing_y(), wide.spacing_x(),
          wide.spacing_y(), contact_modulus);
      for (const int y : {iy, (wide.points_y - iy) % wide.points_y})
        for (const int x : {ix, (wide.points_x - ix) % wide.points_x})
          kernel[wide.index(x, y)] = displacement;
    }
  const RealFourier fourier(wide); // the same bits on any number of threads
  std::vector<std::complex<double>> spectrum(wide.half_spectrum_size());
  fourier.forward(kernel, spectrum);
  std::vector<double> symbol;
  symbol.reserve(spectrum.size());
  for (const std::complex<double>& value : spectrum)
    symbol.push_back(value.real());
  return symbol;
}

} // namespace

double rectangle_displacement(double x, double y, double side_x, double side_y,
                              double contact_modulus) {
  require_positive("side_x", side_x, "m");
  require_positive("side_y", side_y, "m");
  require_positive("contact_modulus", contact_modulus, "Pa");
  // The double integral of 1/r is x asinh(y/|x|) + y asinh(x/|y|).
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
  return (corner(east, north) - corner(west, north) - corner(east, south) +
          corner(west, south)) /
         (std::numbers::pi * contact_modulus);
}

struct FreeHalfspace::Shared {
  Grid grid;
  std::vector<double> compliance;      ///< symbol on the padded grid [m/Pa] > 0
  std::vector<double> wide_compliance; ///< the same on the wide grid
  Convolution<double> exact;
  Convolution<float> convolution;
  Convolution<float> wide_convolution;
  Convolution<double>::Symbol exact_symbol;
  Convolution<float>::Symbol symbol;
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse;

  Shared(const Grid& grid_, std::vector<double> compliance_,
         std::vector<double> wide_compliance_, int threads)
      : grid(grid_),
        compliance(std::move(compliance_)),
        wide_compliance(std::move(wide_compliance_)),
        exact(padded(grid_), grid_, threads),
        convolution(padded(grid_), grid_, threads),
        wide_convolution(with_margin(grid_), threads),
        exact_symbol(exact.arranged(compliance)),
        symbol(convolution.arranged(compliance)) {}
};

FreeHalfspace::FreeHalfspace(const Grid& grid, double contact_modulus,
                             int threads)
    : FreeHalfspace(std::make_shared<const Shared>(
          grid, rectangle_symbol(padded(grid), contact_modulus),
          rectangle_symbol(with_margin(grid), contact_modulus), threads)) {}

FreeHalfspace::FreeHalfspace(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)) {}

std::unique_ptr<SurfaceOperator> FreeHalfspace::clone() const {
  return std::unique_ptr<SurfaceOperator>(new FreeHalfspace(shared_));
}

const Grid& FreeHalfspace::grid() const {
  return shared_->grid;
}

int FreeHalfspace::threads() const {
  return shared_->exact.threads();
}

double FreeHalfspace::short_wave_compliance() const {
  return shared_
      ->compliance[static_cast<std::size_t>(shared_->grid.points_x) / 2];
}

void FreeHalfspace::displacement(std::span<const double> pressure,
                                 std::span<double> displacement) {
  shared_->exact.apply(pressure, shared_->exact_symbol, exact_scratch_,
                       displacement);
}

void FreeHalfspace::displacement_change(std::span<const float> pressure_change,
                                        std::span<float> displacement_change) {
  shared_->convolution.apply(pressure_change, shared_->symbol, scratch_,
                             displacement_change);
}

void FreeHalfspace::Inverse::apply(std::span<const float> gap,
                                   double local_compliance,
                                   const Convolution<float>& convolution,
                                   std::span<const double> compliance,
                                   std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (local_compliance_ != local_compliance) {
    std::vector<double> inverse(compliance.begin(), compliance.end());
    for (double& value : inverse)
      value = 1.0 / (value + local_compliance);
    symbol_ = convolution.arranged(inverse);
    local_compliance_ = local_compliance;
  }
  convolution.apply(gap, symbol_, scratch_, pressure);
}

void FreeHalfspace::pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
  inverse_.apply(gap, local_compliance, shared_->convolution,
                 shared_->compliance, pressure);
}

const Grid& FreeHalfspace::wide_grid() const {
  return shared_->wide_convolution.grid();
}

void FreeHalfspace::wide_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  wide_inverse_.apply(gap, local_compliance, shared_->wide_convolution,
                      shared_->wide_compliance, pressure);
}

std::unique_ptr<SurfaceOperator> FreeHalfspace::coarsened() const {
  const Grid& fine = grid();
  const std::optional<Grid> coarse = coarse_grid(fine);
  if (!coarse)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    shared_->coarse = std::make_shared<const Shared>(
        *coarse,
        coarse_spectrum(padded(fine), padded(*coarse), shared_->compliance),
        coarse_spectrum(with_margin(fine), with_margin(*coarse),
                        shared_->wide_compliance),
        threads());
  });
  return std::unique_ptr<SurfaceOperator>(new FreeHalfspace(shared_->coarse));
}

} // namespace asperity::contact
