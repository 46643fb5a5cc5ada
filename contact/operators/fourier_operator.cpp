#include "contact/operators/fourier_operator.hpp"

#include "base/ranks/rank_sums.hpp"
#include "base/require.hpp"
#include "contact/operators/mirrored_operator.hpp"
#include "contact/operators/tile_operator.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace asperity::contact {
namespace {

/// Checks the values of C, and sets that of the uniform mode to 0.
EvenColumn checked(const EvenColumn& compliance) {
  return [&compliance](int jx, std::span<double> of_jy) {
    compliance(jx, of_jy);
    if (jx == 0)
      of_jy[0] = 0.0;
    for (const double value : of_jy.subspan(jx == 0 ? 1 : 0))
      require_positive("compliance", value, "m/Pa");
  };
}

EvenColumn column_of(const Grid& grid, const std::vector<double>& compliance) {
  if (compliance.size() != grid.half_spectrum_size())
    refuse_argument("compliance.size()", static_cast<double>(compliance.size()),
                    "the size of the grid's half spectrum");
  return [&compliance, columns = grid.half_spectrum_columns()](
             int jx, std::span<double> of_jy) {
    for (std::size_t jy = 0; jy < of_jy.size(); ++jy)
      of_jy[jy] = compliance[jy * columns + static_cast<std::size_t>(jx)];
  };
}

/// Points per side of a coarse grid, at least.
constexpr int least_coarse_points = 32;

/// The points of the wide grid along a line of n: a quarter more, which was as
/// good as twice as many, see docs/numerics/solver.md. The wide grid of a
/// coarse grid is the coarse one of the wide grid.
int with_margin(int n) {
  int halvings = 1;
  while (n % (2 * halvings) == 0 && n / (2 * halvings) >= least_coarse_points)
    halvings *= 2;
  return n + (n / halvings + 3) / 4 * halvings;
}

} // namespace

Grid padded_grid(const Grid& grid) {
  return {2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
          2.0 * grid.length_y};
}

Grid grid_with_margin(const Grid& grid) {
  const int x = with_margin(grid.points_x);
  const int y = with_margin(grid.points_y);
  return {x, y, x * grid.spacing_x(), y * grid.spacing_y()};
}

struct FourierOperator::Shared {
  /// Finds the symbol of some columns of a grid.
  using Make = std::function<EvenSymbol(const Grid&, SpectrumColumns)>;

  /// With free boundaries: the grid of the preconditioner.
  struct Wide {
    Convolution<float> convolution;
    EvenSymbol compliance;
  };

  SharedRows rows;
  Convolution<double> exact;
  Convolution<float> convolution;
  EvenSymbol compliance; ///< [m/Pa]; with free boundaries of the padded grid
  std::optional<Wide> wide;
  double softest;    ///< largest compliance [m/Pa]
  double short_wave; ///< C at half the Nyquist wavevector [m/Pa]
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse = nullptr;
  mutable std::once_flag tiles_are_made;
  mutable std::shared_ptr<const TileOperator::Symbols> tiles = nullptr;

  /// On a periodic surface.
  Shared(SharedRows rows_, int threads, const Make& make)
      : rows(std::move(rows_)),
        exact(rows, threads),
        convolution(rows, threads),
        compliance(make(rows.grid(), convolution.columns())),
        softest(largest()),
        short_wave(at_half_nyquist()) {}

  /// On a surface with free boundaries.
  Shared(const Grid& grid, int threads, const Make& make)
      : rows(grid),
        exact(grid, padded_grid(grid), threads),
        convolution(grid, padded_grid(grid), threads),
        compliance(make(padded_grid(grid), all_columns(padded_grid(grid)))),
        wide(Wide{
            Convolution<float>(grid_with_margin(grid), threads),
            make(grid_with_margin(grid), all_columns(grid_with_margin(grid)))}),
        softest(largest()),
        short_wave(at_half_nyquist()) {}

  SurfaceTraits traits() const {
    return {.rows = rows,
            .short_wave_compliance = short_wave,
            .threads = convolution.threads(),
            .is_periodic = !wide,
            .is_shift_invariant = !wide,
            .has_inverse = !wide,
            .wide_grid =
                wide ? std::optional(wide->compliance.grid()) : std::nullopt};
  }

  double largest() const {
    return compliance.grid().size() == 1 // there is only the uniform mode
               ? 1.0
               : rank_max(rows.ranks(), compliance.largest());
  }

  std::shared_ptr<const TileOperator::Symbols> of_tiles() const {
    return TileOperator::symbols(
        compliance, short_wave, convolution.threads(),
        [](const Grid& whole, const EvenColumn& column,
           int threads) -> std::unique_ptr<SurfaceOperator> {
          return std::make_unique<FourierOperator>(whole, column, threads);
        });
  }

  /// (points_x/4, 0), or (0, points_y/4) if the x direction has too few points.
  double at_half_nyquist() const {
    const Grid& grid = compliance.grid();
    const bool is_along_x = grid.points_x >= 4;
    const int quarter = (is_along_x ? grid.points_x : grid.points_y) / 4;
    if (quarter == 0)
      return softest;
    const int jx = is_along_x ? quarter : 0;
    const std::size_t jy = is_along_x ? 0 : static_cast<std::size_t>(quarter);
    return rank_max(rows.ranks(), compliance.has_column(jx)
                                      ? compliance.column(jx)[jy]
                                      : 0.0);
  }
};

FourierOperator::FourierOperator(const Grid& grid, const EvenColumn& compliance,
                                 int threads)
    : FourierOperator(SharedRows(grid), compliance, threads) {}

FourierOperator::FourierOperator(const Grid& grid,
                                 const std::vector<double>& compliance,
                                 int threads)
    : FourierOperator(grid, column_of(grid, compliance), threads) {}

FourierOperator::FourierOperator(const Grid& grid, RankGroup& ranks,
                                 const EvenColumn& compliance, int threads)
    : FourierOperator(SharedRows(grid, ranks, row_bounds(grid, ranks.size())),
                      compliance, threads) {}

FourierOperator::FourierOperator(const SharedRows& rows,
                                 const EvenColumn& compliance, int threads)
    : FourierOperator(std::make_shared<const Shared>(
          rows, threads, [&](const Grid& grid, SpectrumColumns own) {
            return EvenSymbol(grid, checked(compliance), own, threads);
          })) {}

FourierOperator::FourierOperator(const Grid& grid, const FreeKernel& kernel,
                                 int threads)
    : FourierOperator(std::make_shared<const Shared>(
          grid, threads, [&](const Grid& padded, SpectrumColumns /*all*/) {
            return EvenSymbol(padded, kernel(padded), threads);
          })) {}

FourierOperator::FourierOperator(std::shared_ptr<const Shared> shared)
    : SurfaceOperator(shared->traits()),
      shared_(std::move(shared)),
      exact_(shared_->exact),
      convolution_(shared_->convolution) {
  if (shared_->wide)
    wide_convolution_ = shared_->wide->convolution;
}

std::unique_ptr<SurfaceOperator> FourierOperator::do_clone() const {
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_));
}

std::unique_ptr<SurfaceOperator> FourierOperator::do_coarsened() const {
  const std::optional<Grid> coarse = coarse_grid(grid());
  if (!coarse || shared_rows() != nullptr)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    if (is_periodic())
      shared_->coarse = std::make_shared<const Shared>(
          SharedRows(*coarse), threads(), [&](const Grid& grid, auto) {
            return shared_->compliance.coarsened(grid);
          });
    else
      shared_->coarse = std::make_shared<const Shared>(
          *coarse, threads(), [&](const Grid& grid, auto) {
            return (grid == padded_grid(*coarse) ? shared_->compliance
                                                 : shared_->wide->compliance)
                .coarsened(grid);
          });
  });
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_->coarse));
}

std::unique_ptr<SurfaceOperator>
FourierOperator::do_on_tiles(const Tiles& tiles) const {
  if (!has_tiles(grid()) || shared_rows() != nullptr)
    return nullptr;
  std::call_once(shared_->tiles_are_made,
                 [&] { shared_->tiles = shared_->of_tiles(); });
  return std::make_unique<TileOperator>(shared_->tiles, tiles);
}

std::unique_ptr<SurfaceOperator>
FourierOperator::do_periodic_extension() const {
  if (is_periodic())
    return nullptr;
  return std::make_unique<FourierOperator>(
      shared_->compliance.grid(), columns_of(shared_->compliance), threads());
}

std::unique_ptr<SurfaceOperator> FourierOperator::do_mirrored() const {
  if (!is_periodic() || shared_rows() != nullptr || grid().points_x % 2 != 0 ||
      grid().points_y % 2 != 0)
    return nullptr;
  return std::make_unique<MirroredOperator>(
      MirroredOperator::Symbol{
          std::shared_ptr<const EvenSymbol>(shared_, &shared_->compliance),
          shared_->softest, shared_->short_wave, clone()},
      threads());
}

void FourierOperator::do_displacement(std::span<const double> pressure,
                                      std::span<double> displacement) {
  exact_.apply(pressure, columns_of(shared_->compliance), displacement, lent());
}

void FourierOperator::do_pressure_of(std::span<const double> displacement,
                                     std::span<double> pressure) {
  if (!has_inverse()) {
    SurfaceOperator::do_pressure_of(displacement, pressure);
    return;
  }
  exact_.apply(displacement, inverse_columns_of(shared_->compliance), pressure);
}

void FourierOperator::do_displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  convolution_.apply(pressure_change, columns_of(shared_->compliance),
                     displacement_change, lent());
}

void FourierOperator::do_pressure_estimate(std::span<const float> gap,
                                           double local_compliance,
                                           std::span<float> pressure) {
  if (!is_periodic() && gap.size() == wide_grid().size()) {
    const EvenColumn compliance = columns_of(shared_->wide->compliance);
    wide_convolution_->apply(
        gap, inverse_columns_of(compliance, local_compliance), pressure);
    return;
  }
  // The compliance of the uniform mode is undefined on a periodic surface; that
  // of the longest wavelength replaces it.
  const EvenColumn known = columns_of(shared_->compliance);
  const EvenColumn compliance = [&](int jx, std::span<double> of_jy) {
    known(jx, of_jy);
    if (jx == 0 && is_periodic())
      of_jy[0] = shared_->softest;
  };
  convolution_.apply(gap, inverse_columns_of(compliance, local_compliance),
                     pressure);
}

} // namespace asperity::contact
