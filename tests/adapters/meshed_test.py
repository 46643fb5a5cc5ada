"""Finite-element codes answer as our own elements do on the same mesh: on one rectangular grid
of a rough surface, at a partial and at full contact, through the deck that the adapter writes.

Arguments: the adapter, a folder for the problems, asperity.
"""
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys
import tomllib

import numpy as np

from problem_folder import start

CASE = """schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 8
seed = 3
rms_height = "3 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "4 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["0.01 E*", "0.2 E*"]
[fem]
element = "Q1"
depth = "0.5 length"
"""


def loads_of(folder):
    found = tomllib.loads((folder / "submission.toml").read_text(encoding="utf-8"))["load"]
    return [load | {"field": np.load(folder / load["pressure"])} for load in found]


def problem_of(element):
    folder = WORK / element
    subprocess.run([PROGRAM, "problem", WORK / "case.toml", f"--set=fem.element={element}",
                    "--mesh", "--out", folder / "problem"],
                   check=True, timeout=300, stdout=subprocess.DEVNULL)
    return folder / "problem"


def check(problem, options, tolerance):
    """The difference is that of the springs, which the tolerance of the code bounds."""
    ours, theirs = problem.parent / "ours", problem.parent / "theirs"
    done = start(ADAPTER.parent / "asperity_adapter.py", problem, ours, "--program", PROGRAM,
                 "--method", f"fem.{problem.parent.name.lower()}", "--accuracy", "best")
    assert done.returncode == 0, done.stdout
    done = start(ADAPTER, problem, theirs, *options)
    assert done.returncode == 0, done.stdout
    height = np.load(problem / "heights.npy").std()
    for mine, other in zip(loads_of(ours), loads_of(theirs), strict=True):
        field = mine["field"].astype(float)
        error = np.abs(field - other["field"]).max() / field.max()
        assert error < tolerance, (error, options)
        assert np.abs(field - other["field"].T).max() / field.max() > 0.1
        assert abs(mine["mean_gap"] - other["mean_gap"]) < tolerance * height, (mine, other)
        assert abs(other["field"].mean() / other["nominal_pressure"] - 1) < 1e-6, other
        assert other["iterations"] >= 1 and other["cpu_time"] > 0 and other["peak_memory"] > 1e6
    assert 0 < loads_of(theirs)[0]["contact_area_fraction"] < 1
    assert loads_of(theirs)[1]["contact_area_fraction"] == 1


def check_certificate(problem):
    """On the elements of the same mesh the answers are certified as nearly exact."""
    folder = problem.parent / "theirs"
    for arguments in (["import", folder, "--problem", problem, "--out", folder / "out", "--quiet"],
                      ["certify", folder / "out", "--json"]):
        done = subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=300,
                              stdout=subprocess.PIPE, check=False)
        assert done.returncode in ((0, 1) if arguments[0] == "import" else (0,)), done
    for field in json.loads(done.stdout):
        scale = field["rms_height [m]"] * field["nominal_pressure [Pa]"]
        assert field["duality_gap [J/m^2]"] < 1e-5 * scale, field


def check_board(problem):
    """The board certifies an answer with the compliance of its mesh, too, whose error is not that
    of the elements against the continuum."""
    board = problem.parent / "board"
    name = json.loads((problem / "problem.json").read_text(encoding="utf-8"))["name"]
    (board / name).mkdir(parents=True)
    shutil.copy(problem / "case.toml", board / name)
    shutil.copytree(problem.parent / "theirs", board / "submissions" / name / "code/1",
                    ignore=shutil.ignore_patterns("out"))
    done = subprocess.run([PROGRAM, "board", board, "--out", board / "site"], timeout=300, check=False,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode in (0, 1), done.stdout  # 1: a claim does not hold on this coarse grid
    row = json.loads((board / "site/board.json").read_text(encoding="utf-8"))[0]
    assert row["element"] == problem.parent.name and row["mesh_error [h_rms]"] < 1e-5, row
    assert row["continuum_error [h_rms]"] > 1e-3 and row["gap_error [h_rms]"] > 1e-3, row


def check_limits(problem):
    """A code that exceeds its time has no answer, which is said, and nothing is submitted."""
    done = start(ADAPTER, problem, problem.parent / "late", "--seconds", "0.001")
    assert done.returncode == 3 and "needs more than 0.001 s" in done.stdout, done.stdout
    assert "Traceback" not in done.stdout, done.stdout
    assert not (problem.parent / "late/submission.toml").exists()


ADAPTER, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
PROGRAM = sys.argv[3]
if ADAPTER.name.startswith("calculix") and not shutil.which("ccx"):
    print("skipped: needs calculix-ccx")
    sys.exit(77)
if ADAPTER.name.startswith("getfem") and not importlib.util.find_spec("getfem"):
    print("skipped: needs python3-getfem++")
    sys.exit(77)
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
(WORK / "case.toml").write_text(CASE, encoding="utf-8")
linear = problem_of("Q1")
check(linear, ["--accuracy", "best"], 2e-5)
check_certificate(linear)
check_board(linear)
check_limits(linear)
if ADAPTER.name.startswith("getfem"):
    second = problem_of("Q2")
    check(second, ["--accuracy", "best"], 2e-5)
    check_board(second)
else:
    refused = start(ADAPTER, problem_of("Q2"), WORK / "refused")
    assert refused.returncode == 2 and "the mesh is for Q2" in refused.stdout, refused.stdout
