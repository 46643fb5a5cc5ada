#pragma once

// A network of conductances between nodes, some of which are joined to
// reservoirs: the discrete form of the flow through a gap.

#include <cstddef>
#include <functional>
#include <vector>

namespace asperity::flow {

/// The equations sum_j w_ij (P_i - P_j) + w_i (P_i - P_r) = 0 of the potentials
/// P, as a symmetric positive definite matrix by rows. Each row begins with its
/// diagonal; the others are in the order of the neighbours.
struct Network {
  std::vector<int> row_sizes;
  std::vector<int> columns;
  std::vector<double> values;
  std::vector<double> right_side; ///< w_i P_r
  std::vector<double> start;      ///< an estimate of P

  std::size_t size() const { return right_side.size(); }
};

struct NetworkSolution {
  std::vector<double> potential; ///< P of each node
  int iterations = 0;
  bool converged = false;
};

/// Solves a network to a relative error of 1e-8 in the norm of the
/// preconditioner; the dissipation then has an error of its square.
using SolveNetwork = std::function<NetworkSolution(const Network&)>;

} // namespace asperity::flow
