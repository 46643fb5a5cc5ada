#pragma once

// Case texts with which the tests of the reader begin, and the messages about a
// text that was changed.

#include "input/reader/read_case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// A self-affine surface with all three methods; lines 1 to 27.
inline const std::string contact_case = R"(schema = 1
title = "A rough block"
[surface]
kind = "self-affine"
length = "10 um"
points = 512
seed = 7
realizations = 3
rms_height = "34 nm"
hurst = 0.95
wavelength_long = "0.5 length"
wavelength_roll_off = "2.5 um"
wavelength_short = "8 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = { from = "1e-3 E*", to = "0.1 E*", steps = 3, spacing = "log" }
[theory]
gamma = 0.38
[halfspace]
[fem]
contact = "penalty"
penalty = "100 E*/h"
growth = 1.3
[expect]
gamma_slope = { value = 0.40, within = 0.05, methods = ["fem", "theory"] }
)";

/// A surface of another kind with the half-space alone; [surface] is line 2.
inline std::string shape_case(const std::string& surface_keys) {
  return "schema = 1\n[surface]\n" + surface_keys +
         "[material]\ncontact_modulus = 2e9\n[load]\nnominal_pressure = 1e6\n"
         "[halfspace]\n";
}

/// The mistakes of a text, without their first line; "" if there are none.
inline std::string mistakes_of(const std::string& text,
                               const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_case_text(text, "case.toml", overrides);
  } catch (const input::InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find('\n') + 1);
  }
  return "";
}

} // namespace asperity::cases
