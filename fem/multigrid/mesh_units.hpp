#pragma once

// Units in which the stiffness of a mesh fits into single precision.

namespace asperity::fem {

/// The shortest edge of a cell [m] and the largest shear modulus [Pa].
struct MeshUnits {
  double length = 0.0, modulus = 0.0;

  double stiffness() const { return length * modulus; } ///< [N/m]
};

} // namespace asperity::fem
