#include "contact/operators/free_halfspace.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::contact {
namespace {

/// Twice the points and lengths in both directions.
Grid padded(const Grid& grid) {
  return {2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
          2.0 * grid.length_y};
}

/// The symbol of the convolution on the padded grid: the transform of the
/// displacement around one pressed cell, which is real because the displacement
/// is even in x and y. It is positive: that of the continuum, which is, differs
/// from it by a few per cent at long and by half at the shortest waves.
std::vector<double> rectangle_symbol(const Grid& grid, double contact_modulus) {
  const Grid wide = padded(grid);
  std::vector<double> kernel(wide.size());
  for (int iy = 0; iy < wide.points_y; ++iy)
    for (int ix = 0; ix < wide.points_x; ++ix) {
      const double x = signed_wavenumber(ix, wide.points_x) * grid.spacing_x();
      const double y = signed_wavenumber(iy, wide.points_y) * grid.spacing_y();
      kernel[wide.index(ix, iy)] = rectangle_displacement(
          x, y, grid.spacing_x(), grid.spacing_y(), contact_modulus);
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
  double contact_modulus;
  std::vector<double> compliance; ///< symbol on the padded grid [m/Pa] > 0
  Convolution<double> exact;
  Convolution<float> convolution;
  Convolution<double>::Symbol exact_symbol;
  Convolution<float>::Symbol symbol;

  Shared(const Grid& grid_, double contact_modulus_, int threads)
      : grid(grid_),
        contact_modulus(contact_modulus_),
        compliance(rectangle_symbol(grid_, contact_modulus_)),
        exact(padded(grid_), grid_, threads),
        convolution(padded(grid_), grid_, threads),
        exact_symbol(exact.arranged(compliance)),
        symbol(convolution.arranged(compliance)) {}
};

FreeHalfspace::FreeHalfspace(const Grid& grid, double contact_modulus,
                             int threads)
    : FreeHalfspace(
          std::make_shared<const Shared>(grid, contact_modulus, threads)) {}

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

void FreeHalfspace::pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (inverted_compliance_ != local_compliance) {
    std::vector<double> inverse = shared_->compliance;
    for (double& value : inverse)
      value = 1.0 / (value + local_compliance);
    inverse_ = shared_->convolution.arranged(inverse);
    inverted_compliance_ = local_compliance;
  }
  shared_->convolution.apply(gap, inverse_, scratch_, pressure);
}

std::unique_ptr<SurfaceOperator> FreeHalfspace::coarsened() const {
  const Grid& fine = grid();
  if (fine.points_x % 2 != 0 || fine.points_y % 2 != 0 || fine.points_x < 64 ||
      fine.points_y < 64)
    return nullptr;
  return std::make_unique<FreeHalfspace>(
      Grid{fine.points_x / 2, fine.points_y / 2, fine.length_x, fine.length_y},
      shared_->contact_modulus, threads());
}

} // namespace asperity::contact
