#!/usr/bin/env python3
"""A complete contact code: hard contact of a rough surface and an elastic half-space.

    numpy_polonsky_keer.py PROBLEM_DIR SUBMISSION_DIR [--tolerance 1e-8]

The conjugate gradients of I. A. Polonsky and L. M. Keer, Wear 231, 206 (1999),
with the periodic half-space in Fourier space. The pressure p >= 0 of given mean
minimises mean(p w)/2 - mean(p h). The gradient is w - h, which the constraint of
the mean fixes up to a constant: this constant is the mean gap.

A template: replace `prepare` by a call of your code and keep the rest.
"""
import numpy as np

import submission


def compliance(problem):
    """w(q) / p(q) = 2 / (E* |q|) for the wave vectors of numpy's rfft2, w(0) = 0."""
    points_y, points_x = problem.heights.shape
    q_y = 2 * np.pi * np.fft.fftfreq(points_y, problem.length_y / points_y)[:, np.newaxis]
    q_x = 2 * np.pi * np.fft.rfftfreq(points_x, problem.length_x / points_x)
    wavevector = np.hypot(q_x, q_y)
    wavevector[0, 0] = np.inf
    return 2 / (problem.contact_modulus * wavevector)


def prepare(problem):
    heights = problem.heights
    kernel = compliance(problem)

    def displacement(pressure):
        return np.fft.irfft2(kernel * np.fft.rfft2(pressure), s=heights.shape)

    def solve(nominal_pressure, tolerance, most_iterations=5000):
        """Ends when no gap in contact and no penetration exceeds tolerance * h_rms."""
        pressure = np.full_like(heights, nominal_pressure)
        direction, last_square, conjugate = np.zeros_like(heights), 1.0, False
        for iterations in range(most_iterations + 1):
            contact = pressure > 0
            residual = displacement(pressure) - heights
            mean_gap = -residual[contact].mean()
            gap = residual + mean_gap
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
            step = (gap * direction).sum() / curvature if curvature > 0 else 1 / kernel.max()
            pressure = np.maximum(pressure - step * direction, 0.0)
            # Nodes without pressure that penetrate come into contact, which ends conjugacy.
            penetrates = (pressure == 0) & (gap < 0)
            pressure[penetrates] = -step * gap[penetrates]
            conjugate = not penetrates.any()
            pressure *= nominal_pressure / pressure.mean()
        energy = (pressure * displacement(pressure)).mean() / 2
        claims = {"mean_gap": float(mean_gap), "contact_area_fraction": float(contact.mean()),
                  "elastic_energy": float(energy), "iterations": iterations}
        return pressure, error <= tolerance, claims

    return f"1.0-numpy-{np.__version__}", solve


if __name__ == "__main__":
    submission.run(prepare, "numpy_polonsky_keer", "FFT boundary elements, conjugate gradients",
                   tolerances={"default": 1e-8, "best": 1e-12})
