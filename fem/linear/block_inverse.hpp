#pragma once

// The stiffness of the block and its inverse: the interface of all linear
// solvers.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/hexahedra/cell_tangents.hpp"
#include "fem/multigrid/conjugate_gradients.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// Solves with K + B^T diag(s) B, in which the rows and columns of held
/// unknowns are zero except for their diagonal. Calls are collective.
class BlockInverse {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  virtual ~BlockInverse() = default;

  /// Computes to = K from on the unconstrained unknowns.
  virtual void vmult(Vector& to, const Vector& from) const = 0;

  /// As BlockSolver::set_contact.
  virtual void prepare(std::span<const double> springs,
                       const std::vector<bool>& held, bool is_sticking) = 0;

  /// Solves with K and the contact of the last prepare(), starting from
  /// `unknowns`. Forces and unknowns are zero at held unknowns.
  virtual LinearSolution solve(Vector& unknowns, const Vector& forces,
                               double tolerance, int most_iterations) = 0;

  /// Renews at the next use what was set up for an earlier contact.
  virtual void forget() {}

  /// Replaces the moduli of some cells of this rank by tangents, and gives all
  /// others their moduli again. The preconditioner stays elastic.
  /// @param cells  in the order of the active cells of this rank, each once
  /// @throws std::logic_error  the cells are neither second-order hexahedra nor
  /// boxes
  virtual void set_tangents(std::span<const CellTangents> cells);

  /// Factor on the relative tolerance of the systems of a Newton step, below 1
  /// if a smaller residual costs little.
  virtual double tightness() const { return 1.0; }

  virtual int setups() const = 0; ///< or factorisations, so far

  virtual std::string name() const = 0;

  virtual std::size_t bytes() const = 0; ///< on this rank
};

/// Cost of a set-up of Trilinos ML in iterations of conjugate gradients.
inline constexpr double setup_steps = 20.0;

/// Whether a hierarchy that was set up for an earlier contact state is still
/// efficient. It is not as soon as the accumulated excess of iterations since
/// its set-up would have paid for a new one.
class HierarchyAge {
public:
  /// @param fewest_steps  solutions of fewer iterations are not representative
  ///                      and do not count
  explicit HierarchyAge(int fewest_steps) : fewest_steps_(fewest_steps) {}

  bool is_stale() const { return is_stale_; } ///< must be set up again

  bool is_new() const { return is_new_; } ///< is that of the present contact

  void change_contact() { is_new_ = false; }

  void expire() { is_stale_ = true; }

  void renew() { *this = HierarchyAge(fewest_steps_, setups_ + 1); }

  int setups() const { return setups_; }

  /// Reports that a solution took so many iterations for `decades` of the
  /// residual.
  void count(int iterations, double decades);

private:
  HierarchyAge(int fewest_steps, int setups)
      : fewest_steps_(fewest_steps),
        setups_(setups),
        is_stale_(false),
        is_new_(true) {}

  int fewest_steps_;
  int setups_ = 0;
  bool is_stale_ = true;
  bool is_new_ = false;
  double steps_per_decade_ = 0.0; ///< iterations of the new hierarchy
  double lost_steps_ = 0.0;       ///< in excess of these, accumulated
};

/// Appends the unknown u_z of a held node and, if it sticks, u_x and u_y. The
/// three unknowns of a node follow each other.
template <class Unknown>
void append_held(dealii::types::global_dof_index normal, bool is_sticking,
                 std::vector<Unknown>& held) {
  for (unsigned int before = is_sticking ? 3 : 1; before-- > 0;)
    held.push_back(static_cast<Unknown>(normal - before));
}

} // namespace asperity::fem
