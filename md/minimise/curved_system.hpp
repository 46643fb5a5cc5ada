#pragma once

// A system that knows its second derivatives. Owns what Newton's method needs
// besides forces.

#include "md/minimise/system.hpp"

#include <span>

namespace asperity::md {

class CurvedSystem : public System {
public:
  /// Takes the second derivatives at `state` for the calls below: one sum over
  /// all pairs.
  virtual void linearise(std::span<const double> state) = 0;

  /// No single atom's interface shall be softer than minus `share` of what the
  /// bulk sets against that atom moving alone: what is softer is replaced.
  /// Infinity leaves the second derivatives as they are; with 0 they are
  /// positive semidefinite. Takes them as linearise() found them.
  /// @param share  >= 0 [1]
  virtual void limit_softness(double share) = 0;

  /// forces = what a small `step` takes off the forces [N]: second derivatives
  /// times step, what the load holds fixed taken out.
  virtual void curvature_times(std::span<const double> step,
                               std::span<double> forces) const = 0;

  /// step = P forces, P as in System::precondition, but made from the second
  /// derivatives.
  virtual void precondition_curved(std::span<const double> forces,
                                   std::span<double> step) const = 0;

  /// Shortens each atom's part of a step that is longer than `longest` [m] to
  /// that; what the load holds fixed stays so.
  virtual void shorten(std::span<double> step, double longest) const = 0;
};

} // namespace asperity::md
