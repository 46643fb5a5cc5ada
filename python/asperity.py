"""Runs cases of Asperity from Python and returns their numbers as arrays.

    import asperity
    result = asperity.run({"schema": 1, "surface": {...}, "material": {...}, "load": {...},
                           "halfspace": {"contact": "hard"}})
    result["halfspace"].mean_gap            # [m], one row per realisation, one column per load

A case is a dict with the keys of a case file (docs/reference/case.md). Needs numpy and h5py. The
program is the one that $ASPERITY_PROGRAM names, else `asperity` on the path, else the script of
the checkout in which this file lies.
"""
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise ImportError(f"asperity needs numpy and h5py, and {missing.name} is not installed: "
                      "apt-get install python3-numpy python3-h5py, or pip install numpy h5py"
                      ) from missing


class Error(RuntimeError):
    """The program refused the case or failed; the text is its message."""


def _toml_value(value):
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, os.PathLike):
        return _toml_value(os.fspath(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml_value, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(k)} = {_toml_value(v)}" for k, v in value.items()) + " }"
    raise TypeError(f"{value!r} of type {type(value).__name__} has no counterpart in a case file")


def _key(key):
    bare = key and all(c.isascii() and (c.isalnum() or c in "_-") for c in key)
    return key if bare else _toml_value(key)


def to_toml(case, path=()):
    """The text of a case file for a dict. Dicts inside become tables, also where a case file
    usually has them on one line."""
    lines = [f"[{'.'.join(map(_key, path))}]"] if path else []
    lines += [f"{_key(k)} = {_toml_value(v)}" for k, v in case.items() if not isinstance(v, dict)]
    tables = [to_toml(v, (*path, k)) for k, v in case.items() if isinstance(v, dict)]
    return "\n".join(lines) + "\n" + "".join(tables)


class Method:
    """The curves of one method. Each column of docs/reference/results.md is an attribute: an array
    [realization, step], with NaN where a step is missing."""

    def __init__(self, group):
        self.kind, self.description = (str(group.attrs.get(k, "")) for k in ("kind", "description"))
        curves = [group[r]["curve"] for r in sorted(filter(str.isdigit, group), key=int)]
        self.columns = sorted({name for curve in curves for name in curve if name != "note"})
        length = max(len(curve["nominal_pressure"]) for curve in curves)
        for name in self.columns:
            table = np.full((len(curves), length), np.nan)
            for row, curve in zip(table, curves):
                if name in curve:
                    row[:len(curve[name])] = curve[name]
            setattr(self, name, table)
        self.fields = {}  # of realisation 0: step -> (pressure [Pa], gap [m]), each [y, x]
        for step, maps in group.get("0/fields", {}).items():
            self.fields[int(step)] = (maps["pressure"][()], maps["gap"][()])


class Result:
    """A result file. `result["fem"]` is a Method; iterating gives the names of the methods."""

    def __init__(self, folder, exit_code=0):
        self.folder, self.exit_code = Path(folder), exit_code
        summary = self.folder / "summary.json"
        self.summary = json.loads(summary.read_text("utf-8")) if summary.exists() else None
        with h5py.File(self.folder / "result.h5") as file:
            self.contact_modulus = float(file.attrs["contact_modulus"])  # E* [Pa]
            self.methods = {name: Method(group) for name, group in file["methods"].items()}
            surfaces = file.get("surfaces", {})
            first = sorted(surfaces, key=int)
            self.rms_height = np.array([surfaces[r].attrs["rms_height"] for r in first])  # [m]
            self.rms_slope = np.array([surfaces[r].attrs["rms_slope"] for r in first])
            self.heights = [surfaces[r]["heights"][()] for r in first if "heights" in surfaces[r]]

    def __getitem__(self, name):
        try:
            return self.methods[name]
        except KeyError:
            raise KeyError(f"{name}; this result has {', '.join(self.methods)}") from None

    def __iter__(self):
        return iter(self.methods)


def _program():
    named = os.environ.get("ASPERITY_PROGRAM") or shutil.which("asperity")
    return named or str(Path(__file__).resolve().parent.parent / "asperity")


def _write_case(case, folder):
    case = {k: dict(v) if isinstance(v, dict) else v for k, v in case.items()}
    surface = case.get("surface", {})
    if "heights" in surface:  # an array [m] instead of a file
        np.savetxt(folder / "heights.txt", surface.pop("heights"), fmt="%.17g")
        surface.update(kind="measured", file=str(folder / "heights.txt"), format="plain",
                       height_unit="1 m")
    for table in (case, surface, case.get("mesh", {})):
        for key in {"base", "file"} & table.keys():  # relative to the working directory
            table[key] = os.path.abspath(table[key])
    (folder / "case.toml").write_text(to_toml(case), "utf-8")


def run(case, out=None, methods=(), overrides=None, threads=0, report=False):
    """Runs a case and returns its Result. Without `out` the files are in a temporary folder,
    which is removed. A result is also returned if a step did not converge (exit_code 3) or, with
    `report`, an expectation is not met (1); `report` also writes summary and report.html.

    case       a dict, or the path or name of a case
    overrides  keys of the case file and their values: {"surface.points": 128}
    """
    with tempfile.TemporaryDirectory(prefix="asperity-") as scratch:
        folder = Path(out or scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        words = [_program(), "run", str(case), "--quiet", "--out", str(folder)]
        if isinstance(case, dict):
            _write_case(case, folder)
            words[2] = str(folder / "case.toml")
        words += ["--methods", ",".join(methods)] if methods else []
        words += ["--threads", str(threads)] if threads else []
        words += [] if report else ["--no-report"]
        for key, value in (overrides or {}).items():
            words += ["--set", f"{key}={_toml_value(value)}"]
        ended = subprocess.run(words, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
        if ended.returncode not in (0, 1, 3) or not (folder / "result.h5").exists():
            raise Error(ended.stderr.strip() or f"exit code {ended.returncode}")
        return Result(folder, ended.returncode)


def read(path):
    """Reads a result that exists: its folder, or the file result.h5 in it."""
    path = Path(path)
    return Result(path if path.is_dir() else path.parent)
