#!/usr/bin/env python3
"""Solve an Asperity problem by slippy (https://github.com/FrictionTribologyEnigma/slippy).

    slippy_adapter.py PROBLEM_DIR SUBMISSION_DIR [--accuracy best]

Uses slippy.core: the influence matrix of an elastic half-space in the frequency
domain, whose value at zero frequency is set to 0, and its circular convolution, or with
free boundaries the influence matrix of pressed cells, which is right for square cells
only; and its solver by Polonsky and Keer. The tolerance is the relative change of the pressure in
one iteration.
"""
import sys

import numpy as np

import submission


def prepare(problem):
    import slippy
    slippy.CUDA = False
    from slippy import core

    points_y, points_x = problem.heights.shape
    spacing = (problem.length_y / points_y, problem.length_x / points_x)
    # The contact depends on E and nu by E* only.
    if problem.is_periodic:
        body = core.Elastic("body", {"E": problem.contact_modulus, "v": 0.0},
                            zero_frequency_value=0.0)
        influence = body.influence_matrix(["zz"], spacing, problem.heights.shape)["zz"]
    elif abs(spacing[0] / spacing[1] - 1) > 1e-9:
        sys.exit("slippy: with free boundaries the cells must be squares")
    else:
        influence = core.elastic_influence_matrix_spatial(
            "zz", (2 * points_y, 2 * points_x), spacing, problem.contact_modulus / 2, 0.0)
    displacement = core.plan_convolve(problem.heights, influence, circular=problem.is_periodic,
                                      fft_im=problem.is_periodic)
    just_touching_gap = problem.heights.max() - problem.heights

    def solve(nominal_pressure, tolerance):
        # slippy measures the load as a force, and starts from a pressure of any scale.
        force = nominal_pressure * problem.length_x * problem.length_y
        failed, pressure, gap = core.polonsky_and_keer(
            displacement, np.ones_like(problem.heights), just_touching_gap, force, spacing,
            eps_0=tolerance)
        claims = {"mean_gap": float(gap.mean()),
                  "contact_area_fraction": float((pressure > 0).mean())}
        return pressure, not failed, claims

    return slippy.__version__, solve


if __name__ == "__main__":
    submission.run(prepare, "slippy", "FFT boundary elements, conjugate gradients",
                   tolerances={"default": 1e-6, "best": 1e-12}, free=True)
