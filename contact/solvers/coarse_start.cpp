#include "base/parallel_rows.hpp"
#include "base/ranks/node_sums.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/solver.hpp"
#include "contact/solvers/starting_pressure.hpp"
#include "contact/solvers/tile_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

std::vector<double> every_second(const Grid& fine, const Grid& coarse,
                                 std::span<const double> field) {
  std::vector<double> picked(coarse.size());
  for (int iy = 0; iy < coarse.points_y; ++iy)
    for (int ix = 0; ix < coarse.points_x; ++ix)
      picked[coarse.index(ix, iy)] = field[fine.index(2 * ix, 2 * iy)];
  return picked;
}

/// Value half-way between the inner two of four equidistant ones, cubic in
/// between.
double between(double before, double left, double right, double after) {
  return 0.5625 * (left + right) - 0.0625 * (before + after);
}

/// Number of values that the interpolation needs beyond the ends of a line.
constexpr std::size_t ghosts_before = 1, ghosts_after = 2;
constexpr std::size_t n_ghosts = ghosts_before + ghosts_after;

/// Value of a line beyond its end by linear extrapolation from the last values.
/// @param spacings  from the end
double beyond(double end, double inner, double spacings) {
  return (1.0 + spacings) * end - spacings * inner;
}

/// Sets the values beyond the ends of a line of coarse values: those at the
/// other end of a periodic surface, mirror images, or by linear extrapolation.
/// @param value  value(i), i from 0: the i-th of the line with its ghosts
template <class Value>
void set_ghosts(std::size_t n, const SurfaceOperator& elasticity,
                const Value& value) {
  const std::size_t first = ghosts_before, last = ghosts_before + n - 1;
  if (elasticity.is_mirrored()) {
    value(0) = value(first);
    value(last + 1) = value(last);
    value(last + 2) = value(last - 1);
  } else if (elasticity.is_periodic()) {
    value(0) = value(last);
    value(last + 1) = value(first);
    value(last + 2) = value(first + 1);
  } else {
    value(0) = beyond(value(first), value(first + 1), 1.0);
    value(last + 1) = beyond(value(last), value(last - 1), 1.0);
    value(last + 2) = beyond(value(last), value(last - 1), 2.0);
  }
}

/// A row at twice as many points.
/// @param coarse  n values after one and before two ghosts
/// @param fine    2 n values
void widen(std::span<const double> coarse, std::span<double> fine) {
  const double* const c = coarse.data();
  double* const f = fine.data();
  for (std::size_t i = 0; i < coarse.size() - n_ghosts; ++i) {
    f[2 * i] = c[i + 1];
    f[2 * i + 1] = between(c[i], c[i + 1], c[i + 2], c[i + 3]);
  }
}

/// The cubic interpolation of a coarse field.
std::vector<double> interpolated(std::span<const double> coarse,
                                 const SurfaceOperator& elasticity) {
  const Grid& fine_grid = elasticity.grid();
  const bool is_periodic = elasticity.is_periodic();
  const auto width = static_cast<std::size_t>(fine_grid.points_x) / 2;
  const auto count = static_cast<std::size_t>(fine_grid.points_y) / 2;
  std::vector<std::vector<double>> ghosts; // beyond the rows, if they end
  const auto row = [&](std::size_t iy) {   // from that before the first
    return &coarse[(iy + count - ghosts_before) % count * width];
  };
  const auto beyond_rows = [&](std::size_t end, std::size_t inner, double n) {
    std::vector<double>& ghost = ghosts.emplace_back(width);
    for (std::size_t ix = 0; ix < width; ++ix)
      ghost[ix] = beyond(row(end)[ix], row(inner)[ix], n);
  };
  std::vector<const double*> rows(count + n_ghosts);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = row(i);
  if (elasticity.is_mirrored()) {
    rows[0] = rows[1];
    rows[count + 1] = rows[count];
    rows[count + 2] = rows[count - 1];
  }
  if (!is_periodic) {
    beyond_rows(1, 2, 1.0);
    beyond_rows(count, count - 1, 1.0);
    beyond_rows(count, count - 1, 2.0);
    rows[0] = ghosts[0].data();
    rows[count + 1] = ghosts[1].data();
    rows[count + 2] = ghosts[2].data();
  }
  std::vector<double> result(fine_grid.size());
  parallel_rows(fine_grid.points_y / 2, elasticity.threads(), [&](int iy) {
    const double* const* const near = &rows[static_cast<std::size_t>(iy)];
    const auto fine =
        std::span(result).subspan(fine_grid.index(0, 2 * iy), 4 * width);
    std::vector<double> line(width + n_ghosts);
    double* const own = line.data() + ghosts_before;
    const auto put = [&](std::span<double> to) {
      set_ghosts(width, elasticity,
                 [&](std::size_t i) -> double& { return line[i]; });
      widen(line, to);
    };
    std::copy_n(near[1], width, own);
    put(fine.first(2 * width));
    for (std::size_t i = 0; i < width; ++i)
      own[i] = between(near[0][i], near[1][i], near[2][i], near[3][i]);
    put(fine.last(2 * width));
  });
  return result;
}

/// The pressure where there is one, otherwise minus a pressure that would close
/// the gap if it varied on the scale of the grid; at the hardness, plus the one
/// that would lift the imprint. Interpolation finds the boundary of the contact
/// between the two.
/// @param compliance  [m/Pa] of such a pressure
std::vector<double> signed_pressure(ContactSolution&& solution,
                                    double compliance, double hardness) {
  std::vector<double> field = std::move(solution.pressure);
  const double stiffness = 1.0 / compliance;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double open = -stiffness * std::max(0.0, solution.gap[i]);
    const double sunk = -stiffness * std::min(0.0, solution.gap[i]);
    field[i] = field[i] >= hardness ? hardness + sunk
               : field[i] > 0.0     ? field[i]
                                    : open;
  }
  return field;
}

/// Mean over the cell of each node in a line of n nodes of the pressure of a
/// rigid punch that ends at the borders, up to a factor that does not depend on
/// the node. It is singular there: the mean over the i-th cell of 1/sqrt(x) is
/// proportional to sqrt(i + 1) - sqrt(i).
std::vector<double> punch_pressure(int n) {
  const auto from_border = [](int i) {
    return std::sqrt(i + 1.0) - std::sqrt(static_cast<double>(i));
  };
  std::vector<double> line;
  line.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
    line.push_back(n * from_border(i) * from_border(n - 1 - i));
  return line;
}

/// Multiplies a field by the pressure of a punch at the borders of the grid, or
/// divides it, so that what is interpolated is smooth there.
void multiply_by_punch(const Grid& grid, bool divides, int threads,
                       std::span<double> field) {
  std::vector<double> along_x = punch_pressure(grid.points_x);
  std::vector<double> along_y = punch_pressure(grid.points_y);
  for (std::vector<double>* line : {&along_x, &along_y})
    for (double& value : *line)
      value = divides ? 1.0 / value : value;
  parallel_rows(grid.points_y, threads, [&](int iy) {
    double* const row = &field[grid.index(0, iy)];
    const double of_row = along_y[static_cast<std::size_t>(iy)];
    for (std::size_t ix = 0; ix < along_x.size(); ++ix)
      row[ix] *= of_row * along_x[ix];
  });
}

/// Adds the pressure that flattens the waves of the heights which the coarse
/// grid does not hold, (C + c)^-1 of what the interpolation of its heights
/// leaves.
void add_short_waves(const SurfaceOperator& elasticity,
                     const ContactProblem& problem,
                     std::span<const double> interpolated_heights,
                     std::span<double> field) {
  std::vector<float> left(field.size()), flattening(field.size());
  chunked(field.size(), elasticity.threads(),
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              left[i] = static_cast<float>(problem.heights[i] -
                                           interpolated_heights[i]);
          });
  elasticity.clone()->pressure_estimate(left, problem.local_compliance,
                                        flattening);
  chunked(field.size(), elasticity.threads(),
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              if (std::isfinite(flattening[i])) // else beyond single precision
                field[i] += static_cast<double>(flattening[i]);
          });
}

} // namespace

std::vector<double> coarse_start(const SurfaceOperator& elasticity,
                                 const ContactProblem& problem,
                                 const mechanics::LoadTarget& target,
                                 double coarse_tolerance) {
  const std::unique_ptr<SurfaceOperator> coarse = elasticity.coarsened();
  if (!coarse)
    return {};
  const Grid& grid = coarse->grid();
  const std::vector<double> heights =
      every_second(elasticity.grid(), grid, problem.heights);
  ContactProblem coarse_problem = problem;
  coarse_problem.heights = heights;
  coarse_problem.gap_tolerance = coarse_tolerance;
  ContactSolution solution = solve_contact_from(
      coarse_start(*coarse, coarse_problem, target, coarse_tolerance), *coarse,
      coarse_problem, target);
  if (!std::isfinite(solution.gap_error))
    return {};
  std::vector<double> field = signed_pressure(
      std::move(solution),
      elasticity.short_wave_compliance() + problem.local_compliance,
      problem.hardness);
  const bool is_periodic = elasticity.is_periodic();
  const int threads = elasticity.threads();
  const auto on_fine_grid = [&](std::span<const double> values) {
    return interpolated(values, elasticity);
  };
  if (!is_periodic)
    multiply_by_punch(grid, true, threads, field);
  std::vector<double> start = on_fine_grid(field);
  if (!is_periodic)
    multiply_by_punch(elasticity.grid(), false, threads, start);
  constexpr double tile_accuracy = 1e-3;
  if (start_on_tiles(elasticity, problem, target,
                     tile_accuracy * coarse_tolerance, start))
    return start;
  add_short_waves(elasticity, problem, on_fine_grid(heights), start);
  press_to_load(elasticity, target, problem.hardness, start);
  return start;
}

} // namespace asperity::contact
