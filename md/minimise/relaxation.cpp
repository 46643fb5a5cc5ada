#include "md/minimise/relaxation.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"
#include "md/minimise/curvature_memory.hpp"
#include "md/minimise/line_search.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace asperity::md {
namespace {

constexpr int shortenings = 20; ///< per step before the memory is cleared

class Descent {
public:
  Descent(const System& system, std::vector<double>& state,
          const RelaxationSettings& settings)
      : system_(system),
        settings_(settings),
        search_(system, state, settings),
        direction_(state.size()),
        memory_(state.size(), settings.memory) {}

  Relaxation report() const { return search_.report(); }

  bool is_budget_exhausted() const { return search_.is_budget_exhausted(); }

  /// Performs one step and returns whether an acceptable one was found.
  bool step() {
    if (step_by_memory())
      return true;
    if (memory_.size() == 0 || is_budget_exhausted())
      return false;
    memory_.clear(); // the stored pairs do not apply here
    return step_by_memory();
  }

private:
  /// Searches along H forces, where H is the L-BFGS approximation of the
  /// inverse second derivatives.
  bool step_by_memory() {
    memory_.remaining(search_.forces(), search_.scratch());
    system_.precondition(search_.scratch(), settings_.contact_stiffness,
                         direction_);
    memory_.complete(direction_);
    const double length = search_.search(direction_, shortenings);
    if (length > 0.0)
      memory_.learn(direction_, length, search_.previous_forces(),
                    search_.forces());
    return length > 0.0;
  }

  const System& system_;
  const RelaxationSettings& settings_;
  LineSearch search_;
  std::vector<double> direction_;
  CurvatureMemory memory_;
};

} // namespace

double residual_of(const Evaluation& evaluation,
                   std::span<const double> forces) {
  if (!(evaluation.contact_force > 0.0))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(dot(forces, forces) / static_cast<double>(forces.size())) /
         evaluation.contact_force;
}

Relaxation relax(const System& system, std::vector<double>& state,
                 const RelaxationSettings& settings, const Watch& watch) {
  require_positive("contact_stiffness", settings.contact_stiffness, "N/m");
  require_minimisable(system, state, settings);

  Descent descent(system, state, settings);
  for (;;) {
    Relaxation now = descent.report();
    now.converged = now.residual <= settings.tolerance;
    if (now.converged)
      return now;
    now.note = stop_reason(now, settings, watch);
    if (now.note.empty() && !descent.step() && !descent.is_budget_exhausted())
      now.note = fmt::format("line search failed at residual {}, tolerance {}",
                             number_text(now.residual, settings.tolerance, 2),
                             number_text(settings.tolerance, now.residual, 2));
    if (!now.note.empty())
      return now;
  }
}

} // namespace asperity::md
