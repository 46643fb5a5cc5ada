#pragma once

// What the tests of the linear solvers of a block share: vectors of all
// unknowns, a state of the contact, and the comparison with the assembled
// matrix and its factors.

#include "fem/linear/block_solver.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::fem {

using BlockVector = dealii::TrilinosWrappers::MPI::Vector;

/// Random numbers at the unconstrained unknowns.
inline BlockVector random_vector(const BlockSystem& system, unsigned int seed) {
  BlockVector vector = system.space().make_vector();
  const std::vector<double> numbers = random_field(system.n_unknowns(), seed);
  for (unsigned int i = 0; i < system.n_unknowns(); ++i)
    if (system.space().owned().is_element(i) &&
        !system.space().constraints().is_constrained(i))
      vector(i) = numbers[i] - 0.5;
  vector.compress(dealii::VectorOperation::insert);
  return vector;
}

inline double relative_difference(const BlockVector& found,
                                  const BlockVector& expected) {
  BlockVector difference(found);
  difference -= expected;
  return difference.l2_norm() / expected.l2_norm();
}

/// The derivative of force(displacement) along a step, by central differences
/// of some size.
template <class Force>
BlockVector derivative_along(const BlockVector& step, const Force& force,
                             const BlockVector& displacement, double size) {
  BlockVector low(displacement), high(displacement);
  low.add(-size, step);
  high.add(size, step);
  BlockVector change = force(high);
  change -= force(low);
  change /= 2.0 * size;
  return change;
}

/// A contact state of the points in one part of the surface.
struct PartialContact {
  std::vector<double> springs; ///< [N/m]
  std::vector<bool> held;
  bool is_sticking;
  BlockVector force; ///< random, zero at constrained and held unknowns

  /// @param spring  of each point [N/m]
  /// @param share   of the length of the surface
  PartialContact(const BlockSystem& system, double spring, bool is_held,
                 bool sticks = false, double share = 0.5)
      : springs(system.contact().size(), 0.0),
        held(springs.size(), false),
        is_sticking(sticks),
        force(random_vector(system, 2)) {
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const ContactPoint& point = system.contact()[i];
      if (point.place[0] > share * system.grid().length_x || !point.is_opposed)
        continue;
      springs[i] = spring;
      held[i] = is_held;
      if (!is_held)
        continue;
      const auto normal = point.row.front().first;
      for (unsigned int before = sticks ? 3 : 1; before-- > 0;)
        force(normal - before) = 0.0;
    }
    force.compress(dealii::VectorOperation::insert);
  }
};

/// Verifies K u without a matrix against deal.II's matrix. Tolerance: roundoff
/// of a sum over the unknowns of a cell.
inline void expect_matrix_product(const BlockSystem& system,
                                  const BlockInverse& block) {
  const BlockVector displacement = random_vector(system, 1);
  BlockVector found(displacement), expected(displacement);

  block.vmult(found, displacement);

  system.stiffness().vmult(expected, displacement);
  system.space().constraints().set_zero(expected);
  EXPECT_LT(relative_difference(found, expected), 1e-13);
}

/// Verifies a solution against the direct solver. Tolerance: the residual times
/// the condition number.
inline void expect_direct_solution(const BlockSystem& system,
                                   BlockInverse& block,
                                   const PartialContact& contact,
                                   int most_iterations) {
  BlockSolver direct(system, LinearSolver::direct);
  BlockVector expected = system.space().make_vector(), found(expected);
  direct.set_contact(contact.springs, contact.held, contact.is_sticking);
  ASSERT_TRUE(direct.solve(expected, contact.force, 0.0));
  block.prepare(contact.springs, contact.held, contact.is_sticking);

  const LinearSolution solution = block.solve(
      found, contact.force, 1e-12 * contact.force.l2_norm(), most_iterations);

  EXPECT_TRUE(solution.has_converged) << solution.last_residual;
  EXPECT_LT(relative_difference(found, expected), 1e-9);
}

/// Iterations to 1e-8 from zero.
inline int iterations_with(BlockInverse& block, const PartialContact& contact) {
  BlockVector found(contact.force);
  found = 0.0;
  block.prepare(contact.springs, contact.held, contact.is_sticking);
  const LinearSolution solution =
      block.solve(found, contact.force, 1e-8 * contact.force.l2_norm(), 100);
  EXPECT_TRUE(solution.has_converged);
  return solution.iterations;
}

} // namespace asperity::fem
