#!/usr/bin/env python3
"""A complete contact code: hard contact of a rough surface and an elastic half-space.

    numpy_polonsky_keer.py PROBLEM_DIR SUBMISSION_DIR [--tolerance 1e-8]

The conjugate gradients of I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999),
with the half-space in Fourier space: periodic, or by a convolution without
periodic images on the doubled grid. The pressure p >= 0 of given mean
minimises mean(p w)/2 - mean(p h). The gradient is w - h, which the constraint of
the mean fixes up to a constant: this constant is the separation, and on a
periodic surface the mean gap.

A template: replace `prepare` by a call of your code and keep the rest.
"""
import numpy as np

import submission


def compliance(problem):
    """The compliance C of wave vectors for numpy's rfft2, and the grid of this transform.

    Periodic: C = 2 / (E* |q|), C(0) = 0. Free boundaries: the transform of the displacement
    around a uniformly pressed cell, on a grid doubled in both directions.
    """
    points_y, points_x = problem.heights.shape
    spacing_y, spacing_x = problem.length_y / points_y, problem.length_x / points_x
    if problem.is_periodic:
        q_y = 2 * np.pi * np.fft.fftfreq(points_y, spacing_y)[:, np.newaxis]
        wavevector = np.hypot(2 * np.pi * np.fft.rfftfreq(points_x, spacing_x), q_y)
        wavevector[0, 0] = np.inf
        return 2 / (problem.contact_modulus * wavevector), (points_y, points_x)
    y = spacing_y * (np.arange(-points_y, points_y + 1)[:, np.newaxis] - 0.5)
    x = spacing_x * (np.arange(-points_x, points_x + 1) - 0.5)
    at_corners = x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
    around = np.diff(np.diff(at_corners, axis=0)) / (np.pi * problem.contact_modulus)
    return np.fft.rfft2(np.fft.ifftshift(around)), around.shape


def prepare(problem):
    heights = problem.heights
    kernel, grid = compliance(problem)

    def displacement(pressure):
        wide = np.fft.irfft2(kernel * np.fft.rfft2(pressure, s=grid), s=grid)
        return wide[:heights.shape[0], :heights.shape[1]]

    def solve(nominal_pressure, tolerance, most_iterations=5000):
        """Ends when no gap in contact and no penetration exceeds tolerance * h_rms."""
        pressure = np.full_like(heights, nominal_pressure)
        direction, last_square, conjugate = np.zeros_like(heights), 1.0, False
        for iterations in range(most_iterations + 1):
            contact = pressure > 0
            residual = displacement(pressure) - heights
            gap = residual - residual[contact].mean()
            error = max(np.abs(gap[contact]).max(), -gap.min()) / heights.std()
            if error <= tolerance or iterations == most_iterations:
                break
            # The direction is conjugate to the last one while the contact only loses nodes.
            square = (gap[contact] ** 2).sum()
            factor = square / last_square if conjugate else 0.0
            direction = np.where(contact, gap + factor * direction, 0.0)
            last_square = square
            # The step minimises the energy along the direction, at constant mean pressure.
            change = displacement(direction)
            change -= change[contact].mean()
            curvature = (change * direction).sum()
            least = 1 / np.abs(kernel).max()
            step = (gap * direction).sum() / curvature if curvature > 0 else least
            pressure = np.maximum(pressure - step * direction, 0.0)
            # Nodes without pressure that penetrate come into contact, which ends conjugacy.
            penetrates = (pressure == 0) & (gap < 0)
            pressure[penetrates] = -step * gap[penetrates]
            conjugate = not penetrates.any()
            pressure *= nominal_pressure / pressure.mean()
        energy = (pressure * displacement(pressure)).mean() / 2
        claims = {"mean_gap": float(gap.mean()), "contact_area_fraction": float(contact.mean()),
                  "elastic_energy": float(energy), "iterations": iterations}
        return pressure, error <= tolerance, claims

    return f"1.0-numpy-{np.__version__}", solve


if __name__ == "__main__":
    submission.run(prepare, "numpy_polonsky_keer", "FFT boundary elements, conjugate gradients",
                   tolerances={"default": 1e-8, "best": 1e-12}, free=True)
