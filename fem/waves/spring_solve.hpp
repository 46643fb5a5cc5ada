#pragma once

// What is known after springs under a contact face were solved for.

namespace asperity::fem {

/// How a solve with springs went.
struct SpringSolve {
  int iterations = 0; ///< of conjugate gradients on the contact face
  bool converged = true;
};

} // namespace asperity::fem
