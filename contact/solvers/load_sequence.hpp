#pragma once

// A load program on one surface: contact laws, where each step starts from,
// and the step itself. Owns the memory of earlier steps.

#include "contact/solvers/solver.hpp"

#include <memory>
#include <vector>

namespace asperity::contact {

/// The law of the interface; all but the penalty end at the hard wall.
enum class Law {
  penalty,   ///< p = k * penetration
  hard,      ///< complementarity
  augmented, ///< penalty, its multiplier updated until nothing penetrates
};

struct Interface {
  Law law = Law::hard;
  double penalty = 0.0; ///< k [Pa/m] > 0; not read by the hard wall
};

/// Solves one load step after another, each started from what is known:
///
/// - two earlier steps: their line, continued to the new load and cut at 0;
/// - one, or a load too far away: the coarse-to-fine start below, else the
///   last step scaled;
/// - none: the problem on every second node (recursively), to 1e-3 of the rms
///   height, interpolated.
///
/// The start changes how many iterations a step takes, not its answer.
class LoadSequence {
public:
  /// @param elasticity     taken over; its scratch is used
  /// @param heights        h [m], grid.size() values
  /// @param gap_tolerance  [m] > 0, see ContactProblem; no less than the
  /// rounding
  ///                       of the depth c p_0 that a soft penalty is pressed
  ///                       in, (8 + N/8) eps of it on N nodes
  /// @throws std::domain_error  a size or a number is outside its range
  LoadSequence(std::unique_ptr<SurfaceOperator> elasticity,
               std::vector<double> heights, const Interface& interface,
               double gap_tolerance, int max_iterations);

  ContactSolution solve(const LoadTarget& target);

  /// The last steps as numbers, from which another process goes on as this one
  /// would; empty before the first.
  std::vector<double> memory() const;

  /// @param memory  of a sequence on an equal grid
  /// @throws std::domain_error  it is none
  void recall(std::span<const double> memory);

  /// Penalty compliance 1/k [m/Pa] that the solution's gap in contact shows;
  /// 0 for laws that end at the hard wall.
  double local_compliance() const;

private:
  struct Step {
    double amount;
    std::vector<double> pressure;
  };

  std::vector<double> start_for(const LoadTarget& target);
  void remember(const LoadTarget& target, const ContactSolution& solution);

  std::unique_ptr<SurfaceOperator> elasticity_;
  std::vector<double> heights_;
  Interface interface_;
  double gap_tolerance_;
  int max_iterations_;
  LoadTarget::Kind kind_ = LoadTarget::Kind::nominal_pressure;
  std::vector<Step> history_; ///< the last two steps, oldest first
};

/// The pressure of the same problem on every second node, solved to
/// `coarse_tolerance` [m] and interpolated bilinearly; empty where the
/// operator has no coarse form or the coarse residual is not finite.
std::vector<double> coarse_start(const SurfaceOperator& elasticity,
                                 const ContactProblem& problem,
                                 const LoadTarget& target,
                                 double coarse_tolerance);

/// The hard wall by augmented Lagrangian: penalty problems on heights raised
/// by lambda/k, lambda = the pressure of the last one, until no node
/// penetrates by more than problem.gap_tolerance. problem.local_compliance
/// is 1/k > 0; each round shrinks a wave's penetration by 1/(1 + k C(q)). The
/// answer does not depend on k, so a spring too soft to get there is replaced
/// by a stiffer one.
ContactSolution solve_augmented(SurfaceOperator& elasticity,
                                const ContactProblem& problem,
                                const LoadTarget& target,
                                std::span<const double> initial_pressure);

} // namespace asperity::contact
