#pragma once

// Texts of the cases that tests of the benchmark run.

#include <string>

namespace asperity {

/// A case on a surface of 256 points.
/// @param surface  further keys of [surface]
/// @param methods  their tables
inline std::string bench_case(const std::string& surface,
                              const std::string& methods) {
  return "schema = 1\ntitle = \"a case\"\n[surface]\nlength = \"1 um\"\n"
         "points = 256\n" +
         surface +
         "[material]\ncontact_modulus = \"2 GPa\"\npoisson_ratio = 0.3\n"
         "[load]\nnominal_pressure = [1e6, 2e6]\n" +
         methods;
}

/// A self-affine surface.
inline std::string rough_case(const std::string& methods) {
  return bench_case("kind = \"self-affine\"\nseed = 3\nrms_slope = 0.1\n"
                    "hurst = 0.8\nwavelength_long = \"1 length\"\n"
                    "wavelength_roll_off = \"0.25 length\"\n"
                    "wavelength_short = \"0.1 length\"\n",
                    methods);
}

} // namespace asperity
