#pragma once

// Conversion factors of the LAMMPS units "metal": a number written by LAMMPS
// times its unit is in SI, and an SI number divided by the unit is what LAMMPS
// reads.

#include "base/physical_constants.hpp"

namespace asperity::md::metal {

inline constexpr double length = 1e-10;             ///< angstrom [m]
inline constexpr double energy = electronvolt;      ///< eV [J]
inline constexpr double force = energy / length;    ///< eV/angstrom [N]
inline constexpr double stiffness = force / length; ///< eV/angstrom^2 [N/m]
inline constexpr double time = 1e-12;               ///< ps [s]
inline constexpr double mass = atomic_mass_unit;    ///< u [kg]

} // namespace asperity::md::metal
