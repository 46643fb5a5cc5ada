#include "contact/operators/tile_operator.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::contact {
namespace {

/// Nodes of a window beyond the tile, and along its side.
constexpr std::size_t margin = tile_side / 2, window_side = 2 * tile_side;

/// s, the width of the division into two parts [spacings].
constexpr double part_width = 7.0;

/// Spacing of the coarse nodes [spacings], and coarse nodes along the side of a
/// tile that its nodes lie between, from one before the first node.
constexpr std::size_t coarse_spacing = 4;
constexpr std::size_t patch_side = tile_side / coarse_spacing + 3;

/// The cubic B-spline of unit spacing.
double b_spline(double x) {
  const double distance = std::abs(x);
  if (distance < 1.0)
    return 2.0 / 3.0 - distance * distance * (1.0 - 0.5 * distance);
  const double rest = std::max(0.0, 2.0 - distance);
  return rest * rest * rest / 6.0;
}

/// Weights of the coarse nodes i, i + 1, i + 2 and i + 3 of a patch at the node
/// coarse_spacing i + k of a tile, for each k.
template <class Real>
using SplineWeights = std::array<std::array<Real, 4>, coarse_spacing>;

template <class Real>
SplineWeights<Real> spline_weights() {
  SplineWeights<Real> weights;
  for (std::size_t k = 0; k < coarse_spacing; ++k)
    for (std::size_t i = 0; i < 4; ++i)
      weights[k][i] =
          static_cast<Real>(b_spline(static_cast<double>(k) / coarse_spacing +
                                     1.0 - static_cast<double>(i)));
  return weights;
}

/// Transform of the B-spline on the nodes of a line of n coarse ones, 1 at
/// j = 0.
double spline_transform(int j, int n) {
  double sum = 0.0;
  for (int i = -7; i <= 7; ++i)
    sum += b_spline(0.25 * i) * std::cos(0.5 * std::numbers::pi * i * j / n);
  return 0.25 * sum;
}

/// C(q) erfc(q s / sqrt 2) of the coarse grid, without the transforms of the
/// B-splines, which have 4^2 nodes for each coarse one.
EvenColumn smooth_part(const Grid& coarse, const EvenColumn& compliance) {
  return [&, s = 0.25 * part_width * coarse.spacing_x() /
                 std::numbers::sqrt2](int jx, std::span<double> of_jy) {
    compliance(jx, of_jy);
    const double of_x = spline_transform(jx, coarse.points_x);
    for (std::size_t jy = 0; jy < of_jy.size(); ++jy) {
      const int row = static_cast<int>(jy);
      const double splines =
          4.0 * of_x * spline_transform(row, coarse.points_y);
      of_jy[jy] *=
          std::erfc(s * wavevector_size(coarse, jx, row)) / (splines * splines);
    }
  };
}

EvenColumn window_column(const std::vector<double>& values) {
  return [&values](int jx, std::span<double> of_jy) {
    std::copy_n(&values[static_cast<std::size_t>(jx) * of_jy.size()],
                of_jy.size(), of_jy.begin());
  };
}

/// C(q) of the waves of a window, all of which are waves of the grid: jy =
/// 0..64 of each jx = 0..64, the first without meaning.
std::vector<double> of_window(const EvenSymbol& compliance) {
  const auto stride = [](int points) {
    return static_cast<std::size_t>(points) / window_side;
  };
  const std::size_t along_x = stride(compliance.grid().points_x);
  const std::size_t along_y = stride(compliance.grid().points_y);
  std::vector<double> picked;
  for (std::size_t jx = 0; jx <= tile_side; ++jx) {
    const auto column = compliance.column(static_cast<int>(jx * along_x));
    for (std::size_t jy = 0; jy <= tile_side; ++jy)
      picked.push_back(column[jy * along_y]);
  }
  return picked;
}

/// C(q) erf(q s / sqrt 2) of a window: the displacement by a unit pressure on a
/// node, which ends within half a window.
EvenSymbol sharp_part(const EvenSymbol& compliance, const Grid& window,
                      int threads) {
  const Grid& grid = compliance.grid();
  const double s = part_width * grid.spacing_x() / std::numbers::sqrt2;
  const EvenColumn sharp = [&](int jx, std::span<double> of_jy) {
    columns_of(compliance)(jx, of_jy);
    for (std::size_t jy = 0; jy < of_jy.size(); ++jy)
      of_jy[jy] *=
          std::erf(s * wavevector_size(grid, jx, static_cast<int>(jy)));
    if (jx == 0) // the limit if C(q) is proportional to 1/q
      of_jy[0] = compliance.column(0)[1] * wavevector_size(grid, 0, 1) * s *
                 2.0 * std::numbers::inv_sqrtpi;
  };
  constexpr int nodes = tile_points + 1; // the others are their mirror images
  const Grid held{nodes, nodes, nodes * grid.spacing_x(),
                  nodes * grid.spacing_y()};
  std::vector<double> kernel(held.size());
  kernel[0] = 1.0;
  Convolution<double>(held, grid, threads).apply(kernel, sharp, kernel);
  return {window,
          [&](int iy, std::span<double> of_ix) {
            std::copy_n(&kernel[held.index(0, iy)], of_ix.size(),
                        of_ix.begin());
          },
          threads};
}

Grid window_of(const Grid& fine) {
  const double length = static_cast<double>(window_side) * fine.spacing_x();
  return {window_side, window_side, length, length};
}

Grid coarse_of(const Grid& fine) {
  constexpr int spacing = coarse_spacing;
  return {fine.points_x / spacing, fine.points_y / spacing, fine.length_x,
          fine.length_y};
}

/// The tiles one below the other.
Grid grid_of(double spacing, const Tiles& tiles) {
  const int n = static_cast<int>(tiles.numbers.size());
  const double length = tile_points * spacing;
  return {tile_points, n * tile_points, length, n * length};
}

std::unique_ptr<SurfaceOperator>
smooth_operator(const EvenSymbol& compliance, const Grid& coarse, int threads,
                TileOperator::WholeGrid whole) {
  const EvenSymbol kept = compliance.coarsened(coarse);
  const EvenColumn columns = columns_of(kept);
  return whole(coarse, smooth_part(coarse, columns), threads);
}

/// Calls do_node(coarse node, place in the patch) for each coarse node of the
/// patch of a tile.
template <class DoNode>
void each_coarse_node(const Grid& coarse, int tx, int ty,
                      const DoNode& do_node) {
  constexpr int nodes = static_cast<int>(patch_side);
  constexpr int spacings = static_cast<int>(tile_side / coarse_spacing);
  for (int i = 0; i < nodes * nodes; ++i)
    do_node(coarse.periodic_index(tx * spacings - 1 + i % nodes,
                                  ty * spacings - 1 + i / nodes),
            static_cast<std::size_t>(i));
}

void apply(SurfaceOperator& smooth, std::span<const double> pressure,
           std::span<double> displacement) {
  smooth.displacement(pressure, displacement);
}

void apply(SurfaceOperator& smooth, std::span<const float> pressure,
           std::span<float> displacement) {
  smooth.displacement_change(pressure, displacement);
}

} // namespace

struct TileOperator::Symbols {
  double spacing; ///< of the nodes [m]
  Grid window, coarse;
  std::vector<double> compliance; ///< of the window
  double short_wave;
  int threads;
  std::unique_ptr<SurfaceOperator> smooth;
  Convolution<float> convolution;
  Convolution<double> exact;
  Convolution<float>::Symbol sharp;
  Convolution<double>::Symbol exact_sharp;

  Symbols(const EvenSymbol& of_nodes, double short_wave_, int threads_,
          WholeGrid whole)
      : spacing(of_nodes.grid().spacing_x()),
        window(window_of(of_nodes.grid())),
        coarse(coarse_of(of_nodes.grid())),
        compliance(of_window(of_nodes)),
        short_wave(short_wave_),
        threads(threads_),
        smooth(smooth_operator(of_nodes, coarse, threads, whole)),
        convolution(window),
        exact(window) {
    const EvenSymbol of_window = sharp_part(of_nodes, window, threads);
    sharp = convolution.arranged(columns_of(of_window));
    exact_sharp = exact.arranged(columns_of(of_window));
  }
};

std::shared_ptr<const TileOperator::Symbols>
TileOperator::symbols(const EvenSymbol& compliance, double short_wave,
                      int threads, WholeGrid whole) {
  return std::make_shared<const Symbols>(compliance, short_wave, threads,
                                         whole);
}

TileOperator::TileOperator(const std::shared_ptr<const Symbols>& symbols,
                           Tiles tiles)
    : SurfaceOperator({.rows = SharedRows(grid_of(symbols->spacing, tiles)),
                       .short_wave_compliance = symbols->short_wave,
                       .threads = symbols->threads}),
      symbols_(symbols),
      tiles_(std::move(tiles)),
      smooth_(symbols_->smooth->clone()),
      windows_(static_cast<std::size_t>(symbols_->threads),
               symbols_->convolution),
      exact_windows_(windows_.size(), symbols_->exact) {
  around_.reserve(tiles_.numbers.size());
  for (const int tile : tiles_.numbers) {
    std::array<int, 9>& places = around_.emplace_back();
    for (int i = 0; i < 9; ++i) {
      const int other = tiles_.number(tile % tiles_.per_row + i % 3 - 1,
                                      tile / tiles_.per_row + i / 3 - 1);
      const auto found = std::ranges::lower_bound(tiles_.numbers, other);
      const bool is_there = found != tiles_.numbers.end() && *found == other;
      places[static_cast<std::size_t>(i)] =
          is_there ? static_cast<int>(found - tiles_.numbers.begin()) : -1;
    }
  }
}

std::unique_ptr<SurfaceOperator> TileOperator::do_clone() const {
  return std::make_unique<TileOperator>(symbols_, tiles_);
}

void TileOperator::do_displacement(std::span<const double> pressure,
                                   std::span<double> displacement) {
  displace(pressure, symbols_->exact_sharp, exact_windows_, displacement);
}

void TileOperator::do_displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  displace(pressure_change, symbols_->sharp, windows_, displacement_change);
}

void TileOperator::do_pressure_estimate(std::span<const float> gap,
                                        double local_compliance,
                                        std::span<float> pressure) {
  const EvenColumn compliance = [&](int jx, std::span<double> of_jy) {
    window_column(symbols_->compliance)(jx, of_jy);
    if (jx == 0)
      of_jy[0] = of_jy[1];
  };
  // Windows overlap, and the pressure may be in the memory of the gap.
  const std::vector<float> whole_gap(gap.begin(), gap.end());
  convolve(std::span(whole_gap),
           windows_.front().arranged(
               inverse_columns_of(compliance, local_compliance)),
           windows_, pressure);
}

template <class Real>
void TileOperator::displace(std::span<const Real> pressure,
                            const typename Convolution<Real>::Symbol& symbol,
                            Windows<Real>& windows,
                            std::span<Real> displacement) {
  std::vector<Real> coarse = spread(pressure);
  apply(*smooth_, std::span<const Real>(coarse), std::span(coarse));
  convolve(pressure, symbol, windows, displacement);
  interpolate(coarse, displacement);
}

/// The convolution in the window of each tile.
template <class Real>
void TileOperator::convolve(std::span<const Real> field,
                            const typename Convolution<Real>::Symbol& symbol,
                            Windows<Real>& windows, std::span<Real> answer) {
  std::vector<Real> all(windows.size() * window_side * window_side);
  parallel_turns(
      static_cast<int>(tiles_.numbers.size()), threads(),
      [&](int turn, int worker_number) {
        const auto slot = static_cast<std::size_t>(turn);
        const auto worker = static_cast<std::size_t>(worker_number);
        const auto window = std::span(all).subspan(
            worker * window_side * window_side, window_side * window_side);
        fill_window(field, slot, window);
        windows[worker].apply(window, symbol, window);
        for (std::size_t y = 0; y < tile_side; ++y)
          std::copy_n(&window[(y + margin) * window_side + margin], tile_side,
                      &answer[slot * tile_nodes + y * tile_side]);
      });
}

template <class Real>
void TileOperator::fill_window(std::span<const Real> field, std::size_t slot,
                               std::span<Real> window) const {
  for (std::size_t y = 0; y < window_side; ++y) {
    const std::size_t row = (y + margin) / tile_side; // of the tiles around
    const std::size_t in_tile = (y + margin) % tile_side;
    Real* to = &window[y * window_side];
    for (std::size_t column = 0; column < 3; ++column) {
      const int place = around_[slot][3 * row + column];
      const std::size_t n = column == 1 ? tile_side : margin;
      const std::size_t first = column == 0 ? margin : 0;
      if (place < 0)
        std::fill_n(to, n, Real{0});
      else
        std::copy_n(&field[static_cast<std::size_t>(place) * tile_nodes +
                           in_tile * tile_side + first],
                    n, to);
      to += n;
    }
  }
}

/// The sums of the field times the B-splines of the coarse nodes.
template <class Real>
std::vector<Real> TileOperator::spread(std::span<const Real> field) const {
  const SplineWeights<Real> weights = spline_weights<Real>();
  const Grid& coarse = symbols_->coarse;
  std::vector<Real> sums(coarse.size());
  for (std::size_t slot = 0; slot < tiles_.numbers.size(); ++slot) {
    std::array<Real, patch_side * patch_side> patch{};
    for (std::size_t y = 0; y < tile_side; ++y) {
      const Real* const row = &field[slot * tile_nodes + y * tile_side];
      std::array<Real, patch_side> line{};
      for (std::size_t x = 0; x < tile_side; ++x)
        for (std::size_t i = 0; i < 4; ++i)
          line[x / coarse_spacing + i] +=
              weights[x % coarse_spacing][i] * row[x];
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < patch_side; ++k)
          patch[(y / coarse_spacing + i) * patch_side + k] +=
              weights[y % coarse_spacing][i] * line[k];
    }
    const int tile = tiles_.numbers[slot];
    each_coarse_node(coarse, tile % tiles_.per_row, tile / tiles_.per_row,
                     [&](std::size_t at, std::size_t in_patch) {
                       sums[at] += patch[in_patch];
                     });
  }
  return sums;
}

/// Adds the interpolation of the coarse field.
template <class Real>
void TileOperator::interpolate(const std::vector<Real>& coarse,
                               std::span<Real> field) const {
  const SplineWeights<Real> weights = spline_weights<Real>();
  parallel_rows(
      static_cast<int>(tiles_.numbers.size()), threads(), [&](int turn) {
        const auto slot = static_cast<std::size_t>(turn);
        const int tile = tiles_.numbers[slot];
        std::array<Real, patch_side * patch_side> patch{};
        each_coarse_node(
            symbols_->coarse, tile % tiles_.per_row, tile / tiles_.per_row,
            [&](std::size_t at, std::size_t i) { patch[i] = coarse[at]; });
        for (std::size_t y = 0; y < tile_side; ++y) {
          std::array<Real, patch_side> line{};
          for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < patch_side; ++k)
              line[k] += weights[y % coarse_spacing][i] *
                         patch[(y / coarse_spacing + i) * patch_side + k];
          Real* const row = &field[slot * tile_nodes + y * tile_side];
          for (std::size_t x = 0; x < tile_side; ++x)
            for (std::size_t i = 0; i < 4; ++i)
              row[x] +=
                  weights[x % coarse_spacing][i] * line[x / coarse_spacing + i];
        }
      });
}

} // namespace asperity::contact
