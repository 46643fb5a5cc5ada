#pragma once

// Penalty contact, and hard contact by augmentation.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/spring_newton.hpp"

namespace asperity::fem {

/// Solves (F.1) for a penalty k_0, or for hard contact (k_0 infinite), by
/// springs of a working penalty k that the precision of a double can bear:
///
///     p = the solution of Newton's method at lambda,
///     lambda <- (1 - k/k_0) p,
///
/// until no gap in contact differs from -p/k_0 by more than the tolerance. k is
/// k_0 where that is within its bounds; one solution then suffices.
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
