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

} // namespace asperity
