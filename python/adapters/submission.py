"""What the adapters share: reads a problem folder, writes a submission folder.

A code provides prepare(problem), which returns its version and solve(load, tolerance). This
returns the pressure [Pa], shaped as the heights, whether it converged, and any of mean_gap [m],
contact_area_fraction [1], elastic_energy [J/m^2], with adhesion only energy [J/m^2], iterations,
cpu_time [s], peak_memory [bytes], or raises NoAnswer. The loads are solved in their order.
"""
import argparse
import dataclasses
import json
import pathlib
import sys
import time

import numpy as np


class NoAnswer(Exception):
    """A load that the code could not solve; the others are submitted."""


@dataclasses.dataclass
class Problem:
    name: str
    heights: np.ndarray     # [m], [i, j] at y = i length_y / points_y, x = j length_x / points_x
    length_x: float         # [m]
    length_y: float         # [m]
    contact_modulus: float  # E* = E / (1 - nu^2) [Pa]
    loads: list             # nominal pressures [Pa]; with adhesion the path of mean gaps [m]
    is_periodic: bool       # else free boundaries
    folder: pathlib.Path    # that of the problem
    adhesion: tuple = None  # gamma [J/m^2] and rho [m] of the energy -gamma exp(-g/rho)
    element: str = None     # "Q1" or "Q2": set by `prepare` of a code that uses the mesh


def read_problem(folder, any_body, free, adhesive=False):
    """The problem in `folder`; a body that the code does not take is a ValueError."""
    text = json.loads((folder / "problem.json").read_text(encoding="utf-8"))
    if (text.get("format"), text.get("format_version")) != ("asperity-problem", 1):
        raise ValueError("problem.json is not an asperity-problem of format version 1")
    grid, body = text["grid"], text["body"]
    is_half_space = body["thickness [m]"] is None and not body.get("layers")
    if not (is_half_space or any_body) or not (grid["is_periodic"] or free):
        raise ValueError("the body is layered, of finite thickness or not periodic, but this code "
                         f"solves the homogeneous {'' if free else 'periodic '}half-space only")
    law = text.get("adhesion")
    if (law is None) == adhesive:  # None: the code solves both
        raise ValueError("the faces do not attract each other, but this code solves adhesion only"
                         if adhesive else
                         "the faces attract each other, which this code does not solve")
    return Problem(text["name"], np.load(folder / "heights.npy"), grid["length_x [m]"],
                   grid["length_y [m]"], body["contact_modulus [Pa]"],
                   [load["mean_gap [m]" if law else "nominal_pressure [Pa]"]
                    for load in text["loads"]],
                   grid["is_periodic"], folder,
                   law and (law["work_of_adhesion [J/m^2]"], law["range [m]"]))


def toml(**entries):
    """Lines of TOML, which writes strings, lists and finite numbers as JSON does."""
    return "".join(f"{key} = {json.dumps(value, ensure_ascii=False, allow_nan=False)}\n"
                   for key, value in entries.items())


def run(prepare, code, method, tolerances, any_body=False, free=False, adhesive=False, parents=(),
        **head):
    """Solves every load. Exit codes: 0 solved, 2 invalid problem, 3 a load did not converge."""
    parser = argparse.ArgumentParser(description=f"Solve a problem by {code}.", parents=parents)
    parser.add_argument("problem", metavar="PROBLEM_DIR", type=pathlib.Path)
    parser.add_argument("submission", metavar="SUBMISSION_DIR", type=pathlib.Path)
    parser.add_argument("--accuracy", choices=tolerances, default="default")
    parser.add_argument("--tolerance", type=float, help="instead of that of the accuracy")
    parser.add_argument("--author", action="append", help="may be repeated")
    given = parser.parse_args()
    try:
        problem = read_problem(given.problem, any_body, free, adhesive)
        version, solve = prepare(problem)
    except (ValueError, OSError) as mistake:
        print(f"{code}: {given.problem}: {mistake}", file=sys.stderr)
        sys.exit(2)
    tolerance = tolerances[given.accuracy] if given.tolerance is None else given.tolerance
    text = toml(problem=problem.name, code=code, version=version, method=method, **head,
                accuracy=given.accuracy, authors=given.author or ["anonymous"], licence="CC0-1.0",
                **({"element": problem.element} if problem.element else {}))
    given.submission.mkdir(parents=True, exist_ok=True)
    exit_code = 0
    for number, load in enumerate(problem.loads, start=1):
        start, name = time.process_time(), f"pressure-{number}.npy"
        try:
            pressure, converged, claims = solve(load, tolerance)
        except NoAnswer as reason:
            print(f"{code}: load {number}: {reason}", file=sys.stderr)
            exit_code = 3
            continue
        which = {"step": number - 1} if problem.adhesion else {"nominal_pressure": load}
        text += "\n[[load]]\n" + toml(**which, pressure=name,
                                      **{"cpu_time": time.process_time() - start} | claims)
        np.save(given.submission / name, np.ascontiguousarray(pressure))
        if not converged:
            print(f"{code}: load {number} did not converge", file=sys.stderr)
            exit_code = 3
    if "[[load]]" in text:
        (given.submission / "submission.toml").write_text(text, encoding="utf-8")
    sys.exit(exit_code)
