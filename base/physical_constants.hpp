#pragma once

// The physical constants with their sources. No other file contains their
// values.

namespace asperity {

/// One electronvolt [J]; exact since 2019 (SI Brochure, 9th edition, Table 8
/// with the elementary charge of Table 1).
inline constexpr double electronvolt = 1.602176634e-19;

/// One unified atomic mass unit [kg] (CODATA 2018).
inline constexpr double atomic_mass_unit = 1.66053906660e-27;

/// Boltzmann's constant [J/K]; exact since 2019 (SI Brochure, 9th edition).
inline constexpr double boltzmann = 1.380649e-23;

/// Standard acceleration of gravity [m/s^2]; exact (3rd CGPM, 1901).
inline constexpr double standard_gravity = 9.80665;

/// One avoirdupois pound [kg]; exact (international yard and pound, 1959).
inline constexpr double pound = 0.45359237;

/// One standard atmosphere [Pa]; exact (10th CGPM, 1954).
inline constexpr double standard_atmosphere = 101325.0;

/// One conventional millimetre of mercury [Pa]: 13.5951 kg/l times the standard
/// gravity (ISO 80000-4).
inline constexpr double millimetre_of_mercury = 13.5951 * standard_gravity;

} // namespace asperity
