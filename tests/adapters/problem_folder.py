"""Problem folders for the tests of the adapters, and the start of an adapter."""
import json
import os
import subprocess
import sys

import numpy as np

MODULUS = 2e9  # E* [Pa]


def write_problem(folder, heights, length_x, length_y, loads, thickness=None, layers=(), version=1,
                  is_periodic=True, adhesion=None):
    """Writes the parts of a problem folder that a solver needs: heights [m], lengths [m], loads
    [Pa], or the mean gaps [m] with adhesion, its work [J/m^2] and range [m]."""
    folder.mkdir(parents=True)
    np.save(folder / "heights.npy", heights)
    points_y, points_x = heights.shape
    problem = {
        "format": "asperity-problem", "format_version": version, "name": folder.name,
        "grid": {"points_x": points_x, "points_y": points_y, "length_x [m]": length_x,
                 "length_y [m]": length_y, "is_periodic": is_periodic},
        "body": {"contact_modulus [Pa]": MODULUS, "poisson_ratio": 0.3,
                 "thickness [m]": thickness, "layers": list(layers)},
        "loads": [{"load": number, "mean_gap [m]" if adhesion else "nominal_pressure [Pa]":
                   float(load)} for number, load in enumerate(loads, start=1)]}
    if adhesion:
        problem["adhesion"] = {"work_of_adhesion [J/m^2]": adhesion[0], "range [m]": adhesion[1]}
    (folder / "problem.json").write_text(json.dumps(problem), encoding="utf-8")
    return folder


def start(adapter, problem, submission, *options):
    return subprocess.run(
        [sys.executable, adapter, problem, submission, *options], text=True, timeout=300,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"})
