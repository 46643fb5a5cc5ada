#include "contact/operators/free_halfspace.hpp"

#include "base/require.hpp"

#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <utility>

#include "ranks/one_rank.hpp"

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

/// The symbol of a periodic grid in this process alone.
EvenSymbol rectangle_symbol(const Grid& wide, double contact_modulus,
                            int threads) {
  return {wide, *rows_of_one(wide).ranks(),
          rectangle_kernel(wide, contact_modulus), all_columns(wide), threads};
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
  Grid grid;
  EvenSymbol compliance;      ///< symbol on the padded grid [m/Pa] > 0
  EvenSymbol wide_compliance; ///< the same on the wide grid
  Convolution<double> exact;
  Convolution<float> convolution;
  Convolution<float> wide_convolution;
  Convolution<double>::Symbol exact_symbol;
  Convolution<float>::Symbol symbol;
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse;

  Shared(const Grid& grid_, EvenSymbol compliance_, EvenSymbol wide_compliance_,
         int threads)
      : grid(grid_),
        compliance(std::move(compliance_)),
        wide_compliance(std::move(wide_compliance_)),
        exact(padded_grid(grid_), grid_, threads),
        convolution(padded_grid(grid_), grid_, threads),
        wide_convolution(grid_with_margin(grid_), threads),
        exact_symbol(exact.arranged(std::cref(compliance))),
        symbol(convolution.arranged(std::cref(compliance))) {}
};

FreeHalfspace::FreeHalfspace(const Grid& grid, double contact_modulus,
                             int threads)
    : FreeHalfspace(
          grid, rectangle_symbol(padded_grid(grid), contact_modulus, threads),
          rectangle_symbol(grid_with_margin(grid), contact_modulus, threads),
          threads) {}

FreeHalfspace::FreeHalfspace(const Grid& grid, EvenSymbol compliance,
                             EvenSymbol wide_compliance, int threads)
    : FreeHalfspace(std::make_shared<const Shared>(
          grid, std::move(compliance), std::move(wide_compliance), threads)) {}

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
  return shared_->compliance(shared_->grid.points_x / 2, 0);
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
  shared_->convolution.apply(
      gap,
      inverse_.of(shared_->convolution, shared_->compliance, local_compliance),
      scratch_, pressure);
}

const Grid& FreeHalfspace::wide_grid() const {
  return shared_->wide_convolution.grid();
}

void FreeHalfspace::wide_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  shared_->wide_convolution.apply(gap,
                                  wide_inverse_.of(shared_->wide_convolution,
                                                   shared_->wide_compliance,
                                                   local_compliance),
                                  wide_scratch_, pressure);
}

std::unique_ptr<SurfaceOperator> FreeHalfspace::coarsened() const {
  const Grid& fine = grid();
  const std::optional<Grid> coarse = coarse_grid(fine);
  if (!coarse)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    const auto kept = [](const EvenSymbol& symbol, const Grid& grid) {
      return symbol.coarsened(grid, *rows_of_one(grid).ranks(),
                              all_columns(grid));
    };
    shared_->coarse = std::make_shared<const Shared>(
        *coarse, kept(shared_->compliance, padded_grid(*coarse)),
        kept(shared_->wide_compliance, grid_with_margin(*coarse)), threads());
  });
  return std::unique_ptr<SurfaceOperator>(new FreeHalfspace(shared_->coarse));
}

} // namespace asperity::contact
