#include "contact/solvers/tile_start.hpp"

#include "contact/solvers/iteration.hpp"
#include "contact/solvers/starting_pressure.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace asperity::contact {
namespace {

/// Largest part of the surface that tiles may cover. With free boundaries,
/// whose operator works on four times the nodes, tiles save more.
constexpr double largest_share = 1.0 / 16.0, largest_free_share = 1.0 / 4.0;

/// Error to which the problem on the tiles is solved over that before, and
/// largest error over that before with which another one is solved.
constexpr double tile_accuracy = 1e-5, least_gain = 0.1;

constexpr int most_tile_iterations = 100;

/// The tiles with active nodes, or with some nearby; null if they cover too
/// much.
/// @param is_active  is_active(i) of the node i
template <class IsActive>
std::optional<Tiles> few_tiles(const SurfaceOperator& elasticity,
                               const IsActive& is_active) {
  const Grid& grid = elasticity.grid();
  constexpr int points = tile_points, near = points / 8;
  const auto width = static_cast<std::size_t>(grid.points_x);
  Tiles tiles{grid.points_x / points, grid.points_y / points,
              elasticity.is_periodic()};
  const std::size_t n = static_cast<std::size_t>(tiles.per_row) *
                        static_cast<std::size_t>(tiles.per_column);
  std::vector<std::uint8_t> is_used(n);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!is_active(i))
      continue;
    const int x = static_cast<int>(i % width) + points;
    const int y = static_cast<int>(i / width) + points;
    for (const int dx : {-near, near})
      for (const int dy : {-near, near})
        if (const int tile =
                tiles.number((x + dx) / points - 1, (y + dy) / points - 1);
            tile >= 0)
          is_used[static_cast<std::size_t>(tile)] = 1;
  }
  for (std::size_t tile = 0; tile < n; ++tile)
    if (is_used[tile] != 0)
      tiles.numbers.push_back(static_cast<int>(tile));
  const double share = tiles.is_periodic ? largest_share : largest_free_share;
  const bool are_few =
      !tiles.numbers.empty() && static_cast<double>(tiles.numbers.size()) <=
                                    share * static_cast<double>(n);
  return are_few ? std::optional(std::move(tiles)) : std::nullopt;
}

/// Calls do_row(first node on the grid, first node on the tiles) for each row
/// of a tile.
template <class DoRow>
void each_row(const Tiles& tiles, const DoRow& do_row) {
  const std::size_t width = static_cast<std::size_t>(tiles.per_row) * tile_side;
  for (std::size_t slot = 0; slot < tiles.numbers.size(); ++slot) {
    const auto tx =
        static_cast<std::size_t>(tiles.numbers[slot] % tiles.per_row);
    const auto ty =
        static_cast<std::size_t>(tiles.numbers[slot] / tiles.per_row);
    for (std::size_t y = 0; y < tile_side; ++y)
      do_row((ty * tile_side + y) * width + tx * tile_side,
             (slot * tile_side + y) * tile_side);
  }
}

std::vector<double> packed(const Tiles& tiles, std::span<const double> field) {
  std::vector<double> values(tiles.numbers.size() * tile_nodes);
  each_row(tiles, [&](std::size_t from, std::size_t to) {
    std::copy_n(&field[from], tile_side, &values[to]);
  });
  return values;
}

void unpack(const Tiles& tiles, std::span<const double> values,
            std::span<double> field) {
  each_row(tiles, [&](std::size_t to, std::size_t from) {
    std::copy_n(&values[from], tile_side, &field[to]);
  });
}

/// The problem between the nodes of some tiles.
struct TileProblem {
  Tiles tiles;
  std::unique_ptr<SurfaceOperator> elasticity;
  ContactProblem problem;
  mechanics::LoadTarget target;
  std::vector<double> heights, pressure;

  /// Solves it from the pressure, which is that of the solution afterwards.
  ContactSolution solve(double gap_tolerance) {
    problem.heights = heights;
    problem.gap_tolerance =
        std::max(0.5 * problem.gap_tolerance, gap_tolerance);
    problem.max_iterations =
        std::min(most_tile_iterations, problem.max_iterations);
    ContactState state(*elasticity, problem, target, std::move(pressure));
    state.update_residual();
    ContactSolution solution = iterated(std::move(state));
    pressure = std::move(solution.pressure);
    return solution;
  }
};

/// Without heights and pressure. None if the contact covers too much of the
/// surface, or if the operator has no form on tiles.
template <class IsActive>
std::optional<TileProblem>
tile_problem(const SurfaceOperator& elasticity, const ContactProblem& problem,
             const mechanics::LoadTarget& target, const IsActive& is_active) {
  if (!has_tiles(elasticity.grid()) || problem.has_hardness() ||
      target.control != mechanics::Control::nominal_pressure)
    return std::nullopt;
  if (elasticity.shared_rows() != nullptr)
    return std::nullopt;
  const std::optional<Tiles> tiles = few_tiles(elasticity, is_active);
  std::unique_ptr<SurfaceOperator> on_tiles =
      tiles ? elasticity.on_tiles(*tiles) : nullptr;
  if (!on_tiles)
    return std::nullopt;
  const double nominal_pressure =
      target.amount * static_cast<double>(elasticity.grid().size()) /
      static_cast<double>(on_tiles->grid().size());
  return TileProblem{*tiles,  std::move(on_tiles),
                     problem, {target.control, nominal_pressure},
                     {},      {}};
}

/// Lowers the error of a state once, with the displacement D p of the tiles
/// instead of C p and the heights h - C p_0 + D p_0, so that the pressure p_0
/// of the state has its gap.
/// @return  whether the state was changed
bool press_tiles(ContactState& state) {
  std::optional<TileProblem> on_tiles =
      tile_problem(state.elasticity, state.problem, state.target,
                   [&](std::size_t i) { return state.freedom[i] != fixed; });
  if (!on_tiles)
    return false;
  on_tiles->pressure = packed(on_tiles->tiles, state.pressure);
  std::vector<double>& heights = on_tiles->heights;
  heights.resize(on_tiles->pressure.size());
  on_tiles->elasticity->displacement(on_tiles->pressure, heights);
  const std::vector<double> raw_gap = packed(on_tiles->tiles, state.raw_gap);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] -= raw_gap[i];
  const ContactSolution solution =
      on_tiles->solve(tile_accuracy * state.gap_error);
  state.iterations += solution.iterations;
  if (!solution.converged)
    return false;
  unpack(on_tiles->tiles, on_tiles->pressure, state.pressure);
  state.set_pressure(std::move(state.pressure));
  return true;
}

} // namespace

bool start_on_tiles(const SurfaceOperator& elasticity,
                    const ContactProblem& problem,
                    const mechanics::LoadTarget& target, double gap_tolerance,
                    std::span<double> start) {
  std::optional<TileProblem> on_tiles =
      tile_problem(elasticity, problem, target,
                   [&](std::size_t i) { return start[i] > 0.0; });
  if (!on_tiles)
    return false;
  on_tiles->heights = packed(on_tiles->tiles, problem.heights);
  on_tiles->pressure = packed(on_tiles->tiles, start);
  press_to_load(*on_tiles->elasticity, on_tiles->target, problem.hardness,
                on_tiles->pressure);
  if (!on_tiles->solve(gap_tolerance).converged)
    return false;
  std::ranges::fill(start, 0.0);
  unpack(on_tiles->tiles, on_tiles->pressure, start);
  return true;
}

void approach_on_tiles(ContactState& state) {
  double before = std::numeric_limits<double>::infinity();
  while (!state.is_at_end() && state.gap_error < least_gain * before) {
    before = state.gap_error;
    if (!press_tiles(state))
      return;
    state.update_residual();
  }
}

} // namespace asperity::contact
