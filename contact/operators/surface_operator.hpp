#pragma once

// The only thing the contact solver knows of elasticity: pressure on a face
// gives displacement of that face. Finite elements, half-space and lattice
// each are one such operator.

#include "base/grid.hpp"

#include <memory>
#include <span>

namespace asperity::contact {

/// A linear, symmetric, positive surface compliance of a periodic face.
///
/// Sign and gauge: `pressure` >= 0 pushes the block away from the rigid
/// surface, `displacement` is how far the face gives way, in the same sense;
/// the part of the displacement that is uniform (nodal_weights' mean) is
/// removed, so that the mean gap is the rigid distance of the mean planes.
/// Symmetric means: sum_i weight_i p_i (C q)_i = sum_i weight_i (C p)_i q_i.
///
/// Methods are not const because operators keep their scratch: one instance a
/// thread; clone() shares the set-up and has its own scratch.
class SurfaceOperator {
public:
  virtual ~SurfaceOperator() = default;
  virtual std::unique_ptr<SurfaceOperator> clone() const = 0;

  virtual const Grid& grid() const = 0;

  /// Area of each node relative to the mean, mean 1; empty if all are equal.
  virtual std::span<const double> nodal_weights() const = 0;

  /// displacement = C pressure [m], without its mean.
  /// @param pressure     grid().size() values [Pa]
  /// @param displacement grid().size() values, overwritten
  virtual void displacement(std::span<const double> pressure,
                            std::span<double> displacement) = 0;

  /// The same for a small change of pressure, in single precision: right to
  /// some 1e-7 of the change.
  virtual void displacement_change(std::span<const float> pressure_change,
                                   std::span<float> displacement_change) = 0;

  /// pressure = (C + 1/penalty)^-1 gap [Pa] on the whole face, mean of the
  /// result free to be anything bounded: the preconditioner, in single
  /// precision and exact but for that and the mean.
  /// @param local_compliance  1/penalty [m/Pa] >= 0, 0 for a hard wall
  virtual void pressure_estimate(std::span<const float> gap,
                                 double local_compliance,
                                 std::span<float> pressure) = 0;

  /// C at half the Nyquist wavevector [m/Pa]: how much a node gives way to a
  /// pressure that alternates at the scale of the grid.
  virtual double short_wave_compliance() const = 0;

  /// Threads that each application uses, and the solver beside it.
  virtual int threads() const { return 1; }

  /// The same block seen at every second node in both directions, for a
  /// coarse-to-fine start; null where there is none.
  virtual std::unique_ptr<SurfaceOperator> coarsened() const { return nullptr; }
};

} // namespace asperity::contact
