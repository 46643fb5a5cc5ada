"""A theory of one's own on the surface of a result, as a table that `asperity report` reads.

my_theory.py RESULT TABLE: mean gap and contact area over the loads of the half-space in RESULT.
"""
import sys

import asperity
import numpy as np


def mean_gap(pressure, modulus, rms_height):
    """An exponential, u = u_0 ln(p_c/p), u_0 = 0.4 h_rms and p_c = E*/15: put your theory here."""
    return 0.4 * rms_height * np.log(modulus / 15.0 / pressure)


def area_fraction(pressure, modulus, rms_slope):
    """Persson's error function with 2 in the place of sqrt(8/pi) at small loads."""
    t = np.sqrt(np.pi) * pressure / (modulus * rms_slope)
    s = 1.0 / (1.0 + 0.3275911 * t)  # Abramowitz and Stegun, 7.1.26: to 1.5e-7
    series = np.polyval([1.061405429, -1.453152027, 1.421413741, -0.284496736, 0.254829592], s)
    return 1.0 - s * series * np.exp(-t * t)


def main(folder, table):
    result = asperity.read(folder)
    modulus, height, slope = result.contact_modulus, result.rms_height[0], result.rms_slope[0]
    loads = result["halfspace"].nominal_pressure[0]
    pressure = np.geomspace(loads.min(), loads.max(), 24)
    gap, area = mean_gap(pressure, modulus, height), area_fraction(pressure, modulus, slope)
    np.savetxt(table, np.transpose([pressure * 1e-6, area * 100, gap * 1e9]), delimiter=",",
               header="pressure [MPa],area [%],gap [nm]", comments="")


main(*sys.argv[1:])
