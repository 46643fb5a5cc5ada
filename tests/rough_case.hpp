#pragma once

// The case that tests of runs, plans and the cache begin with: a self-affine
// surface in two realisations, pressed at four loads.

#include <string>

namespace asperity::tests {

/// @param title    of the case
/// @param points   per side
/// @param loads    value of nominal_pressure
/// @param methods  their tables
inline std::string rough_case(const std::string& title, int points,
                              const std::string& loads,
                              const std::string& methods) {
  return "schema = 1\ntitle = \"" + title + R"("
[surface]
kind = "self-affine"
length = "1 um"
points = )" +
         std::to_string(points) + R"(
seed = 3
realizations = 2
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "8 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = )" +
         loads + "\n[theory]\ngamma = 0.42\n" + methods +
         "[report]\nfields = 1\n";
}

inline const std::string four_loads =
    R"([ "1e-3 E*", "4e-3 E*", "1e-2 E*", "4e-2 E*" ])";

} // namespace asperity::tests
