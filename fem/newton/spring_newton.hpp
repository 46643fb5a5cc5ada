#pragma once

// Newton's method for springs at the contact points, and the augmented
// Lagrangian, which solves stiffer ones and hard contact by it.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_iteration.hpp"

namespace asperity::fem {

/// Solves (F.1) at fixed multipliers lambda and a penalty k, by Newton's
/// semi-smooth method:
///
///     C = {c : lambda_c > k gap_c},
///     (du, dd, dP) = the linear step with springs k a on C,
///     (u, d, P) <- (u, d, P) + t (du, dd, dP),
///     p = (lambda - k gap)+,
///
/// until C does not change and the forces balance. t is 1, or the minimum of
/// the energy along the step if full steps cycle (ContactIteration) or the
/// material flows under a prescribed load.
class SpringNewton {
public:
  /// Both must outlive this object.
  SpringNewton(ContactState& state, LinearStep& step)
      : state_(state), step_(step) {}

  /// Begins a load step with the present state.
  void begin();

  /// Iterates, and counts the iterations of the answer. Returns whether the
  /// contact set was found; if not, the note of the answer gives the reason.
  /// @param contact  of which law, tolerance and penalty are used
  bool solve(const mechanics::LoadTarget& load, const BlockContact& contact,
             BlockSolution& answer);

  /// Whether the load step has ended because of the linear solver.
  bool has_linear_failure() const { return has_linear_failure_; }

private:
  bool iterate(const mechanics::LoadTarget& load, const BlockContact& contact,
               BlockSolution& answer, bool is_hard_to_find);
  void return_to(const ContactState::Placement& placement, double penalty);
  double contact_work(const ContactState::Placement& before, double share,
                      double penalty) const;
  void shorten_step(const ContactState::Placement& before, double penalty);
  bool approach_by_load(double mean_gap_target, const BlockContact& contact,
                        BlockSolution& answer);

  ContactState& state_;
  LinearStep& step_;
  /// The last state that was a solution, or that of the beginning of the load
  /// step. Full steps on changing contact sets may lead far from it.
  ContactState::Placement settled_;
  bool has_linear_failure_ = false;
};

/// Solves (F.1) for a penalty k_0, or for hard contact (k_0 infinite), by
/// springs of a working penalty k that the precision of a double can bear:
///
///     p = the solution of Newton's method at lambda,
///     lambda <- (1 - k/k_0) p,
///
/// until no gap in contact differs from -p/k_0 by more than the tolerance. k is
/// k_0 where that is within its bounds; one solution then suffices. The first
/// lambda is 0, or (1 - k/k_0) times the present pressure where the material
/// flows: the pressures on the way would be a loading path of the material.
class AugmentedLagrangian {
public:
  /// All arguments must outlive this object.
  AugmentedLagrangian(ContactState& state, SpringNewton& newton)
      : state_(state), newton_(newton) {}

  /// Writes residual, iterations, note and whether it converged.
  /// @param height_scale  the tolerance of a gap is relative to it [m] > 0
  void solve(const mechanics::LoadTarget& load, const BlockContact& contact,
             double height_scale, BlockSolution& answer);

private:
  void keep_pressure(double share, double more = 0.0);
  double first_penalty(const BlockContact& contact) const;
  double stiffest_penalty(double tolerance) const;
  double stiffer_penalty(const BlockContact& working,
                         const BlockContact& contact) const;
  double softer_penalty(const BlockContact& working);
  double missing_pressure(const mechanics::LoadTarget& load,
                          double compliance) const;
  bool can_bear(double missing, double gap_tolerance,
                BlockSolution& answer) const;

  ContactState& state_;
  SpringNewton& newton_;
};

} // namespace asperity::fem
