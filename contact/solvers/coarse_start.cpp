#include "base/parallel_rows.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::contact {
namespace {

/// The rows of an operator.
SharedRows rows_of(const SurfaceOperator& elasticity) {
  const SharedRows* const rows = elasticity.shared_rows();
  return rows != nullptr ? *rows : SharedRows(elasticity.grid());
}

/// The rows of this process that a coarse grid keeps, also if the coarse
/// operator holds all rows.
SharedRows halved(const SharedRows& fine, const Grid& coarse) {
  if (fine.ranks() == nullptr)
    return SharedRows(coarse);
  std::vector<int> bounds = fine.bounds();
  for (int& bound : bounds)
    bound /= 2;
  return {coarse, *fine.ranks(), std::move(bounds)};
}

std::vector<double> every_second(const SharedRows& fine,
                                 const SharedRows& coarse,
                                 std::span<const double> field) {
  std::vector<double> picked;
  picked.reserve(coarse.size());
  for (int iy = 0; iy < coarse.count(); ++iy)
    for (int ix = 0; ix < coarse.grid().points_x; ++ix)
      picked.push_back(field[fine.grid().index(2 * ix, 2 * iy)]);
  return picked;
}

/// @param field  the coarse rows of this process, between the rows beside them
std::vector<double> interpolated(const SharedRows& coarse_rows,
                                 const SharedRows& fine_rows,
                                 std::span<const double> field, int threads) {
  const Grid& coarse = coarse_rows.grid();
  const Grid& fine = fine_rows.grid();
  std::vector<double> result(fine_rows.size());
  parallel_rows(coarse_rows.count(), threads, [&](int iy) {
    for (int ix = 0; ix < coarse.points_x; ++ix) {
      const int right = (ix + 1) % coarse.points_x;
      const double here = field[coarse.index(ix, iy + 1)];
      const double east = field[coarse.index(right, iy + 1)];
      const double north = field[coarse.index(ix, iy + 2)];
      const double corner = field[coarse.index(right, iy + 2)];
      result[fine.index(2 * ix, 2 * iy)] = here;
      result[fine.index(2 * ix + 1, 2 * iy)] = 0.5 * (here + east);
      result[fine.index(2 * ix, 2 * iy + 1)] = 0.5 * (here + north);
      result[fine.index(2 * ix + 1, 2 * iy + 1)] =
          0.25 * (here + east + north + corner);
    }
  });
  return result;
}

/// The rows of this process between the rows beside them.
/// @param field  these rows, or all rows
std::vector<double> with_ghost_rows(const SharedRows& rows,
                                    std::span<const double> field) {
  const std::size_t width = rows.width();
  if (field.size() != rows.size())
    field = field.subspan(static_cast<std::size_t>(rows.first()) * width,
                          rows.size());
  std::vector<double> padded(rows.size() + 2 * width);
  std::ranges::copy(field, padded.begin() + static_cast<std::ptrdiff_t>(width));
  rows.fill_ghost_rows(std::span(padded));
  return padded;
}

} // namespace

std::vector<double> coarse_start(const SurfaceOperator& elasticity,
                                 const ContactProblem& problem,
                                 const mechanics::LoadTarget& target,
                                 double coarse_tolerance) {
  const std::unique_ptr<SurfaceOperator> coarse = elasticity.coarsened();
  if (!coarse)
    return {};
  const SharedRows fine_rows = rows_of(elasticity);
  const SharedRows coarse_rows = halved(fine_rows, coarse->grid());
  std::vector<double> heights =
      every_second(fine_rows, coarse_rows, problem.heights);
  if (coarse->shared_rows() == nullptr)
    heights = coarse_rows.gathered(heights);
  ContactProblem coarse_problem = problem;
  coarse_problem.heights = heights;
  coarse_problem.gap_tolerance = coarse_tolerance;
  const ContactSolution solution = solve_contact_from(
      coarse_start(*coarse, coarse_problem, target, coarse_tolerance), *coarse,
      coarse_problem, target);
  if (!std::isfinite(solution.gap_error))
    return {};
  return interpolated(coarse_rows, fine_rows,
                      with_ghost_rows(coarse_rows, solution.pressure),
                      elasticity.threads());
}

} // namespace asperity::contact
