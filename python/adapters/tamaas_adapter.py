#!/usr/bin/env python3
"""Solve an Asperity problem by Tamaas (https://gitlab.com/tamaas/tamaas).

    tamaas_adapter.py PROBLEM_DIR SUBMISSION_DIR [--accuracy best]

Uses the solver PolonskyKeerRey of a periodic `basic_2d` model. The tolerance is that of
the solver, which has no default; "default" is that of the command `tamaas contact`.
"""
import numpy as np

import submission


def prepare(problem):
    import tamaas

    # Tamaas has no units, and its manual recommends numbers near 1: here lengths are in
    # units of length_x and pressures in units of E*. Its order of indices is that of heights.
    # The contact depends on E and nu by E* only.
    length, modulus = problem.length_x, problem.contact_modulus
    heights = np.ascontiguousarray(problem.heights / length)
    model = tamaas.ModelFactory.createModel(
        tamaas.model_type.basic_2d, [problem.length_y / length, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0

    def solve(nominal_pressure, tolerance):
        solver = tamaas.PolonskyKeerRey(model, heights, tolerance)
        solver.max_iter = 5000
        model.traction[...] = 0.0
        error = solver.solve(nominal_pressure / modulus)
        pressure = modulus * np.reshape(model.traction, heights.shape)
        # The solver shifts the displacement, so that the gap in contact is zero.
        gap = length * (np.reshape(model.displacement, heights.shape) - heights)
        claims = {"mean_gap": float(gap.mean()),
                  "contact_area_fraction": float((pressure > 0).mean())}
        return pressure, error <= tolerance, claims

    return tamaas.__version__, solve


if __name__ == "__main__":
    submission.run(prepare, "Tamaas", "FFT boundary elements, conjugate gradients",
                   tolerances={"default": 1e-12, "best": 1e-14})
