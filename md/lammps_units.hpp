#pragma once

// LAMMPS' units "metal" in SI: a number it writes times its unit here is SI,
// an SI number over its unit is what it reads.

namespace asperity::md::metal {

inline constexpr double length = 1e-10;           ///< angstrom [m]
inline constexpr double energy = 1.602176634e-19; ///< eV [J], SI brochure, 2019
inline constexpr double force = energy / length;  ///< eV/angstrom [N]
inline constexpr double stiffness = force / length; ///< eV/angstrom^2 [N/m]
inline constexpr double time = 1e-12;               ///< ps [s]
inline constexpr double mass = 1.66053906660e-27;   ///< u [kg], CODATA 2018

} // namespace asperity::md::metal
