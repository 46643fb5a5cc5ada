#include "contact/operators/fourier_operator.hpp"

#include "base/require.hpp"
#include "contact/operators/tile_operator.hpp"
#include "ranks/rank_sums.hpp"

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

} // namespace

struct FourierOperator::Shared {
  SharedRows rows;
  Convolution<double> exact;
  Convolution<float> convolution;
  EvenSymbol
      compliance;    ///< C(q) of the columns of this rank [m/Pa]; 0 at q = 0
  double softest;    ///< largest C(q) [m/Pa], that of the longest wavelength
  double short_wave; ///< C at half the Nyquist wavevector [m/Pa]
  Convolution<float>::Symbol symbol;
  mutable std::once_flag coarse_is_made; ///< by the first clone that needs it
  mutable std::shared_ptr<const Shared> coarse = nullptr;
  mutable std::once_flag tiles_are_made;
  mutable std::shared_ptr<const TileOperator::Symbols> tiles = nullptr;

  /// @param make  finds the symbol of some columns of the grid
  template <class Make>
  Shared(SharedRows rows_, int threads, const Make& make)
      : rows(std::move(rows_)),
        exact(rows, threads),
        convolution(rows, threads),
        compliance(make(convolution.columns())),
        softest(largest()),
        short_wave(at_half_nyquist()),
        symbol(convolution.arranged(columns())) {}

  double largest() const {
    const std::span<const double> own = compliance.values();
    return rows.grid().size() == 1 // there is only the uniform mode
               ? 1.0
               : rank_max(rows.ranks(),
                          own.empty() ? 0.0 : std::ranges::max(own));
  }

  EvenColumn columns() const {
    return [this](int jx, std::span<double> of_jy) {
      std::ranges::copy(compliance.column(jx).first(of_jy.size()),
                        of_jy.begin());
    };
  }

  /// C(q) of the waves of a window of 128^2 nodes, all of which are waves of
  /// the grid.
  std::vector<double> of_window() const {
    constexpr std::size_t half = tile_side;
    const Grid& grid = rows.grid();
    const std::size_t along_x = (grid.half_spectrum_columns() - 1) / half;
    const std::size_t along_y =
        static_cast<std::size_t>(grid.points_y) / (2 * half);
    std::vector<double> picked;
    for (std::size_t jx = 0; jx <= half; ++jx) {
      const auto column = compliance.column(static_cast<int>(jx * along_x));
      for (std::size_t k = 0; k <= half; ++k)
        picked.push_back(column[k * along_y]);
    }
    return picked;
  }

  std::shared_ptr<const TileOperator::Symbols> of_tiles() const {
    const Grid& fine = rows.grid();
    const Grid grid{fine.points_x / 4, fine.points_y / 4, fine.length_x,
                    fine.length_y};
    const EvenSymbol kept = compliance.coarsened(grid);
    return TileOperator::symbols(
        fine,
        [&](int jx, std::span<double> of_jy) {
          std::ranges::copy(kept.column(jx), of_jy.begin());
        },
        of_window(), short_wave, convolution.threads());
  }

  /// (points_x/4, 0), or (0, points_y/4) if the x direction has too few points.
  double at_half_nyquist() const {
    const Grid& grid = rows.grid();
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

FourierOperator::FourierOperator(SharedRows rows, const EvenColumn& compliance,
                                 int threads)
    : FourierOperator(std::make_shared<const Shared>(
          rows, threads, [&](SpectrumColumns own) {
            return EvenSymbol(rows.grid(), checked(compliance), own, threads);
          })) {}

FourierOperator::FourierOperator(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)),
      exact_(shared_->exact),
      convolution_(shared_->convolution) {}

std::unique_ptr<SurfaceOperator> FourierOperator::clone() const {
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_));
}

const Grid& FourierOperator::grid() const {
  return shared_->rows.grid();
}

const SharedRows* FourierOperator::shared_rows() const {
  return shared_->rows.ranks() != nullptr ? &shared_->rows : nullptr;
}

double FourierOperator::short_wave_compliance() const {
  return shared_->short_wave;
}

std::unique_ptr<SurfaceOperator> FourierOperator::coarsened() const {
  const std::optional<Grid> coarse = coarse_grid(grid());
  if (!coarse || shared_rows() != nullptr)
    return nullptr;
  std::call_once(shared_->coarse_is_made, [&] {
    shared_->coarse = std::make_shared<const Shared>(
        SharedRows(*coarse), threads(), [&](SpectrumColumns) {
          return shared_->compliance.coarsened(*coarse);
        });
  });
  return std::unique_ptr<SurfaceOperator>(new FourierOperator(shared_->coarse));
}

std::unique_ptr<SurfaceOperator>
FourierOperator::on_tiles(const Tiles& tiles) const {
  if (!has_tiles(grid()) || shared_rows() != nullptr)
    return nullptr;
  std::call_once(shared_->tiles_are_made,
                 [&] { shared_->tiles = shared_->of_tiles(); });
  return std::make_unique<TileOperator>(shared_->tiles, tiles);
}

void FourierOperator::displacement(std::span<const double> pressure,
                                   std::span<double> displacement) {
  exact_.apply(pressure, shared_->columns(), displacement);
}

void FourierOperator::pressure_of(std::span<const double> displacement,
                                  std::span<double> pressure) {
  const EvenColumn inverse = [&](int jx, std::span<double> of_jy) {
    shared_->columns()(jx, of_jy);
    for (double& value : of_jy)
      value = value > 0.0 ? 1.0 / value : 0.0; // 0 of the uniform mode
  };
  exact_.apply(displacement, inverse, pressure);
}

void FourierOperator::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  convolution_.apply(pressure_change, shared_->symbol, displacement_change);
}

void FourierOperator::pressure_estimate(std::span<const float> gap,
                                        double local_compliance,
                                        std::span<float> pressure) {
  // The compliance of the uniform mode is undefined here; that of the longest
  // wavelength replaces it.
  const EvenColumn compliance = [&](int jx, std::span<double> of_jy) {
    shared_->columns()(jx, of_jy);
    if (jx == 0)
      of_jy[0] = shared_->softest;
  };
  convolution_.apply(
      gap, inverse_.of(convolution_, compliance, local_compliance), pressure);
}

} // namespace asperity::contact
