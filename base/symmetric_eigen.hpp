#pragma once

// Small dense eigenvalue problems. Eigen's solver of matrices of any size takes
// the compiler ten seconds, so it is compiled here alone.

#include <Eigen/Core>

namespace asperity {

/// The eigenvalues of a real symmetric matrix of n rows, ascending, and its
/// orthonormal eigenvectors, a column each.
struct SymmetricEigen {
  Eigen::VectorXd values;  ///< n
  Eigen::MatrixXd vectors; ///< n x n

  /// The x of least norm among those that minimise |A x - right|. Eigenvalues
  /// within the roundoff of the largest one are taken for 0.
  /// @param right  n values
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
};

/// @param matrix  n x n, n >= 1, finite; only its lower half is read
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

} // namespace asperity
