#pragma once

// Measures by how much finite elements are too stiff as the block becomes
// incompressible: first-order elements lock where second-order ones do not.

#include <vector>

namespace asperity::robustness {

/// One block with one wave: 32 nodes per side, cubic surface cells, a grading
/// ratio of 1.2 and a clamped far boundary.
struct LockingRow {
  double poisson_ratio = 0.0;
  double thickness = 0.0; ///< in units of the length
  int waves = 0;          ///< periods per side
  double q1 = 0.0; ///< compliance over that of the exact slab, minus 1 [1]
  double q2 = 0.0;
};

/// Varies nu from 0 to 0.4999 for a thick and a thin block, each with a long
/// wave and with a wave of eight node spacings.
std::vector<LockingRow> locking_table();

} // namespace asperity::robustness
