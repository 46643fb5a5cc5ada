#pragma once

// The exact solution on the coarsest lattice.

#include "fem/multigrid/box_lattice.hpp"
#include "fem/multigrid/mesh_contact.hpp"
#include "fem/multigrid/unknown_constraints.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Factorises K + S of a small lattice as a dense matrix in double precision.
/// Rigid motions that are not prevented are held by a matrix of their own that
/// does not change the solution under balanced forces.
class CoarsestLattice {
public:
  explicit CoarsestLattice(const BoxLattice& lattice);
  ~CoarsestLattice();

  void set_contact(const MeshContact& contact);

  /// Computes `displacement` from `force`.
  void solve();

  std::vector<float> force;        ///< on the lattice
  std::vector<float> displacement; ///< zero at images

  std::size_t bytes() const;

private:
  struct Factors;
  void assemble();

  BoxLattice lattice_;
  NodeLayout layout_;
  SharedConstraints constraints_;
  std::vector<std::size_t> places_;  ///< in a vector, of each row
  std::vector<std::size_t> numbers_; ///< of each place its row
  std::unique_ptr<Factors> factors_;
};

} // namespace asperity::fem
