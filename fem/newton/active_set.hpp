#pragma once

// Hard contact by the primal-dual active-set method.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_iteration.hpp"

namespace asperity::fem {

/// Solves hard contact at nodes:
///
///     (u, d, P) = the linear step with the points of A held at gap = 0,
///     p = constraint force per area on A, 0 elsewhere,
///     A <- {c in A : p_c >= 0} + {c not in A : gap_c < 0},
///
/// until A does not change and the forces balance.
class ActiveSet {
public:
  /// Both must outlive this object.
  ActiveSet(ContactState& state, LinearStep& step)
      : state_(state), step_(step) {}

  /// Iterates, and counts the iterations of the answer. Returns whether the
  /// active set was found; if not, the note of the answer gives the reason. The
  /// pressure is not negative.
  /// @param gap_tolerance  [m] > 0
  bool solve(const mechanics::LoadTarget& load, const BlockContact& contact,
             double gap_tolerance, BlockSolution& answer);

private:
  bool iterate(const mechanics::LoadTarget& load, const BlockContact& contact,
               double gap_tolerance, BlockSolution& answer);
  void take_pressure(const ContactSet& active);
  ContactSet next_active(const ContactSet& active, const BlockContact& contact,
                         double gap_tolerance) const;

  ContactState& state_;
  LinearStep& step_;
};

} // namespace asperity::fem
