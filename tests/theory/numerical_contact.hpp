#pragma once

// Contact with a continuum half-space by the project's own solver, for limits
// and tables that a test checks against a numerical solution.

#include "contact/operators/halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <limits>
#include <memory>
#include <vector>

namespace asperity::theory {

/// Load steps of hard contact on `heights` [m], with a gap tolerance of 1e-10
/// m.
inline contact::LoadSequence
halfspace_contact(const Grid& grid, const std::vector<double>& heights,
                  double contact_modulus) {
  const mechanics::ElasticBlock half_space{
      contact_modulus, 0.0, std::numeric_limits<double>::infinity(),
      mechanics::FarBoundary::clamped};
  return {std::make_unique<contact::FourierOperator>(
              contact::halfspace_operator(grid, half_space)),
          heights,
          {mechanics::ContactLaw::hard, 0.0},
          1e-10,
          2000};
}

} // namespace asperity::theory
