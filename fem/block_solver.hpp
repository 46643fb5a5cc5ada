#pragma once

// Linear solves with the block's stiffness plus springs under its contact face:
// a direct solver for small blocks, CG with algebraic multigrid beyond.
// Include from .cpp files of fem/ only.

#include "fem/block_system.hpp"
#include "fem/full_block.hpp"

#include <memory>
#include <span>

namespace asperity::fem {

/// LinearSolver::automatic is direct up to this size.
constexpr unsigned int most_direct_unknowns = 12000;

class BlockSolver {
public:
  /// @param system must outlive the solver
  BlockSolver(const BlockSystem& system, LinearSolver kind);
  ~BlockSolver();

  /// Takes K plus a spring [N/m] at each grid node of the contact face.
  void set_springs(std::span<const double> springs);

  /// u = (K + springs)^-1 f. Returns false if CG gave up.
  [[nodiscard]] bool solve(dealii::Vector<double>& displacement,
                           const dealii::Vector<double>& force);

private:
  struct Factors;
  const BlockSystem& system_;
  bool is_direct_;
  dealii::SparseMatrix<double> matrix_;
  std::unique_ptr<Factors> factors_;
};

} // namespace asperity::fem
