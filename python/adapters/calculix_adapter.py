#!/usr/bin/env python3
"""Solve an Asperity problem by CalculiX (http://www.calculix.de), program ccx.

    calculix_adapter.py PROBLEM_DIR SUBMISSION_DIR [--element C3D8I] [--accuracy best]

Needs a problem with a mesh of Q1. A gap element, which is a spring that only presses, joins
each node of the contact surface to a node of the rigid surface. The tolerance is E* over
spacing and stiffness of the spring per area; "default" is the upper end of the manual's
range for contact, 5 to 50 times E over the size of an element.
"""
import argparse
import pathlib
import re
import subprocess
import tempfile

import numpy as np

import meshed
import submission

OPTIONS = argparse.ArgumentParser(add_help=False, parents=[meshed.OPTIONS])
OPTIONS.add_argument("--element", choices=("C3D8", "C3D8I"), default="C3D8")
GIVEN = OPTIONS.parse_known_args()[0]


def rows(values):
    return "".join(",".join(f"{v:.12e}" if isinstance(v, float) else str(v) for v in row) + "\n"
                   for row in values)  # CalculiX reads at most 20 characters of a number


NEVER = "1e9,0\n2e9,1\n"  # an elastic step would be solved once, with open gaps


def block(mesh, flow=NEVER):
    """Nodes, cells, materials, periodic sides and the springs, without their stiffness.

    `flow` has the rows of *PLASTIC: yield stress [E*] and equivalent plastic strain.
    """
    number = 1 + np.arange(len(mesh.nodes)).reshape(mesh.shape)
    face, (points_y, points_x) = number[0, :-1, :-1].ravel(), mesh.heights.shape
    rigid, cells = number.size + 3 + np.arange(face.size), sum(len(g[1]) for g in mesh.groups)
    text = "*NODE\n" + rows((i, *map(float, at)) for i, at in enumerate(mesh.nodes, start=1))
    text += f"*NODE\n{number.size + 1},0,0,-1\n{number.size + 2},0,0,-2\n*NODE,NSET=rigid\n"
    text += rows((i, *map(float, mesh.nodes[at - 1])) for i, at in zip(rigid, face))
    for name, cell, modulus, ratio in mesh.groups:
        text += f"*ELEMENT,TYPE={GIVEN.element},ELSET={name}\n" + rows(cell)
        text += f"*MATERIAL,NAME={name}\n*ELASTIC\n{modulus:.12e},{ratio}\n*PLASTIC\n{flow}"
        text += f"*SOLID SECTION,ELSET={name},MATERIAL={name}\n"
    text += "*ELEMENT,TYPE=GAPUNI,ELSET=gaps\n" + rows(
        (cells + 1 + i, rigid[i], face[i]) for i in range(face.size))
    fixed = (1, 2, 3) if mesh.far_boundary == "clamped" else (3,)
    for k, j, i in np.ndindex(mesh.shape):
        for axis in (1, 2, 3) if i == points_x or j == points_y else ():
            if k + 1 < mesh.shape[0] or axis not in fixed:
                twin = number[k, j % points_y, i % points_x]
                text += f"*EQUATION\n2\n{number[k, j, i]},{axis},1,{twin},{axis},-1\n"
    for i, height in zip(rigid, mesh.heights.ravel()):  # moves by the approach plus its height
        text += f"*EQUATION\n3\n{i},3,1,{number.size + 1},3,-1,{number.size + 2},3,{-height:.12e}\n"
    text += "*NSET,NSET=fixed,GENERATE\n" + rows([(number[-1, 0, 0], number[-1, -1, -1])])
    text += "*NSET,NSET=face\n" + rows((i,) for i in face)
    bound = f"fixed,{fixed[0]},3\nrigid,1,2\n{number.size + 1},1,2\n{number.size + 2},1,2\n"
    bound += f"{number.size + 2},3,3,1\n" + (f"{number[-1, 0, 0]},1,2\n" if len(fixed) < 3 else "")
    return text, bound, number.size + 1


def printed(answer):
    """The last columns of the tables of a .dat file, by quantity and set, a list over time."""
    tables = {}
    for key, lines in re.findall(r"(\S.*set \S+ and time .*)\n\n((?: +\d.*\n)+)", answer):
        tables.setdefault(key.split()[0] + key.split("set ")[1].split()[0], []).append(
            np.array([line.split()[-1] for line in lines.splitlines()], dtype=float))
    return tables


def prepare(problem):
    mesh = meshed.read_mesh(problem, GIVEN.mesh)
    if mesh.element != "Q1":
        raise ValueError("the mesh is for Q2, whose contact nodes have unequal weights; write "
                         "that of Q1: asperity problem --mesh --set fem.element=Q1")
    text, bound, leader = block(mesh)
    shown = subprocess.run(["ccx", "-v"], stdout=subprocess.PIPE, text=True, check=False).stdout
    far = 4 * mesh.depth / min(group[2] for group in mesh.groups)

    def solve(nominal_pressure, tolerance):
        pressure = nominal_pressure / problem.contact_modulus
        load = pressure * mesh.heights.size * mesh.area
        start = far * pressure + np.ptp(mesh.heights)  # all gaps are closed: then the load
        control = f"*CONTROLS,PARAMETERS=FIELD\n{tolerance:g},{tolerance:g}\n" if tolerance < 5e-3 else ""
        head = "*STEP,INC=100\n" + control + "*STATIC\n1,1\n*BOUNDARY,OP=NEW\n" + bound
        deck = f"{text}*GAP,ELSET=gaps\n0,0,0,1,,{mesh.area / tolerance:.12e},1e-12\n" + head
        deck += f"{leader},3,3,{start:.12e}\n*END STEP\n" + head + f"*CLOAD\n{leader},3,"
        deck += (f"{load:.12e}\n*NODE PRINT,NSET=rigid\nRF,U\n"
                 "*NODE PRINT,NSET=face\nU\n*END STEP\n")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "block.inp").write_text(deck, encoding="utf-8")
            log, cpu_time, memory = meshed.run(["ccx", "block"], folder, GIVEN)
            answer = (folder / "block.dat").read_text(encoding="utf-8")
            table = np.loadtxt(folder / "block.sta", skiprows=2, usecols=3, dtype=int, ndmin=1)
        values = {name: tables[-1] for name, tables in printed(answer).items()}
        force = values["forcesRIGID"]
        gap = values["displacementsFACE"] - values["displacementsRIGID"]
        if "iteration 2" not in log or abs(force.sum() / load - 1) > 1e-5:
            raise submission.NoAnswer("no iterations, or the sum of the forces is not the load")
        field = problem.contact_modulus / mesh.area * np.maximum(force, 0).reshape(mesh.heights.shape)
        return field, True, {"mean_gap": float(gap.mean() * mesh.spacing), "cpu_time": cpu_time,
                             "peak_memory": memory, "iterations": int(table.sum()),
                             "contact_area_fraction": float((field > 0).mean())}

    return f"{shown.split()[-1]}-{GIVEN.element}", solve


if __name__ == "__main__":
    submission.run(prepare, "CalculiX", f"finite elements {GIVEN.element}, gap elements at the nodes",
                   {"default": 0.02, "best": 1e-6}, any_body=True,
                   parents=[OPTIONS], claimed_error=0.1)
