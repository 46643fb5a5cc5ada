#include "base/parallel_rows.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <cmath>

namespace asperity::contact {
namespace {

std::vector<double> every_second(const Grid& fine, const Grid& coarse,
                                 std::span<const double> field) {
  std::vector<double> picked;
  picked.reserve(coarse.size());
  for (int iy = 0; iy < coarse.points_y; ++iy)
    for (int ix = 0; ix < coarse.points_x; ++ix)
      picked.push_back(field[fine.index(2 * ix, 2 * iy)]);
  return picked;
}

std::vector<double> interpolated(const Grid& coarse, const Grid& fine,
                                 std::span<const double> field, int threads) {
  std::vector<double> result(fine.size());
  parallel_rows(coarse.points_y, threads, [&](int iy) {
    for (int ix = 0; ix < coarse.points_x; ++ix) {
      const int right = (ix + 1) % coarse.points_x;
      const int above = (iy + 1) % coarse.points_y;
      const double here = field[coarse.index(ix, iy)];
      const double east = field[coarse.index(right, iy)];
      const double north = field[coarse.index(ix, above)];
      const double corner = field[coarse.index(right, above)];
      result[fine.index(2 * ix, 2 * iy)] = here;
      result[fine.index(2 * ix + 1, 2 * iy)] = 0.5 * (here + east);
      result[fine.index(2 * ix, 2 * iy + 1)] = 0.5 * (here + north);
      result[fine.index(2 * ix + 1, 2 * iy + 1)] =
          0.25 * (here + east + north + corner);
    }
  });
  return result;
}

} // namespace

std::vector<double> coarse_start(const SurfaceOperator& elasticity,
                                 const ContactProblem& problem,
                                 const mechanics::LoadTarget& target,
                                 double coarse_tolerance) {
  const std::unique_ptr<SurfaceOperator> coarse = elasticity.coarsened();
  if (!coarse)
    return {};
  const std::vector<double> heights =
      every_second(elasticity.grid(), coarse->grid(), problem.heights);
  ContactProblem coarse_problem = problem;
  coarse_problem.heights = heights;
  coarse_problem.gap_tolerance = coarse_tolerance;
  const std::vector<double> start =
      coarse_start(*coarse, coarse_problem, target, coarse_tolerance);
  const ContactSolution solution =
      solve_contact(*coarse, coarse_problem, target, start);
  if (!std::isfinite(solution.gap_error))
    return {};
  return interpolated(coarse->grid(), elasticity.grid(), solution.pressure,
                      elasticity.threads());
}

} // namespace asperity::contact
