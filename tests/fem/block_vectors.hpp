#pragma once

// Vectors of all unknowns of a block for the tests of its linear solvers.

#include "fem/block/block_system.hpp"
#include "tests/fem/blocks.hpp"

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

} // namespace asperity::fem
