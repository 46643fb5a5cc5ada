"""The numpy template solves the contact problem: on a wave it gives Westergaard's
solution, and on a rough surface its fields satisfy the conditions of contact.

Arguments: the folder of the adapters, a folder for the problems.
"""
import math
import pathlib
import shutil
import sys
import tomllib

import numpy as np

from problem_folder import MODULUS, start, write_problem


def solved(problem, *options, exit_code=0):
    """The loads of the template's submission, each with its field of pressures."""
    folder = problem.with_name(problem.name + "-answer")
    done = start(TEMPLATE, problem, folder, *options)
    assert done.returncode == exit_code, (done.returncode, done.stdout)
    submission = tomllib.loads((folder / "submission.toml").read_text(encoding="utf-8"))
    assert submission["problem"] == problem.name, submission
    assert submission["accuracy"] == ("best" if "best" in options else "default"), submission
    return [load | {"field": np.load(folder / load["pressure"])} for load in submission["load"]]


def check_westergaard():
    """Verifies the mean gap D (1 - P + P ln P) and the contact fraction (2/pi) asin sqrt(P).

    Tolerances: each of the two edges of the contact lies within one spacing of a node, so
    the fraction is uncertain by 2/n. The pressure vanishes like a square root at an edge,
    so the error of the mean gap is C D/n^2. Measured at 20 loads and n = 64 to 1024: C is at most
    2.9, without a trend in n, and the fraction errs by at most 1.4/n.
    """
    amplitude, length, width = 4e-9, 1e-6, 3e-7
    shares = (0.001, 0.02, 0.1, 0.5, 0.9, 0.99)
    loads = [share * math.pi * MODULUS * amplitude / length for share in shares]
    for points in (64, 256):
        wave = amplitude * np.cos(2 * math.pi * np.arange(points) / points)
        along_x = write_problem(WORK / f"x-{points}", np.tile(wave, (6, 1)), length, width, loads)
        along_y = write_problem(WORK / f"y-{points}", np.tile(wave, (6, 1)).T, width, length, loads)
        for load, share in zip(solved(along_x) + solved(along_y), shares + shares, strict=True):
            gap = amplitude * (1 - share + share * math.log(share))
            fraction = 2 / math.pi * math.asin(math.sqrt(share))
            assert abs(load["mean_gap"] - gap) < 4 * amplitude / points**2, (points, share, load)
            assert abs(load["contact_area_fraction"] - fraction) < 2 / points, (points, share, load)


def wavevectors(points, length):
    """The signed wave vectors of the grid and the matrix of its discrete Fourier transform."""
    order = np.arange(points)
    signed = np.where(order <= points // 2, order, order - points)
    transform = np.exp(-2j * math.pi * np.outer(order, order) / points)
    return 2 * math.pi / length * signed, transform


class HalfSpace:
    """w(q) = 2 p(q) / (E* |q|) by sums over all nodes, without a fast Fourier transform."""

    def __init__(self, points_x, points_y, length_x, length_y):
        q_x, self.transform_x = wavevectors(points_x, length_x)
        q_y, self.transform_y = wavevectors(points_y, length_y)
        self.stiffness = MODULUS / 2 * np.sqrt(q_x[np.newaxis, :]**2 + q_y[:, np.newaxis]**2)

    def multiplied(self, factor, field):
        # The mean has no part in the result, but would add its rounding.
        spectrum = factor * (self.transform_y @ (field - field.mean()) @ self.transform_x)
        return (self.transform_y.conj() @ spectrum @ self.transform_x.conj()).real / field.size

    def displacement(self, pressure):
        with np.errstate(divide="ignore"):
            compliance = np.where(self.stiffness > 0, 1 / self.stiffness, 0)
        return self.multiplied(compliance, pressure)

    def pressure(self, displacement):
        return self.multiplied(self.stiffness, displacement)


class FreeHalfSpace:
    """The sum over the pressed cells of the displacement at the other nodes."""

    def __init__(self, points_x, points_y, length_x, length_y):
        a, b = length_x / points_x / 2, length_y / points_y / 2
        x, y = (np.subtract.outer(of, of) for of in np.meshgrid(
            2 * a * np.arange(points_x), 2 * b * np.arange(points_y)))
        x, y = (of.reshape(points_x * points_y, -1) for of in (x, y))
        self.matrix = sum(
            sign * (u * np.log((v + np.hypot(u, v)) / np.abs(u))
                    + v * np.log((u + np.hypot(u, v)) / np.abs(v)))
            for u, v, sign in ((x + a, y + b, 1), (x - a, y + b, -1), (x + a, y - b, -1),
                               (x - a, y - b, 1))) / (math.pi * MODULUS)

    def displacement(self, pressure):
        return (self.matrix @ pressure.ravel()).reshape(pressure.shape)


def rough_surface(points, rms_height):
    """White noise, filtered to a self-affine spectrum with a roll-off at 3 wavelengths."""
    noise = np.fft.fft2(np.random.default_rng(7).standard_normal((points, points)))
    order = np.fft.fftfreq(points, 1 / points)
    heights = np.fft.ifft2(noise * np.maximum(np.hypot(order, order[:, np.newaxis]), 3)**-1.8).real
    heights -= heights.mean()
    return heights * rms_height / heights.std()


def check_conditions(body, heights, loads, answers, tolerance):
    """Verifies p >= 0, gap >= 0, p gap = 0 and mean(p) = p0, and that the numbers stated in the
    submission follow from the pressure.

    Tolerances: the template's own, of every gap over h_rms, and 1e-13 of the compared number
    for the rounding of sums over 2304 nodes (measured: at most 3e-14).
    """
    tolerated = (tolerance + 1e-13) * heights.std()
    for load, answer in zip(loads, answers, strict=True):
        pressure = answer["field"]
        displacement = body.displacement(pressure)
        gap = answer["mean_gap"] + displacement - displacement.mean() - heights
        energy = (pressure * displacement).mean() / 2

        assert answer["nominal_pressure"] == load, answer
        assert pressure.min() >= 0 and abs(pressure.mean() / load - 1) < 1e-13, answer
        assert gap.min() > -tolerated, (gap.min(), answer)
        assert np.abs(gap[pressure > 0]).max() < tolerated, (gap, answer)
        assert answer["contact_area_fraction"] == (pressure > 0).mean(), answer
        assert abs(answer["elastic_energy"] / energy - 1) < 1e-13, (energy, answer)
        assert 0 <= answer["cpu_time"] < 60, answer


def check_rough_surface():
    """Solves from one node in contact to full contact in few iterations: at most 100 are needed
    here, and 500 if the search directions are not conjugate."""
    points, length_x, length_y = 48, 1e-6, 1.5e-6
    heights = rough_surface(points, 3e-9)
    body = HalfSpace(points, points, length_x, length_y)
    full_contact = -body.pressure(heights).min()
    loads = full_contact * np.array([1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9, 0.9999, 1.0001, 10])
    problem = write_problem(WORK / "rough", heights, length_x, length_y, loads)
    for options, tolerance in (((), 1e-8), (("--accuracy", "best"), 1e-12),
                               (("--tolerance", "1e-5"), 1e-5)):
        answers = solved(problem, *options)
        fractions = [answer["contact_area_fraction"] for answer in answers]
        assert fractions[0] == 1 / points**2 and fractions[-2:] == [1, 1], fractions
        assert max(answer["iterations"] for answer in answers) < 200, answers
        check_conditions(body, heights, loads, answers, tolerance)


def check_free_boundaries():
    """The conditions of contact hold with the sum over pressed cells, which are no squares."""
    points_x, points_y, length_x, length_y = 20, 16, 1e-6, 1.5e-6
    heights = rough_surface(points_x, 3e-9)[:points_y]
    heights -= heights.mean()
    loads = [1e4, 1e6, 1e8]
    problem = write_problem(WORK / "free", heights, length_x, length_y, loads, is_periodic=False)
    body = FreeHalfSpace(points_x, points_y, length_x, length_y)
    check_conditions(body, heights, loads, solved(problem), 1e-8)


def check_pin():
    """Solves a problem in which the iteration arrives at one node in contact, whose gap is zero
    however far others penetrate: one high node of a plane, at a load that this node and the
    node farthest from it carry."""
    heights = 1e-9 * np.array([[2.25, -0.75, -0.75, -0.75]])
    problem = write_problem(WORK / "pin", heights, 4e-6, 1e-6, [1.2e6])
    answers = solved(problem)
    assert answers[0]["contact_area_fraction"] == 2 / 4, answers
    check_conditions(HalfSpace(4, 1, 4e-6, 1e-6), heights, [1.2e6], answers, 1e-8)


def check_no_convergence():
    """A tolerance below roundoff ends with exit code 3, and the solution is written."""
    heights = rough_surface(8, 1e-9)
    problem = write_problem(WORK / "impossible", heights, 1e-6, 1e-6, [1e7])
    assert len(solved(problem, "--tolerance", "0", exit_code=3)) == 1


TEMPLATE = pathlib.Path(sys.argv[1]).resolve() / "numpy_polonsky_keer.py"
WORK = pathlib.Path(sys.argv[2]).resolve()
shutil.rmtree(WORK, ignore_errors=True)
check_westergaard()
check_rough_surface()
check_free_boundaries()
check_pin()
check_no_convergence()
