#pragma once

// The interface of systems that provide second derivatives for Newton's method.

#include "md/minimise/system.hpp"

#include <span>

namespace asperity::md {

class CurvedSystem : public System {
public:
  /// Computes the second derivatives at `state` for the calls below, which
  /// requires one sum over all pairs.
  virtual void linearise(std::span<const double> state) = 0;

  /// Limits the negative curvature of the interface: for each atom, eigenvalues
  /// below minus `share` times the bulk stiffness of a single displaced atom
  /// are raised to this bound. With infinity the second derivatives are
  /// unchanged; with 0 those of the interface are positive semidefinite. Each
  /// call starts from the result of linearise().
  /// @param share  >= 0 [1]
  virtual void limit_negative_curvature(double share) = 0;

  /// Computes forces = second derivatives times step [N], which is the decrease
  /// of the forces for a small `step`, with the constrained components removed.
  virtual void curvature_times(std::span<const double> step,
                               std::span<double> forces) const = 0;

  /// Computes step = P forces with P as in System::precondition(), but based on
  /// the second derivatives.
  virtual void precondition_curved(std::span<const double> forces,
                                   std::span<double> step) const = 0;

  /// Limits the displacement of each atom in a step to `longest` [m], and
  /// maintains the constraints of the load.
  virtual void shorten(std::span<double> step, double longest) const = 0;
};

} // namespace asperity::md
