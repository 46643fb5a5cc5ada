#pragma once

// Result of a solve for the springs on a contact surface.

namespace asperity::fem {

/// Iteration count and convergence of a solve with springs.
struct SpringSolve {
  int iterations = 0; ///< of conjugate gradients on the contact surface
  bool converged = true;
};

} // namespace asperity::fem
