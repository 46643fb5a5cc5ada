"""The case with which tests of runs in parts begin, as in rough_case.hpp."""


def rough_case(title, points, realizations, steps, methods):
    return f"""schema = 1
title = "{title}"
[surface]
kind = "self-affine"
length = "1 um"
points = {points}
seed = 3
realizations = {realizations}
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "8 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = {{ from = "1e-3 E*", to = "5e-2 E*", steps = {steps}, spacing = "log" }}
{methods}"""
