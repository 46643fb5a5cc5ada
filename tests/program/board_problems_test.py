"""Every problem of the board is the one that its reference solves: `problem` certifies the
reference through the files before it writes them, and so does whoever imports an answer.

Large grids are replaced by small ones, with the same body and boundaries.

Arguments: asperity, an empty folder, the folder of the board.
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy

PROGRAM, FOLDER, BOARD = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
SMALL = ("--set", "surface.points=64")
WAVES = (*SMALL, "--set", 'surface.wavelength_short="4 h"')
ROUGH = ("challenge", "free-rough", "layered", "near-full-contact", "polymer", "self-affine-h03",
         "self-affine-h08-4", "self-affine-h08-8", "self-affine-h08-16", "self-affine-peer")


def asperity(*arguments, expected=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=FOLDER, text=True, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == expected, (arguments, done.returncode, done.stdout)
    return done.stdout


def overrides(name):
    if name.startswith("fe-"):
        return ()
    return WAVES if name in ROUGH else SMALL


def check_all():
    names = sorted(path.parent.name for path in BOARD.glob("*/case.toml"))
    assert len(names) >= 22 and set(ROUGH) <= set(names), names
    for name in names:
        asperity("problem", BOARD / name / "case.toml", "--out", name, "--quiet",
                 *overrides(name))
        problem = json.loads((FOLDER / name / "problem.json").read_text())
        assert problem["name"] == name
        assert problem["grid"]["is_periodic"] != name.startswith("free-"), name
        assert bool(problem["body"]["layers"]) == (name in ("fe-coated", "layered")), name


def write_answer(folder, problem, pressures):
    folder.mkdir()
    text = (f'problem = "{problem["name"]}"\ncode = "other"\nversion = "1"\nmethod = "solver"\n'
            'accuracy = "best"\nauthors = ["A. Name"]\nlicence = "CC0-1.0"\n')
    for i, (load, pressure) in enumerate(zip(problem["loads"], pressures)):
        numpy.save(folder / f"p{i}.npy", pressure)
        text += (f'[[load]]\nnominal_pressure = {load["nominal_pressure [Pa]"]!r}\n'
                 f'pressure = "p{i}.npy"\n')
    (folder / "submission.toml").write_text(text)


def check_mutation():
    """The fields of the layered problem do not answer the same files with the plain half-space."""
    import h5py
    asperity("run", BOARD / "layered" / "case.toml", "--out", "solved", "--no-report", "--quiet",
             *WAVES, "--set", 'report.precision="double"')
    with h5py.File(FOLDER / "solved/result.h5") as file:
        fields = file["methods/halfspace/0/fields"]
        pressures = [fields[step]["pressure"][...] for step in sorted(fields, key=int)]
    problem = json.loads((FOLDER / "layered/problem.json").read_text())
    write_answer(FOLDER / "answer", problem, pressures)
    asperity("import", "answer", "--problem", "layered", "--out", "right")

    shutil.copytree(FOLDER / "layered", FOLDER / "plain")
    problem["body"]["layers"] = []
    text = json.dumps(problem, indent=2)
    (FOLDER / "plain/problem.json").write_text(text)
    sums = (FOLDER / "plain/SHA256SUMS").read_text().splitlines()
    sums = [line for line in sums if not line.endswith("problem.json")]
    sums.append(f"{hashlib.sha256(text.encode()).hexdigest()}  problem.json")
    (FOLDER / "plain/SHA256SUMS").write_text("\n".join(sums) + "\n")
    (FOLDER / "plain/case.toml").unlink(missing_ok=True)
    sums = [line for line in sums if not line.endswith("case.toml")]
    (FOLDER / "plain/SHA256SUMS").write_text("\n".join(sums) + "\n")
    answer = asperity("import", "answer", "--problem", "plain", "--out", "wrong", expected=1)
    assert "does not hold: the mean gap" in answer, answer


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    os.environ["ASPERITY_CACHE_SIZE"] = "0"
    check_all()
    check_mutation()


main()
