#include "run/methods/step_solver.hpp"

#include "run/methods/curve_row.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::methods {
namespace {

void refuse(results::CurvePoint& row, const std::string& why) {
  row.status = results::StepStatus::not_converged;
  row.add_note(why);
}

/// Also if the value or the tolerance is NaN.
bool is_above(double value, double tolerance) {
  return !(std::abs(value) <= tolerance);
}

void check_gap(const mechanics::LoadTarget& asked, const Reached& reached,
               results::CurvePoint& row) {
  // The spring joins the far end to the mean gap: d = u - p_0/k.
  const bool has_spring = std::isfinite(asked.spring);
  const double flexibility = has_spring ? 1.0 / asked.spring : 0.0;
  const double end =
      reached.mean_gap -
      (has_spring ? flexibility * reached.nominal_pressure : 0.0);
  const double tolerance =
      reached.gap_tolerance + flexibility * reached.pressure_tolerance;
  if (is_above(end - asked.amount, tolerance))
    refuse(row, fmt::format(
                    "asked for {} of {:.7g} m, reached {:.7g} m, which is not "
                    "within the tolerance of {:.2g} m",
                    has_spring ? "a far end of the spring" : "a mean gap",
                    asked.amount, end, tolerance));
}

} // namespace

void check_reached(const mechanics::LoadTarget& asked, const Reached& reached,
                   results::CurvePoint& row) {
  if (reached.is_detached)
    return;
  const double tolerance = reached.pressure_tolerance;
  if (asked.control == mechanics::Control::mean_gap)
    check_gap(asked, reached, row);
  else if (is_above(reached.nominal_pressure - asked.amount, tolerance))
    refuse(row, fmt::format("asked for a nominal pressure of {:.7g} Pa, "
                            "reached {:.7g} Pa, which is not within the "
                            "tolerance of {:.2g} Pa",
                            asked.amount, reached.nominal_pressure, tolerance));
  if (is_above(reached.imbalance, tolerance))
    refuse(row, fmt::format("the contact law carries {:.3g} Pa less than the "
                            "bodies, which is not within the tolerance of "
                            "{:.2g} Pa",
                            reached.imbalance, tolerance));
}

StepAnswer StepSolver::solve(const StepTarget& target) {
  StepAnswer answer = find(target);
  distrust_non_finite(answer);
  check_reached(target.load, answer.reached, answer.row);
  return answer;
}

} // namespace asperity::methods
