#pragma once

// The system of Green's function molecular dynamics, in which the bulk is
// represented by its surface stiffness, together with the interface and the
// load.

#include "md/interface/interface_curvature.hpp"
#include "md/lattice/surface_stiffness.hpp"
#include "md/minimise/curved_system.hpp"

namespace asperity::md {

/// The state consists of the planes x, y, z of the lowest layer.
///
///     E = (1/2) u K u + sum of pairs + p a^2 sum of z
///
/// The mean of z is free under a prescribed pressure and fixed under
/// Kind::height; the elastic energy does not depend on it. The means of x and y
/// are fixed; with AtomModes::normal, x and y are fixed entirely. An instance
/// contains work arrays and must be used by one thread at a time.
class GreenSystem final : public CurvedSystem {
public:
  /// @throws std::domain_error  bulk and interface of different layers
  GreenSystem(SurfaceStiffness bulk, Interface interface);

  const Grid& layer() const override { return bulk_.layer(); }

  std::size_t size() const override { return 3 * layer().size(); }

  void set_load(const Load& load) override { load_ = load; }

  std::vector<double> undeformed(double height) const override;
  Evaluation energy_and_forces(std::span<const double> state,
                               std::span<double> forces) const override;
  void precondition(std::span<const double> forces, double contact_stiffness,
                    std::span<double> step) const override;
  void linearise(std::span<const double> state) override;
  void limit_negative_curvature(double share) override;
  void curvature_times(std::span<const double> step,
                       std::span<double> forces) const override;
  void precondition_curved(std::span<const double> forces,
                           std::span<double> step) const override;
  void shorten(std::span<double> step, double longest) const override;
  double elastic_energy(std::span<const double> state) const override;

  const Interface& interface() const override { return interface_; }

private:
  LayerForces planes_of(std::span<double> unknowns) const;
  void hold(const LayerForces& forces) const;
  void scale(const LayerForces& planes, double contact_stiffness) const;

  mutable SurfaceStiffness bulk_;
  Interface interface_;
  Load load_;
  double local_stiffness_ = 0.0;
  InterfaceCurvature curvature_;
  mutable std::vector<double> contact_; ///< k_i, contact stiffness per atom
                                        ///< [N/m]
  mutable std::vector<double> scratch_; ///< three planes
};

} // namespace asperity::md
