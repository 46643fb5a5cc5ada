#!/usr/bin/env python3
"""A complete contact code: a rough surface and an elastic half-space that attract each other.

    numpy_adhesion.py PROBLEM_DIR SUBMISSION_DIR [--tolerance 1e-8] [--anew]

Projected conjugate gradients for the gap, as V. Rey, G. Anciaux and J.-F. Molinari,
Comput. Mech. 60, 69 (2017). The gap g >= 0 of given mean minimises

    U(g) = mean(w K w)/2 - gamma mean(exp(-g/rho)),    w = g + h without its mean,

with the stiffness K of the periodic half-space in Fourier space. Each step of the path starts
from the one before it, the first, or with --anew each, from undeformed surfaces. The gradient is, but for a constant,
the pressure that the law does not carry: zero where the gap is open, positive where it is closed.

A template: replace `prepare` by a call of your code and keep the rest.
"""
import argparse

import numpy as np

import submission

OPTIONS = argparse.ArgumentParser(add_help=False)
OPTIONS.add_argument("--anew", action="store_true", help="start each step anew")
ANEW = OPTIONS.parse_known_args()[0].anew


def of_mean(gap, mean, moves):
    """The gap with the nodes in `moves` shifted to the mean, none of them below the wall."""
    for _ in range(100):
        open_nodes = moves & (gap > 0)
        if not open_nodes.any():
            open_nodes = moves
        excess = (gap.mean() - mean) * gap.size / open_nodes.sum()
        gap = np.where(open_nodes, np.maximum(gap - excess, 0.0), gap)
        if abs(excess) <= 1e-15 * mean:
            break
    return gap


def prepare(problem):
    heights, everywhere = problem.heights, np.ones(problem.heights.shape, bool)
    points_y, points_x = heights.shape
    q_y = 2 * np.pi * np.fft.fftfreq(points_y, problem.length_y / points_y)[:, np.newaxis]
    q_x = 2 * np.pi * np.fft.rfftfreq(points_x, problem.length_x / points_x)
    stiffness = problem.contact_modulus * np.hypot(q_x, q_y) / 2
    work, scale = problem.adhesion
    last = [heights.max() - heights]  # the state before, touching at first

    def elastic(shape):
        return np.fft.irfft2(stiffness * np.fft.rfft2(shape), s=heights.shape)

    def energy(gap):
        shape = gap + heights
        return (shape * elastic(shape)).mean() / 2 - work * np.exp(-gap / scale).mean()

    def solve(mean_gap, tolerance, most_iterations=20000):
        """Ends when the residual, over the stiffness of the shortest waves, is below
        tolerance * h_rms at every node."""
        gap = of_mean(last[0], mean_gap, everywhere)
        direction, old_residual, old_free = np.zeros_like(gap), None, None
        lowest = energy(gap)
        for iterations in range(most_iterations + 1):
            pressure = elastic(gap + heights)
            tension = work / scale * np.exp(-gap / scale)
            residual = pressure + tension
            residual -= residual[gap > 0].mean()
            free = (gap > 0) | (residual < 0)
            residual = np.where(free, residual - residual[free].mean(), 0.0)
            error = np.abs(residual).max() / stiffness.max() / heights.std()
            if error <= tolerance or iterations == most_iterations:
                break
            # Polak and Ribiere, as long as the free nodes are the same.
            factor = 0.0
            if old_free is not None and (free == old_free).all():
                factor = max(0.0, (residual * (residual - old_residual)).sum()
                             / (old_residual ** 2).sum())
            direction = np.where(free, factor * direction - residual, 0.0)
            direction -= np.where(free, direction[free].mean(), 0.0)
            if (direction * residual).sum() >= 0.0:
                direction = -residual
            slope = (direction * residual).sum()
            curvature = (direction * (elastic(direction) - tension / scale * direction)).sum()
            step = -slope / curvature if curvature > 0 else scale / np.abs(direction).max()
            old_residual, old_free = residual, free
            for _ in range(40):
                new = of_mean(np.maximum(gap + step * direction, 0.0), mean_gap, free)
                found = energy(new)
                if found <= lowest + 1e-14 * abs(lowest):
                    break
                step /= 2
            gap, lowest = new, min(lowest, found)
        if not ANEW:
            last[0] = gap
        # At open nodes the pressure is that of the law, which gives its mean.
        pressure -= (pressure + tension)[gap > 0].mean()
        return pressure, error <= tolerance, {"energy": float(energy(gap)), "iterations": iterations}

    return f"1.0-numpy-{np.__version__}{'-anew' if ANEW else ''}", solve


if __name__ == "__main__":
    submission.run(prepare, "numpy_adhesion", "projected conjugate gradients for the gap; "
                   + ("each step from undeformed surfaces" if ANEW else "steps in sequence"),
                   {"default": 1e-6, "best": 1e-9}, adhesive=True, parents=[OPTIONS])
