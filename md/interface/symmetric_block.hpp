#pragma once

// A real symmetric 3 x 3 matrix, which is used for the stiffness at one
// wavevector and for the second derivatives with respect to the position of one
// atom.

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
