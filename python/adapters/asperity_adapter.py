#!/usr/bin/env python3
"""Solve an Asperity problem by Asperity itself, on the grid of the problem.

    asperity_adapter.py PROBLEM_DIR SUBMISSION_DIR [--program PATH] [--method fem.q1]

Needs h5py, and case.toml of the problem for its surface. Slabs and bonded layers are
solved, too. Of an infinitely deep body, finite elements mesh one length, clamped below.
The tolerance is the complementarity error, relative to h_rms and to the load.
"""
import argparse
import functools
import itertools
import json
import re
import subprocess
import sys
import tempfile
import tomllib

import h5py
import numpy as np

import submission

METHODS = {"halfspace": "FFT boundary elements; loads in sequence",
           "fem.q1": "condensed Q1 elements, nu = 0.3 if free; loads in sequence",
           "fem.q2": "condensed Q2 elements, nu = 0.3 if free; loads in sequence; scaled to p_0"}
OPTIONS = argparse.ArgumentParser(add_help=False)
OPTIONS.add_argument("--program", default="./asperity")
OPTIONS.add_argument("--method", choices=METHODS, default="halfspace")
GIVEN = OPTIONS.parse_known_args()[0]
KIND, _, ELEMENT = GIVEN.method.partition(".")


def options(problem, tolerance):
    """Of the case, only the surface remains: its other tables follow from the problem."""
    body = json.loads((problem.folder / "problem.json").read_text(encoding="utf-8"))["body"]
    material = {name: value for name, value in body.items() if value not in (None, [])}
    method = {"contact": "hard", "tolerance": tolerance}
    if problem.adhesion:
        method |= {"contact": "exponential", "work_of_adhesion": problem.adhesion[0],
                   "range": problem.adhesion[1]}
    method |= {} if problem.is_periodic else {"boundaries": "free"}
    if ELEMENT:  # meshed as the case says
        case = tomllib.loads((problem.folder / "case.toml").read_text(encoding="utf-8"))
        method |= {"element": ELEMENT.upper()} | {
            key: value for key, value in case.get("fem", {}).items()
            if key in ("growth", "surface_cell_depth")}
    if "thickness [m]" in material:
        method["depth" if ELEMENT else "thickness"] = material.pop("thickness [m]")
        method["top"] = material.pop("far_boundary")
    tables = {"material": {"poisson_ratio [1]": 0.3} | material, KIND: method,
              "report": {"fields": "all"}}
    if not problem.adhesion:  # whose path is that of the case
        tables["load"] = {"nominal_pressure": problem.loads}
    # From JSON to TOML: "thickness [m]": 1.0 becomes thickness = 1.0.
    texts = {name: re.sub(r'"(\w+)( \[[^]]*\])?": ', r"\1 = ", json.dumps(table))
             for name, table in tables.items()}
    return ["--methods", KIND, "--exactly", "--no-report", "--no-cache", "--threads", "1",
            *(f"--set={name}={text}" for name, text in texts.items())]


def prepare(problem):
    problem.element = ELEMENT.upper() or None

    @functools.cache
    def answers(tolerance):
        with tempfile.TemporaryDirectory() as out:
            exit_code = subprocess.call([
                GIVEN.program, "run", problem.folder / "case.toml", *options(problem, tolerance),
                "--out", out], stdout=sys.stderr)
            if exit_code not in (0, 3):
                sys.exit(exit_code)
            with h5py.File(f"{out}/result.h5") as file:
                answer = file[f"methods/{KIND}/0"]
                curve = {name: column[:].tolist() for name, column in answer["curve"].items()}
                return curve, [answer[f"fields/{step}/pressure"][:] for step in curve["step"]]

    steps = itertools.count()

    def solve(load, tolerance):
        curve, fields = answers(tolerance)
        step = next(steps)
        claims = {name: curve[name][step] for name in ("iterations", "cpu_time")}
        if problem.adhesion:
            claims["energy"] = curve["elastic_energy"][step] + curve["adhesive_energy"][step]
            return fields[step], curve["status"][step] == 0, claims
        # Nodes of Q2 elements have unequal weights, but those of a submission have equal ones.
        pressure = fields[step] * np.float32(load / fields[step].mean(dtype=float))
        return pressure, curve["status"][step] == 0, claims | {"mean_gap": curve["mean_gap"][step]}

    version = subprocess.check_output([GIVEN.program, "--version"], text=True)
    return f"{version.strip()}-{GIVEN.method}", solve


if __name__ == "__main__":
    submission.run(prepare, "Asperity", METHODS[GIVEN.method], {"default": 1e-8, "best": 1e-12},
                   any_body=True, free=not ELEMENT, adhesive=False if ELEMENT else None, parents=[OPTIONS],
                   claimed_error=0.01 if ELEMENT else 0.001)
