"""The adapter of Asperity writes solutions that Asperity certifies: for each of its methods,
on a half-space, a slab and a layered body, from cases that have the half-space alone.

Arguments: the folder of the adapters, a folder for the problems, asperity.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tomllib

import numpy as np

from problem_folder import start

CASE = """schema = 1
title = "A small rough surface"
[surface]
kind = "self-affine"
length = "1 um"
points = 64
seed = 1
realizations = 2
rms_height = "3 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "8 h"
[load]
{load}
[material]
contact_modulus = "2 GPa"
{material}
[halfspace]
{method}
"""
PRESSURES = 'nominal_pressure = ["0.002 E*", "0.02 E*"]'
LAYER = """poisson_ratio = 0.25
layers = [{ thickness = "0.05 length", youngs_modulus = "10 GPa", poisson_ratio = 0.4 }]
"""


def asperity(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, (arguments, done.returncode, done.stdout)


def problem_of(name, load=PRESSURES, material="", method=""):
    case = WORK / name / "case.toml"
    case.parent.mkdir(parents=True)
    case.write_text(CASE.format(load=load, material=material, method=method), encoding="utf-8")
    asperity("problem", case, "--out", case.parent / "problem")
    return case.parent / "problem"


def gap_errors(problem, *options):
    """The bounds of the mean gaps [h_rms] of a solution whose stated numbers all hold."""
    folder = problem.parent / "-".join(("answer", *options))
    done = start(ADAPTER, problem, folder, "--program", PROGRAM, *options)
    assert done.returncode == 0, (done.returncode, done.stdout)
    asperity("import", folder, "--problem", problem, "--out", folder / "out")
    submission = tomllib.loads((folder / "submission.toml").read_text(encoding="utf-8"))
    for load in submission["load"]:
        assert np.load(folder / load["pressure"]).dtype == np.float32, load
        assert 0 < load["cpu_time"] < 60 and load["iterations"] > 0, load
    certificate = json.loads((folder / "out/certificate.json").read_text(encoding="utf-8"))
    assert len(certificate["loads"]) == 2, certificate
    return [load["mean_gap_error [m]"] / load["rms_height [m]"] for load in certificate["loads"]]


def check_methods(problem):
    """Each method solves the problem. The half-space solves it on its own grid, to the
    accuracy of the certificate on fields in single precision; elements have a
    discretisation error, which `import` compares with the stated 0.01 h_rms."""
    assert max(gap_errors(problem)) < 1e-5
    assert max(gap_errors(problem, "--accuracy", "best")) < 1e-5
    by_element = [gap_errors(problem, "--method", method) for method in ("fem.q1", "fem.q2")]
    assert min(map(min, by_element)) > 1e-5 and by_element[0] != by_element[1], by_element


def check_refused_by_the_program(problem):
    """What the program refuses ends with its exit code and leaves no submission."""
    folder = problem.parent / "refused"
    done = start(ADAPTER, problem, folder, "--program", PROGRAM, "--tolerance", "1")
    assert done.returncode == 2 and "tolerance" in done.stdout, (done.returncode, done.stdout)
    assert not (folder / "submission.toml").exists()


ADAPTER = pathlib.Path(sys.argv[1]).resolve() / "asperity_adapter.py"
WORK = pathlib.Path(sys.argv[2]).resolve()
PROGRAM = sys.argv[3]
shutil.rmtree(WORK, ignore_errors=True)
half_space = problem_of("half-space")
check_methods(half_space)
check_methods(problem_of("slab", load='mean_gap = ["1 h_rms", "0.4 h_rms"]',
                         material="poisson_ratio = 0.4",
                         method='thickness = "0.3 length"\ntop = "sliding"'))
check_methods(problem_of("layered", material=LAYER))
check_refused_by_the_program(half_space)
