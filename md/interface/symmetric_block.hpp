#pragma once

// A real symmetric 3 x 3 block: of a wavevector's stiffness, or of the second
// derivatives with the place of one atom.

namespace asperity::md {

struct SymmetricBlock {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
  double xz = 0.0;
  double yz = 0.0;
};

} // namespace asperity::md
