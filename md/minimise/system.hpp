#pragma once

// The interface between an atomistic system and the minimisers and integrators,
// which pass positions and receive energy and forces. It defines the order of
// the unknowns and the contact force to which residuals refer.

#include "base/grid.hpp"
#include "md/interface/interface.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// The prescribed load.
struct Load {
  enum class Kind {
    nominal_pressure, ///< pressed by the load p_0 A_0 [Pa]
    height,           ///< mean z of the lowest layer above the mean plane of
                      ///< the substrate, d = u + d_c [m]
  };
  Kind kind = Kind::nominal_pressure;
  double amount = 0.0; ///< [Pa] or [m]
};

/// Results of one evaluation other than the forces.
struct Evaluation {
  double energy = 0.0;        ///< of bulk, interface and load [J]
  double contact_force = 0.0; ///< mean over the lowest layer of |normal force
                              ///< of the substrate on an atom| [N], the
                              ///< reference of residuals; with repulsion only
                              ///< it is the mean normal force
};

/// An atomistic block above a substrate. The state is a flat vector. Its first
/// 3 n values, n = layer().size(), are the planes x, y, z of the lowest layer
/// as in LayerView, so that contact quantities can be evaluated for any system.
class System {
public:
  virtual ~System() = default;

  virtual const Grid& layer() const = 0;
  virtual std::size_t size() const = 0; ///< number of unknowns

  /// Sets the load of all following calls.
  virtual void set_load(const Load& load) = 0;

  /// Returns the state of the flat, undeformed block with its lowest layer at
  /// `height` [m].
  virtual std::vector<double> undeformed(double height) const = 0;

  /// Computes the potential energy of bulk, interface and load, and its
  /// negative gradient, the forces on the unknowns [N]. Components that the
  /// load constrains are removed: under Kind::height the forces on z of the
  /// lowest layer have mean 0. The mean in-plane displacement of the layer is
  /// always fixed, because without friction it has no effect on the energy.
  virtual Evaluation energy_and_forces(std::span<const double> state,
                                       std::span<double> forces) const = 0;

  /// Computes step = P forces. P is symmetric positive definite and
  /// approximates the inverse of the second derivatives: the stiffness of the
  /// crystal plus contact_stiffness [N/m] per atom of the lowest layer for the
  /// interface. P may depend on the state of the last evaluation.
  virtual void precondition(std::span<const double> forces,
                            double contact_stiffness,
                            std::span<double> step) const = 0;

  /// Returns the elastic energy of the bulk without the uniform compression
  /// [J].
  virtual double elastic_energy(std::span<const double> state) const = 0;

  virtual const Interface& interface() const = 0;
};

/// Returns the planes of the lowest layer in a state.
LayerView layer_of(const System& system, std::span<const double> state);

/// Returns the normal forces of the substrate on the atoms of the lowest layer
/// [N], positive in repulsion.
std::vector<double> normal_forces(const System& system,
                                  std::span<const double> state);

} // namespace asperity::md
