// Tests of base/symmetric_eigen.hpp.
#include "base/symmetric_eigen.hpp"

#include <gtest/gtest.h>

namespace asperity::symmetric_eigen_test {

// The matrix has the eigenvalues 0, 3, 3; (1, 1, 1) is mapped to 0.
const Eigen::Matrix3d singular{{2, -1, -1}, {-1, 2, -1}, {-1, -1, 2}};

TEST(SymmetricEigen, IsTheMatrix) {
  const SymmetricEigen found = symmetric_eigen(singular);
  EXPECT_LT((found.values - Eigen::Vector3d(0, 3, 3)).norm(), 1e-14);
  EXPECT_LT(
      (found.vectors * found.values.asDiagonal() * found.vectors.transpose() -
       singular)
          .norm(),
      1e-14);
}

// What the matrix cannot reach is left out, and the part that it maps to 0 is
// not in the solution.
TEST(SymmetricEigen, SolvesInTheLeastSquares) {
  const Eigen::Vector3d solution =
      symmetric_eigen(singular).solve(Eigen::Vector3d(4, 1, -2));
  EXPECT_LT((solution - Eigen::Vector3d(1, 0, -1)).norm(), 1e-14);
}

} // namespace asperity::symmetric_eigen_test
