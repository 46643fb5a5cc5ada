"""Every adapter is short, compiles, and refuses bodies other than a half-space, by exit
code 2 and a message, before it needs the code that it calls. Those that solve other bodies
refuse a problem of another format, and those of meshes one without a mesh.

Arguments: the folder of the adapters, a folder for the problems.
"""
import pathlib
import py_compile
import shutil
import sys

import numpy as np

from problem_folder import start, write_problem

MOST_LINES = 135  # with the deck of a finite-element code
SHARED = ("submission.py", "meshed.py", "compare_times.py")
OF_ANY_BODY = ("asperity_adapter.py", "calculix_adapter.py", "getfem_adapter.py")
OF_FREE_BOUNDARIES = ("numpy_polonsky_keer.py", "slippy_adapter.py")
LAYER = {"thickness [m]": 1e-6, "youngs_modulus [Pa]": 1e9, "poisson_ratio": 0.3}


def check_source(source):
    lines = len(source.read_text(encoding="utf-8").splitlines())
    assert lines <= MOST_LINES, f"{source.name} has {lines} lines, but at most {MOST_LINES} may be"
    py_compile.compile(source, cfile=WORK / (source.name + "c"), doraise=True)


def check_refused(adapter, problem, message):
    submission = WORK / f"{adapter.stem}-{problem.name}"
    done = start(adapter, problem, submission)
    assert done.returncode == 2, (adapter.name, done.returncode, done.stdout)
    assert message in done.stdout and "Traceback" not in done.stdout, (adapter.name, done.stdout)
    assert not submission.exists(), f"{adapter.name} wrote a submission"


def main():
    sources = sorted(FOLDER.glob("*.py"))
    adapters = [source for source in sources if source.name not in SHARED]
    assert len(adapters) == 8, sources
    for source in sources:
        check_source(source)
    flat, side = np.zeros((4, 6)), (3e-6, 2e-6)
    no_half_space = "the homogeneous half-space only"
    refused = (
        (write_problem(WORK / "layered", flat, *side, [1e6], layers=[LAYER]), no_half_space),
        (write_problem(WORK / "finite", flat, *side, [1e6], thickness=1e-6), no_half_space),
        (write_problem(WORK / "future", flat, *side, [1e6], version=2), "format version 1"),
        (WORK / "missing", "No such file"))
    free = write_problem(WORK / "free", flat, *side, [1e6], is_periodic=False)
    sticky = write_problem(WORK / "sticky", flat, *side, [1e-7], adhesion=(0.05, 1e-9))
    check_refused(FOLDER / "numpy_polonsky_keer.py", sticky, "the faces attract each other, which")
    check_refused(FOLDER / "numpy_adhesion.py", write_problem(WORK / "hard", flat, *side, [1e6]),
                  "the faces do not attract each other, but this code solves adhesion only")
    for problem, message in refused:
        check_refused(FOLDER / "numpy_polonsky_keer.py", problem, message)
    for adapter in adapters:
        if adapter.name in OF_ANY_BODY:
            check_refused(adapter, *refused[2])
        elif adapter.name in OF_FREE_BOUNDARIES:
            check_refused(adapter, *refused[0])
        else:
            check_refused(adapter, free, "the homogeneous periodic half-space only")
    for name in OF_ANY_BODY[1:]:
        check_refused(FOLDER / name, refused[1][0], "there is no mesh, which 'asperity problem --mesh'")


FOLDER, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
main()
