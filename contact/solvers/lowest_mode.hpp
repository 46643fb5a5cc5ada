#pragma once

// The smallest eigenvalue of the Hessian of an adhesive contact, which tells a
// minimum of the energy from a saddle.

#include "contact/solvers/adhesive_state.hpp"

#include <vector>

namespace asperity::contact {

struct LowestMode {
  double eigenvalue = 0.0;    ///< [Pa/m]; infinite without a free node
  std::vector<double> vector; ///< on the free nodes, of rms 1 over all nodes
  bool is_saddle = false;     ///< eigenvalue < -1e-3 k_c
};

/// LOBPCG with one vector and the preconditioner M, from a random vector. It
/// ends where the residual is a tenth of the eigenvalue and the sign is
/// certain, or after 100 steps of one product with the Hessian and one with M.
/// @see  A. V. Knyazev, SIAM J. Sci. Comput. 23, 517 (2001)
LowestMode lowest_mode(AdhesiveState& state);

} // namespace asperity::contact
