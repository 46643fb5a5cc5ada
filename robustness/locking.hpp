#pragma once

// How much too stiff finite elements are as the block becomes incompressible:
// first order locks where second order does not.

#include <vector>

namespace asperity::robustness {

/// One block and one wave on it, 32 nodes a side, cubic surface cells growing
/// by 1.2, on a clamped top.
struct LockingRow {
  double poisson_ratio = 0.0;
  double thickness = 0.0; ///< in lengths
  int waves = 0;          ///< on the side
  double q1 = 0.0;        ///< compliance over the exact slab's, less 1 [1]
  double q2 = 0.0;
};

/// nu from 0 to 0.4999, on a thick and on a thin block, a long wave and one of
/// eight nodes.
std::vector<LockingRow> locking_table();

} // namespace asperity::robustness
