#pragma once

// What a minimiser or an integrator sees: positions in, energy and forces out.
// Owns the order of the unknowns and what "in balance" means.

#include "base/grid.hpp"
#include "md/interface/interface.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// What is held.
struct Load {
  enum class Kind {
    nominal_pressure, ///< pressed from above by p_0 A_0 [Pa]
    height,           ///< mean z of the lowest layer over the substrate's
                      ///< mean plane, d = u + d_c [m]
  };
  Kind kind = Kind::nominal_pressure;
  double amount = 0.0; ///< [Pa] or [m]
};

/// What one evaluation says besides the forces.
struct Evaluation {
  double energy = 0.0;        ///< of bulk, interface and load [J]
  double contact_force = 0.0; ///< mean over the lowest layer of |normal force
                              ///< of the substrate on an atom| [N]: what a
                              ///< residual is measured by. Repulsion alone
                              ///< makes it the mean normal force.
};

/// An atomistic block over a substrate. The state is a flat vector; its first
/// 3 n values, n = layer().size(), are the planes x, y, z of LayerView of the
/// lowest layer, so anyone can read the contact off any system.
class System {
public:
  virtual ~System() = default;

  virtual const Grid& layer() const = 0;
  virtual std::size_t size() const = 0; ///< unknowns

  /// The load of all following calls.
  virtual void set_load(const Load& load) = 0;

  /// The flat block, undeformed, its lowest layer at `height` [m].
  virtual std::vector<double> undeformed(double height) const = 0;

  /// Potential energy of bulk, interface and load, and the forces on the
  /// unknowns [N], minus its gradient, with what the load holds fixed taken
  /// out (under Kind::height the forces on z of the lowest layer have mean 0;
  /// the mean in-plane displacement of the layer never moves: without
  /// friction it costs nothing).
  virtual Evaluation energy_and_forces(std::span<const double> state,
                                       std::span<double> forces) const = 0;

  /// step = P forces, P symmetric positive definite and near the inverse of
  /// the second derivatives: the crystal's own stiffness with contact_stiffness
  /// [N/m] an atom of the lowest layer for the interface. It may go by the
  /// state that was evaluated last.
  virtual void precondition(std::span<const double> forces,
                            double contact_stiffness,
                            std::span<double> step) const = 0;

  /// Energy of the deformed bulk alone, without the uniform compression [J].
  virtual double elastic_energy(std::span<const double> state) const = 0;

  virtual const Interface& interface() const = 0;
};

/// The planes of the lowest layer in a state.
LayerView layer_of(const System& system, std::span<const double> state);

/// Normal forces of the substrate on the atoms of the lowest layer [N],
/// positive where it pushes the block up.
std::vector<double> normal_forces(const System& system,
                                  std::span<const double> state);

} // namespace asperity::md
