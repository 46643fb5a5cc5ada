#pragma once

// What every iterative solver of the contact problem holds: the problem, the
// pressure reached, the error that is left and the counts.

#include "contact/solvers/solver.hpp"

#include <span>
#include <vector>

namespace asperity::contact {

/// The part of a state that does not depend on how the fields are updated.
class Iteration {
public:
  /// Checks the arguments and sets the initial pressure.
  /// @throws std::domain_error  see solve_contact
  Iteration(SurfaceOperator& elasticity, const ContactProblem& problem,
            const mechanics::LoadTarget& target,
            std::vector<double> initial_pressure);

  bool by_pressure() const {
    return target.control == mechanics::Control::nominal_pressure;
  }

  bool is_converged() const { return gap_error <= problem.gap_tolerance; }

  /// True if the tolerance is met, if the iteration limit is reached, or if the
  /// error is not finite.
  bool is_at_end() const;

  SurfaceOperator& elasticity;
  ContactProblem problem;
  mechanics::LoadTarget target;
  std::vector<double> pressure; ///< p [Pa]
  double gap_error = 0.0;       ///< [m]
  int iterations = 0;
  int transforms = 0;

protected:
  /// Weighted sums of the pressure [Pa] and the gap [m] over all nodes.
  struct Observed {
    double pressure = 0.0, gap = 0.0;

    Observed& operator+=(const Observed& other) {
      pressure += other.pressure;
      gap += other.gap;
      return *this;
    }
  };

  /// The sums of the nodes begin..end-1.
  Observed observe(std::span<const double> gap, std::size_t begin,
                   std::size_t end) const;

  /// The state as a solution; its note says if it did not converge. The
  /// pressure is moved away.
  /// @param gap           C p - h + u [m], one value per node
  /// @param displacement  C p [m], one value per node
  ContactSolution solution_of(std::vector<double> gap,
                              std::vector<double> displacement,
                              const Observed& sums);
};

/// Factor that scales a pressure with this (weighted) sum over the nodes to the
/// prescribed load. It is NaN if it cannot be computed to full precision: the
/// sum is 0, not finite, or out of proportion to the load.
double load_scale(const mechanics::LoadTarget& target, std::size_t nodes,
                  double pressure_sum);

/// Scales the pressure to the mean pressure of the target, if the target
/// prescribes one. If no node carries a load, the pressure, and hence its
/// residual, becomes NaN.
/// @param workers  the result does not depend on their number
void scale_to_target(const mechanics::LoadTarget& target,
                     std::span<const double> weights,
                     std::span<double> pressure, const Workers& workers = 1);

} // namespace asperity::contact
