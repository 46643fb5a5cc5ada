#pragma once

// A system that can also move in time: its unknowns have masses. Owns what an
// integrator needs besides forces.

#include "md/minimise/system.hpp"

#include <span>

namespace asperity::md {

class InertialSystem : public System {
public:
  /// Mass of each unknown [kg], > 0.
  virtual std::span<const double> masses() const = 0;

  /// Takes out of velocities, or of random kicks, what the load holds fixed,
  /// as energy_and_forces does with forces.
  virtual void hold(std::span<double> velocities) const = 0;
};

} // namespace asperity::md
