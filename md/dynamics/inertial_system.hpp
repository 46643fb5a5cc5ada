#pragma once

// The interface of systems with masses, as needed by time integrators.

#include "md/minimise/system.hpp"

#include <span>

namespace asperity::md {

class InertialSystem : public System {
public:
  /// Returns the mass of each unknown [kg], > 0.
  virtual std::span<const double> masses() const = 0;

  /// Projects velocities or random impulses onto the constraints of the load,
  /// as energy_and_forces() does with forces.
  virtual void hold(std::span<double> velocities) const = 0;
};

} // namespace asperity::md
