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

/// The symmetric part of a 3 x 3 matrix of Eigen.
template <class Matrix>
SymmetricBlock symmetric_part(const Matrix& matrix) {
  return {matrix(0, 0),
          matrix(1, 1),
          matrix(2, 2),
          0.5 * (matrix(0, 1) + matrix(1, 0)),
          0.5 * (matrix(0, 2) + matrix(2, 0)),
          0.5 * (matrix(1, 2) + matrix(2, 1))};
}

} // namespace asperity::md
