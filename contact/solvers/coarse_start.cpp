#include "base/parallel_rows.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
  std::vector<double> picked(coarse.size());
  const std::size_t width = coarse.width();
  for (int iy = 0; iy < coarse.count(); ++iy) {
    const double* const from = &field[fine.grid().index(0, 2 * iy)];
    double* const to = &picked[coarse.grid().index(0, iy)];
    for (std::size_t ix = 0; ix < width; ++ix)
      to[ix] = from[2 * ix];
  }
  return picked;
}

/// Value half-way between the inner two of four equidistant ones, cubic in
/// between.
double between(double before, double left, double right, double after) {
  return 0.5625 * (left + right) - 0.0625 * (before + after);
}

/// The row half-way between the second and third of four rows.
std::vector<double> row_between(std::span<const double> four_rows) {
  const std::size_t width = four_rows.size() / 4;
  std::vector<double> middle(width);
  for (std::size_t i = 0; i < width; ++i)
    middle[i] = between(four_rows[i], four_rows[width + i],
                        four_rows[2 * width + i], four_rows[3 * width + i]);
  return middle;
}

/// The positive part of a row at twice as many points.
void put_positive(std::span<const double> coarse, std::span<double> fine) {
  const std::size_t n = coarse.size();
  const auto put = [c = coarse.data(),
                    f = fine.data()](std::size_t before, std::size_t i,
                                     std::size_t right, std::size_t after) {
    f[2 * i] = std::max(0.0, c[i]);
    f[2 * i + 1] = std::max(0.0, between(c[before], c[i], c[right], c[after]));
  };
  put(n - 1, 0, 1, 2);
  for (std::size_t i = 1; i + 2 < n; ++i)
    put(i - 1, i, i + 1, i + 2);
  put(n - 3, n - 2, n - 1, 0);
  put(n - 2, n - 1, 0, 1);
}

/// The positive part of the cubic interpolation of a field.
/// @param field  the coarse rows of this process, after the row before and
///               before the two rows after them
std::vector<double> interpolated(const SharedRows& coarse_rows,
                                 const SharedRows& fine_rows,
                                 std::span<const double> field, int threads) {
  const std::size_t width = coarse_rows.width();
  std::vector<double> result(fine_rows.size());
  parallel_rows(coarse_rows.count(), threads, [&](int iy) {
    const auto rows =
        field.subspan(static_cast<std::size_t>(iy) * width, 4 * width);
    const auto fine =
        std::span(result).subspan(fine_rows.grid().index(0, 2 * iy), 4 * width);
    put_positive(rows.subspan(width, width), fine.first(2 * width));
    put_positive(row_between(rows), fine.last(2 * width));
  });
  return result;
}

/// The rows of this process, after the row before and before the two rows after
/// them.
/// @param field  these rows, or all rows
std::vector<double> with_ghost_rows(const SharedRows& rows,
                                    std::span<const double> field) {
  const std::size_t width = rows.width();
  if (field.size() != rows.size())
    field = field.subspan(static_cast<std::size_t>(rows.first()) * width,
                          rows.size());
  std::vector<double> padded(rows.size() + 3 * width);
  std::ranges::copy(field, padded.begin() + static_cast<std::ptrdiff_t>(width));
  const std::span<double> all(padded);
  rows.fill_ghost_rows(all.first(rows.size() + 2 * width));
  // The second row of the next rank, or the row after its only one.
  const std::span<double> second = all.subspan(2 * width, width);
  const std::span<double> last = all.last(width);
  if (rows.ranks() == nullptr)
    std::ranges::copy(second, last.begin());
  else
    rows.ranks()->pass(RankGroup::Direction::backwards, std::as_bytes(second),
                       std::as_writable_bytes(last));
  return padded;
}

/// The pressure where there is one, otherwise minus a pressure that would close
/// the gap if it varied on the scale of the grid. Interpolation finds the
/// boundary of the contact between the two.
/// @param compliance  [m/Pa] of such a pressure
std::vector<double> signed_pressure(ContactSolution&& solution,
                                    double compliance) {
  std::vector<double> field = std::move(solution.pressure);
  const double stiffness = 1.0 / compliance;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double open = -stiffness * std::max(0.0, solution.gap[i]);
    field[i] = field[i] > 0.0 ? field[i] : open;
  }
  return field;
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
  ContactSolution solution = solve_contact_from(
      coarse_start(*coarse, coarse_problem, target, coarse_tolerance), *coarse,
      coarse_problem, target);
  if (!std::isfinite(solution.gap_error))
    return {};
  const std::vector<double> field =
      signed_pressure(std::move(solution), elasticity.short_wave_compliance() +
                                               problem.local_compliance);
  return interpolated(coarse_rows, fine_rows,
                      with_ghost_rows(coarse_rows, field),
                      elasticity.threads());
}

} // namespace asperity::contact
