#pragma once

// The system that consists of an explicit block, the interface with the
// substrate, and the load.

#include "md/dynamics/inertial_system.hpp"
#include "md/lattice/block_solver.hpp"
#include "md/lattice/multiscale_block.hpp"

#include <memory>
#include <span>
#include <vector>

namespace asperity::md {

/// The state is that of MultiscaleBlock. Under a prescribed pressure, the load
/// p_0 A_0 acts on the plate. Under Kind::height the plate is free and the mean
/// z of the lowest layer is fixed. Both differ only by a uniform strain of the
/// block, which does not couple to any other displacement, irrespective of the
/// coarsening.
///
/// The mean x and y of the lowest layer are fixed. precondition() applies the
/// exact inverse by BlockSolver, whose factors are cached until the contact
/// stiffness or the kind of load changes. An instance must be used by one
/// thread at a time.
class ExplicitSystem final : public InertialSystem {
public:
  /// @param atom_mass  mass of an atom of level 0 [kg] > 0
  /// @throws std::domain_error  as MultiscaleBlock; or the interface has
  ///                            another layer
  ExplicitSystem(const Crystal& crystal, const BlockShape& shape,
                 Interface interface, double atom_mass, int threads = 1);

  const Grid& layer() const override { return block_.shape().layer; }

  std::size_t size() const override { return block_.size(); }

  void set_load(const Load& load) override { load_ = load; }

  std::vector<double> undeformed(double height) const override;
  Evaluation energy_and_forces(std::span<const double> state,
                               std::span<double> forces) const override;
  void precondition(std::span<const double> forces, double contact_stiffness,
                    std::span<double> step) const override;
  double elastic_energy(std::span<const double> state) const override;

  const Interface& interface() const override { return interface_; }

  std::span<const double> masses() const override { return masses_; }

  void hold(std::span<double> velocities) const override;

  const MultiscaleBlock& block() const { return block_; }

private:
  MultiscaleBlock block_;
  Interface interface_;
  std::vector<double> masses_;
  Load load_;
  int threads_;
  mutable std::unique_ptr<BlockSolver> solver_;
};

} // namespace asperity::md
