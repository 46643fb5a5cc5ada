#!/usr/bin/env python3
"""Every number of a row is about one set of nodes in contact and one border.

contact_sets_test.py PROGRAM SOURCE FOLDER: for each contact law, half-space and finite elements,
periodic and free edges, and for atoms, area, perimeter, spots, conductance, percolation and flow of
each row are computed again from the maps of the row by code of this file, which shares nothing with
the program. Flow, spots and area with a vanishing work of adhesion are those of hard contact.
"""
import json
import os
import shutil
import sys
from pathlib import Path

import numpy as np

WALLS = ["exponential", "dugdale", "cubic"]
NO_WALLS = ["lennard-jones", "lennard-jones-10-4", "morse"]
POINTS, LENGTH = 16, 1e-6
VISCOSITY, DROP = 1e-3, 1e4
CONDUCTORS = {"thermal_conductivity": "1 W/(m K)", "counter_thermal_conductivity": "1 W/(m K)"}


def laws(asperity):
    """The names of all laws, from the schema of a case."""
    def found(node):
        if isinstance(node, dict):
            if "hard" in node.get("enum", []):
                return node["enum"]
            node = list(node.values())
        return next(filter(None, map(found, node)), None) if isinstance(node, list) else None
    return found(json.loads(asperity.command("schema")))


def case(methods, pressures, work="20 mJ/m^2"):
    """A rough surface of 16 x 16 points whose short waves have two points and more."""
    def law(name, **keys):
        keys["contact"] = name
        if name in ("penalty", "augmented"):
            keys["penalty"] = "10 E*/h"
        elif name != "hard":
            keys["work_of_adhesion"] = work
        return keys
    return {
        "schema": 1, "title": "sets",
        "surface": {"kind": "self-affine", "length": "1 um", "points": POINTS, "seed": 11,
                    "rms_slope": 0.12, "hurst": 0.8, "wavelength_long": "1 length",
                    "wavelength_roll_off": "1 length", "wavelength_short": "4 h"},
        "material": {"youngs_modulus": "100 MPa", "poisson_ratio": 0.3},
        "load": {"nominal_pressure": pressures},
        **{method: {**({"element": "Q1", "solver": "condensed"} if method == "fem" else {}),
                    **{key: law(name, **keys) for key, name, keys in chosen}}
           for method, chosen in methods.items()},
        "flow": {"viscosity": "1 mPa s", "pressure_drop": "10 kPa"},
        "spots": {}, "conductance": CONDUCTORS, "report": {"fields": "all", "precision": "double"}}


def neighbours(i, j, points, is_periodic):
    for axis, k, m in ((1, i, j - 1), (1, i, j + 1), (0, i - 1, j), (0, i + 1, j)):
        if is_periodic or (0 <= k < points and 0 <= m < points):
            yield axis, k % points, m % points, (k // points, m // points)


def clusters(inside, is_periodic):
    """The number of clusters, and whether one spans the map along x and along y."""
    shift, count, spans = {}, 0, [False, False]  # of (y, x)
    for start in zip(*np.nonzero(inside)):
        if start in shift:
            continue
        count += 1
        shift[start], stack, members = (0, 0), [start], []
        while stack:
            i, j = stack.pop()
            members.append((i, j))
            for _, k, m, (dy, dx) in neighbours(i, j, len(inside), is_periodic):
                if not inside[k, m]:
                    continue
                moved = (shift[i, j][0] + dy, shift[i, j][1] + dx)
                if (k, m) not in shift:
                    shift[k, m] = moved
                    stack.append((k, m))
                else:
                    spans = [s or a != b for s, a, b in zip(spans, shift[k, m], moved)]
        if not is_periodic:
            rows, columns = ({member[axis] for member in members} for axis in (0, 1))
            spans = [s or {0, len(inside) - 1} <= ends for s, ends in zip(spans, (rows, columns))]
    return count, spans[1], spans[0]


def perimeter(inside, is_periodic):
    edges = 0
    for i, j in zip(*np.nonzero(inside)):
        beside = list(neighbours(i, j, len(inside), is_periodic))
        edges += 4 - len(beside) + sum(not inside[k, m] for _, k, m, _ in beside)
    return edges * (LENGTH / POINTS) / LENGTH**2


def leak(gap, axis, is_periodic):
    """Q = Dp/(12 eta) K of the open gap by a dense solution; the map is not periodic along x."""
    open_nodes = list(zip(*np.nonzero(gap > 0)))
    number = {node: n for n, node in enumerate(open_nodes)}
    matrix, right = np.zeros((len(number),) * 2), np.zeros(len(number))
    ends = []
    for node, n in number.items():
        for way, k, m, wraps in neighbours(*node, len(gap), is_periodic):
            if way == axis and wraps[axis] != 0 or (k, m) not in number:
                continue
            a, b = gap[node]**3, gap[k, m]**3
            matrix[n, n] += 2 * a * b / (a + b)
            matrix[n, number[k, m]] -= 2 * a * b / (a + b)
        for end, potential in ((0, 1.0), (len(gap) - 1, 0.0)):
            if node[axis] == end:
                matrix[n, n] += 2 * gap[node]**3
                right[n] += 2 * gap[node]**3 * potential
                if end:
                    ends.append((n, 2 * gap[node]**3))
    scale = 1e27  # of cubed nanometres
    potential = np.linalg.lstsq(matrix * scale, right * scale, rcond=1e-15)[0]
    return sum(c * potential[n] for n, c in ends) * DROP / (12 * VISCOSITY)


def conductance(inside, length):
    """K/E* of a rigid punch on these nodes of a periodic half-space, whose pressure q lowers them
    equally: C q = 1 with C(k) = 2/|k|, and K = <q>."""
    k = 2 * np.pi * np.fft.fftfreq(len(inside), length / len(inside))
    size = np.hypot(*np.meshgrid(k, k, indexing="ij"))
    symbol = np.divide(2.0, size, out=np.zeros_like(size), where=size > 0)
    column = np.fft.ifft2(symbol).real  # of a pressure 1 at one node
    i, j = np.nonzero(inside)
    matrix = column[i[:, None] - i, j[:, None] - j]
    return np.linalg.solve(matrix, np.ones(len(i))).sum() / inside.size


def atoms():
    """A block of 24 x 24 atoms that repel, or attract, those of a rough substrate."""
    pairs = {"interaction_energy": "20 meV", "interaction_distance": "3.28 angstrom",
             "cutoff": "10 angstrom", "contact_distance": "2.9221 angstrom"}
    return {"schema": 1, "title": "sets of atoms",
            "surface": {"kind": "self-affine", "length": "6.24 nm", "points": 38, "seed": 4,
                        "rms_height": "0.1 nm", "rescale": True, "hurst": 0.8,
                        "wavelength_long": "1 length", "wavelength_roll_off": "1 length",
                        "wavelength_short": "0.25 length"},
            "material": {"youngs_modulus": "77.2 GPa", "poisson_ratio": 0.42},
            "load": {"nominal_pressure": ["0.01 E*", "0.05 E*"]},
            "md": {**pairs, "atoms": 24, "repulsive": {},
                   "attractive": {"potential": "lennard-jones"}},
            "flow": {"viscosity": "1 mPa s", "pressure_drop": "10 kPa"},
            "spots": {}, "conductance": CONDUCTORS,
            "report": {"fields": "all", "precision": "double"}}


def check_rows(method, name, is_periodic, tolerance, length=LENGTH):
    seen = set()
    for step, (_, gap) in method.fields.items():
        touches = method.contact(step)
        is_open = ~touches & (gap > tolerance)
        at = lambda column: getattr(method, column)[0, step]
        where = f"{name}, step {step}"
        if not name.startswith("md"):
            assert np.isclose(at("contact_perimeter"), perimeter(touches, is_periodic)), where
        if name != "md.repulsive":  # whose area counts pairs of atoms
            assert np.isclose(at("area_fraction"), touches.mean(), rtol=1e-12), where
        for column, inside in (("spot_count", touches), ("gap_count", is_open)):
            which = column.split("_", maxsplit=1)[0] + ("s" if column.startswith("spot") else "")
            count, *spans = clusters(inside, is_periodic)
            assert at(column) == count, f"{where}: {column} {at(column)}, not {count}"
            for along, spanning in zip("xy", spans):
                percolates = at(f"{which}_percolate{'' if which == 'spots' else 's'}_{along}")
                assert percolates == spanning, f"{where}: {which} along {along}"
        if is_periodic and touches.any() and not touches.all():
            own, again = at("relative_conductance"), conductance(touches, length)
            assert np.isclose(own, again, rtol=1e-6), f"{where}: {own} {again}"
        for axis, along in ((1, "x"), (0, "y")):
            own = at(f"leak_rate_{along}")
            again = leak(np.where(is_open, gap, 0), axis, is_periodic)
            assert abs(own - again) <= 1e-6 * abs(again) + 1e-30, f"{where}: {own} {again}"
            seen.add("leaks" if own > 0 else "sealed")
        seen.add("touches" if touches.any() else "apart")
    return seen


def columns_of_maps(asperity, folder):
    """All laws, both solvers, both kinds of edges: light, heavy, and apart under tension."""
    names = laws(asperity)
    assert set(names) == {"penalty", "hard", "augmented", *WALLS, *NO_WALLS}, names
    methods = {"halfspace": [(f"{law}-periodic", law, {}) for law in names] +
                            [(f"{law}-free", law, {"boundaries": "free"}) for law in names],
               "fem": [(f"{law}-periodic", law, {}) for law in names]}
    result = asperity.run(case(methods, ["0.2 MPa", "3 MPa", "30 MPa"]), out=folder / "all")
    seen = set()
    for name in result:
        method = result[name]
        assert len(method.fields) == 3, f"{name}: {sorted(method.fields)}"
        seen |= check_rows(method, name, not name.endswith("-free"), 1e-8 * result.rms_height[0])
    assert seen >= {"leaks", "sealed", "touches"}, seen
    result = asperity.run(atoms(), methods=["md.repulsive", "md.attractive"], out=folder / "atoms")
    seen = set().union(*(check_rows(result[name], name, True, 0.0, 6.24e-9) for name in result))
    assert seen >= {"leaks", "touches"}, seen


def vanishing_adhesion(asperity, folder):
    """w -> 0: the same flow, spots and area as without adhesion."""
    chosen = [(f"{law}-laws", law, {}) for law in ["hard", *WALLS]]
    result = asperity.run(case({"halfspace": chosen, "fem": chosen}, ["0.5 MPa", "2 MPa"],
                               work="1e-9 J/m^2"), out=folder / "weak")
    for kind in ("halfspace", "fem"):
        hard = result[f"{kind}.hard-laws"]
        assert (hard.leak_rate_x > 0).all() and (hard.area_fraction > 0.01).all()
        for law in WALLS:
            weak = result[f"{kind}.{law}-laws"]
            for column in ("leak_rate_x", "leak_rate_y", "critical_gap_x", "effective_medium",
                           "area_fraction", "spot_count"):
                a, b = getattr(hard, column), getattr(weak, column)
                assert np.allclose(a, b, rtol=1e-3), f"{kind}.{law} {column}: {a} {b}"


def main():
    program, source, folder = sys.argv[1:]
    shutil.rmtree(folder, ignore_errors=True)
    os.environ["ASPERITY_PROGRAM"] = program
    os.environ["ASPERITY_CACHE"] = str(Path(folder).resolve() / "cache")
    sys.path.insert(0, str(Path(source) / "python"))
    import asperity
    columns_of_maps(asperity, Path(folder))
    vanishing_adhesion(asperity, Path(folder))


if __name__ == "__main__":
    main()
