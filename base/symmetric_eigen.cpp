#include "base/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace asperity {

Eigen::VectorXd SymmetricEigen::solve(const Eigen::VectorXd& right) const {
  const double roundoff = static_cast<double>(values.size()) *
                          std::numeric_limits<double>::epsilon() *
                          values.cwiseAbs().maxCoeff();
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k)
    if (std::abs(values[k]) > roundoff)
      solution += vectors.col(k) * (vectors.col(k).dot(right) / values[k]);
  return solution;
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace asperity
