#!/usr/bin/env python3
"""Solve an Asperity problem by GetFEM (https://getfem.org), in a process of its own.

    getfem_adapter.py PROBLEM_DIR SUBMISSION_DIR [--accuracy best]

Needs a problem with a mesh; its elements are those of the mesh, Q1 or Q2. Each node of the
contact surface has a multiplier, its force, which the augmented Lagrangian of GetFEM's
contact brick finds together with the approach. The tolerance is the residual at which its
Newton iteration ends, over the load; "default" is that of Model.solve for a load of one.
"""
import argparse
import pathlib
import sys
import tempfile

import numpy as np

import meshed
import submission

OPTIONS = argparse.ArgumentParser(add_help=False, parents=[meshed.OPTIONS])
GIVEN = OPTIONS.parse_known_args()[0]


def matrix(folder, shape, rows, columns, values):
    """A sparse matrix of GetFEM, which reads it from a file at once."""
    import getfem
    with open(folder / "matrix.mm", "w", encoding="ascii") as file:
        file.write(f"%%MatrixMarket matrix coordinate real general\n{shape[0]} {shape[1]} {len(rows)}\n")
        np.savetxt(file, np.column_stack((rows + 1, columns + 1, values)), "%d %d %.17g")
    return getfem.Spmat("load", "mm", str(folder / "matrix.mm"))


def periodic(space, block, folder):
    """Joins the sides and holds the far boundary: only free degrees of freedom remain.

    Returns those along z of the contact nodes, in the order of the grid, and how many there are.
    """
    at, points = space.basic_dof_nodes().T, block["heights"].shape
    layer = np.unique(np.round(at[:, 2], 6), return_inverse=True)[1]
    row, column = (np.rint(at[:, a] / block["step"][a]).astype(int) % points[1 - a] for a in (1, 0))
    axis = np.arange(len(at)) % 3
    held = (layer == layer.max()) & (block["is_clamped"] | (axis == 2) | (row + column == 0))
    key = (layer * points[0] + row) * points[1] + column
    first, number = np.unique((3 * key + axis)[~held], return_index=True, return_inverse=True)[1:]
    free, shape = np.flatnonzero(~held), (len(at), len(first))
    space.set("reduction matrices",
              matrix(folder, shape[::-1], np.arange(shape[1]), free[first], np.ones(shape[1])),
              matrix(folder, shape, free, number, np.ones(len(free))))
    contact = first[(layer[free[first]] == 0) & (axis[free[first]] == 2)]
    return number[contact], shape[1]  # in the order of the keys, which is that of the grid


def solve_block(folder):
    """Reads block.npz, solves one load and writes answer.npz: forces [E* spacing^2] and gaps."""
    import getfem

    block = dict(np.load(folder / "block.npz"))
    degree, heights = int(block["degree"]), block["heights"].ravel()
    mesh, model = getfem.Mesh("empty", 3), getfem.Model("real")
    cells = block["nodes"][block["cells"][:, [0, 1, 3, 2, 4, 5, 7, 6]]]
    numbers = mesh.add_convex(getfem.GeoTrans("GT_QK(3,1)"), np.transpose(cells, (2, 1, 0)))
    space = getfem.MeshFem(mesh, 3)
    space.set_fem(getfem.Fem(f"FEM_QK(3,{degree})"))
    rule = getfem.MeshIm(mesh, getfem.Integ(f"IM_GAUSS_PARALLELEPIPED(3,{2 * degree + 1})"))
    contact, size = periodic(space, block, folder)
    model.add_fem_variable("u", space)
    for group, (modulus, ratio) in enumerate(block["moduli"], start=1):
        chosen = np.asarray(numbers)[block["group"] == group]
        mesh.set_region(group, np.vstack((chosen, 0 * chosen - 1)))
        names = (f"lambda{group}", f"mu{group}")
        model.add_initialized_data(names[0], modulus * ratio / (1 + ratio) / (1 - 2 * ratio))
        model.add_initialized_data(names[1], modulus / 2 / (1 + ratio))
        model.add_isotropic_linearized_elasticity_brick(rule, "u", *names, group)
    nodes, one = np.arange(contact.size), np.ones(contact.size)
    model.add_variable("approach", 1)
    model.add_variable("force", contact.size)
    model.set_variable("approach", [block["start"]])
    model.add_initialized_data("r", [1.0])
    model.add_initialized_data("gap", -heights)
    model.add_basic_contact_brick_two_deformable_bodies(
        "u", "approach", "force", "r", matrix(folder, (contact.size, size), nodes, contact, -one),
        matrix(folder, (contact.size, 1), nodes, 0 * nodes, one), "gap")
    model.add_explicit_rhs("approach", [block["load"]])
    steps, converged = model.solve("max_res", float(block["tolerance"]), "max_iter", 100)
    force = -model.variable("force")
    gap = model.variable("u")[contact] - model.variable("approach") - heights
    np.savez(folder / "answer.npz", force=force, gap=gap, steps=steps, converged=converged)


def prepare(problem):
    mesh = meshed.read_mesh(problem, GIVEN.mesh)
    import getfem  # that it is not installed is known before anything is solved
    points, degree = np.array(mesh.heights.shape), int(mesh.element[1])
    step = np.array([1.0, mesh.area])
    weights = [np.where(np.arange(n) % 2, 4, 2) / 3 if degree == 2 else np.ones(n) for n in points]
    block = {"nodes": mesh.nodes, "step": step, "heights": mesh.heights, "degree": degree,
             "cells": np.vstack([cells for _, cells, _, _ in mesh.groups])[:, 1:] - 1,
             "group": np.repeat(np.arange(len(mesh.groups)) + 1, [len(g[1]) for g in mesh.groups]),
             "moduli": np.array([group[2:] for group in mesh.groups]),
             "is_clamped": mesh.far_boundary == "clamped"}
    far = 4 * mesh.depth / block["moduli"][:, 0].min()

    def solve(nominal_pressure, tolerance):
        pressure = nominal_pressure / problem.contact_modulus
        load = pressure * mesh.heights.size * mesh.area
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            np.savez(folder / "block.npz", load=load, tolerance=tolerance * load,
                     start=far * pressure + np.ptp(mesh.heights), **block)  # all gaps are closed
            command = [sys.executable, __file__, "--solve", str(folder)]
            cpu_time, memory = meshed.run(command, folder, GIVEN)[1:]
            with np.load(folder / "answer.npz") as file:
                answer = dict(file)
        force = np.maximum(answer["force"], 0).reshape(points)
        field = force / np.outer(*weights)
        field *= nominal_pressure / field.mean()  # unequal weights of Q2; nothing with Q1
        return field, bool(answer["converged"]), {
            "mean_gap": float((answer["gap"].reshape(points) * np.outer(*weights)).mean() * mesh.spacing),
            "cpu_time": cpu_time, "peak_memory": memory, "iterations": int(answer["steps"]),
            "contact_area_fraction": float((field > 0).mean())}

    return f"{getfem.getfem_env('version')}-{mesh.element}", solve


if __name__ == "__main__":
    if sys.argv[1:2] == ["--solve"]:
        solve_block(pathlib.Path(sys.argv[2]))
    else:
        submission.run(prepare, "GetFEM", "finite elements, augmented Lagrangian of nodal contact",
                       {"default": 1e-6, "best": 1e-12}, any_body=True,
                       parents=[OPTIONS], claimed_error=0.1)
