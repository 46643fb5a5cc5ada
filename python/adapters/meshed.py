"""What the adapters of finite-element codes share: reads the mesh of a problem, and runs a
program within limits of time and memory.

Lengths are in units of the spacing along x and moduli in units of E*, because tolerances of
such codes are often absolute.
"""
import argparse
import dataclasses
import json
import os
import pathlib
import resource
import subprocess
import time

import numpy as np

import submission

OPTIONS = argparse.ArgumentParser(add_help=False)
OPTIONS.add_argument("--seconds", type=float, default=3600, help="limit of time for one load")
OPTIONS.add_argument("--memory", type=float, default=8, help="limit of its memory [GiB]")
OPTIONS.add_argument("--mesh", type=pathlib.Path, metavar="DIR",
                     help="take the mesh of this folder of the same problem, written with "
                     "--set fem.element=Q2, for example")


@dataclasses.dataclass
class Mesh:
    element: str           # "Q1" or "Q2"
    nodes: np.ndarray      # [spacings], rows in the order of the numbers 1, 2, ...
    shape: tuple           # nodes along z, y, x
    groups: list           # of (name, cells, E [E*], nu); a cell is its number and eight nodes
    far_boundary: str      # "clamped" or "sliding"
    spacing: float         # [m]
    heights: np.ndarray    # [spacings]
    depth: float           # [spacings]
    area: float            # of a node of the contact surface [spacings^2]


def read_mesh(problem, folder=None):
    """The mesh beside problem.json; one that no adapter can use is a ValueError."""
    folder = folder or problem.folder
    text = json.loads((folder / "problem.json").read_text(encoding="utf-8"))
    if not np.array_equal(np.load(folder / "heights.npy"), problem.heights):
        raise ValueError(f"{folder} is another problem")
    if "mesh" not in text:
        raise ValueError("there is no mesh, which 'asperity problem --mesh' writes")
    problem.element = text["mesh"]["element"]
    mesh, spacing = text["mesh"], problem.length_x / problem.heights.shape[1]
    far_boundary = text["body"]["far_boundary"] or "clamped"
    if far_boundary == "pressure":
        raise ValueError("the far boundary is \"pressure\", but must be clamped or sliding")
    rows, key = {}, ""
    for line in (folder / "mesh.inp").read_text(encoding="utf-8").splitlines():
        if line.startswith("*"):
            key = line.split("=")[-1] if line.startswith(("*NODE", "*ELEMENT")) else ""
        elif key:
            rows.setdefault(key, []).append(line.split(","))
    nodes = np.array(rows["all"], dtype=float)[:, 1:] / spacing
    groups = [(material["group"], np.array(rows[material["group"]], dtype=int),
               material["youngs_modulus [Pa]"] / problem.contact_modulus,
               material["poisson_ratio [1]"]) for material in mesh["materials"]]
    shape = (len(mesh["layers [m]"]) + 1, mesh["cells_y"] + 1, mesh["cells_x"] + 1)
    return Mesh(mesh["element"], nodes, shape, groups, far_boundary, spacing,
                problem.heights / spacing, sum(mesh["layers [m]"]) / spacing,
                problem.length_y / problem.heights.shape[0] / spacing)


def run(command, folder, given, threads=1):
    """The output of a program in a folder, its CPU time [s] and its peak memory [bytes].

    A program that exceeds a limit or fails has no answer.
    """
    limit = int(given.memory * 2**30)
    with open(folder / "log", "w+", encoding="utf-8", errors="replace") as log:
        child = subprocess.Popen(
            command, cwd=folder, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
            env=os.environ | {"OMP_NUM_THREADS": str(threads), "OPENBLAS_NUM_THREADS": "1"},
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        end, done = time.monotonic() + given.seconds, 0
        while not done and time.monotonic() < end:
            done, status, used = os.wait4(child.pid, os.WNOHANG)
            time.sleep(0 if done else 0.02)
        if not done:
            child.kill()
            child.wait()
            raise submission.NoAnswer(f"{command[0]} needs more than {given.seconds:g} s")
        log.seek(0)
        output = log.read()
    if status != 0:
        last = [line.strip() for line in output.splitlines() if line.strip()][-2:]
        raise submission.NoAnswer(f"{command[0]} ended with the status {status}: {' '.join(last)}")
    return output, used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss
