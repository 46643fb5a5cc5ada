"""Runs cases of Asperity from Python and returns their numbers as arrays.

    import asperity
    contact = asperity.press(heights, 1e-6, 2e9, [1e6, 5e6])  # [m], [m], [Pa], [Pa]
    contact.mean_gap, contact.units["mean_gap"]               # one number per pressure, "m"

    result = asperity.run({"schema": 1, "surface": {...}, "material": {...}, "load": {...},
                           "halfspace": {"contact": "hard"}})
    result["halfspace"].mean_gap            # [m], one row per realisation, one column per load

A case is a dict with the keys of a case file (docs/reference/case.md). Needs numpy and h5py. The
program is the one that $ASPERITY_PROGRAM names, else `asperity` on the path, else the script of
the checkout in which this file lies or from which pip has installed it.
"""
import copy
import base64
import html
import importlib.metadata
import json
import os
import shutil
import subprocess
import tempfile
import tomllib
import urllib.parse
import warnings
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


def _map(group, name, fields):
    """A map of a group: of its user's map, or of the whole cell that a solver pressed."""
    if fields not in ("map", "cell"):
        raise ValueError(f'fields = {fields!r}, but must be "map" or "cell"')
    values = group[name]
    if fields == "cell" or values.ndim != 2:
        return values[()]
    rows, columns = (int(group.attrs.get(f"map_points_{axis}", points))
                     for axis, points in zip("yx", values.shape))
    return values[:rows, :columns]


class Method:
    """The curves of one method. Each column of docs/reference/results.md is an attribute: an array
    [realization, step], with NaN where a step is missing. `units` has the unit of each."""

    def __init__(self, group, fields="map"):
        self.kind, self.description = (str(group.attrs.get(k, "")) for k in ("kind", "description"))
        curves = [group[r]["curve"] for r in sorted(filter(str.isdigit, group), key=int)]
        self.units = {name: str(values.attrs.get("unit", "")) for curve in curves
                      for name, values in curve.items() if name != "note"}
        self.columns = sorted(self.units)
        lengths = [len(curve["nominal_pressure"]) for curve in curves]
        for curve, length in zip(curves, lengths):  # before any of them is read
            for name, values in curve.items():
                if values.shape != (length,):
                    raise Error(f"{values.name} has the shape {values.shape}, but must have "
                                f"{(length,)}, as nominal_pressure")
        places = [curve["step"][()].astype(int) if "step" in curve else np.arange(length)
                  for curve, length in zip(curves, lengths)]
        last = max((place.max(initial=0) for place in places), default=0)
        if last >= 100_000 or any(place.min(initial=0) < 0 for place in places):
            raise Error(f"{group.name} has other steps than 0 to 99999")
        for name in self.columns:
            table = np.full((len(curves), last + 1), np.nan)
            for row, place, curve in zip(table, places, curves):
                if name in curve:
                    row[place] = curve[name]
            setattr(self, name, table)
        self._by_gap = str(group.attrs.get("contact", "pressure")) == "gap"
        self.fields = {}  # of realisation 0: step -> (pressure [Pa], gap [m]), each [y, x]
        for step, maps in group.get("0/fields", {}).items():
            self.fields[int(step)] = tuple(_map(maps, name, fields) for name in ("pressure", "gap"))

    def table(self):
        """The columns that were computed, as a dict from "mean_gap [m]" to an array with one number
        per load step: pandas.DataFrame(method.table()) is a table. Several realisations follow each
        other, with their number in the column "realization"."""
        columns = {name: np.atleast_2d(getattr(self, name)) for name in self.columns}
        n, length = columns["nominal_pressure"].shape
        known = np.isfinite(columns["nominal_pressure"])
        first = ["step", "nominal_pressure", "area_fraction", "area_fraction_corrected", "mean_gap"]
        order = [name for name in first if name in columns]
        order += [name for name in self.columns if name not in first]
        table = {"realization": np.repeat(np.arange(n), length)[known.ravel()]} if n > 1 else {}
        for name in order:
            if np.isfinite(columns[name][known]).any():
                unit = self.units[name]
                table[f"{name} [{unit}]" if unit not in ("", "1") else name] = columns[name][known]
        return table

    def _repr_html_(self, most_rows=20):
        """A small table in a notebook: without what the computation cost."""
        others = {"step", "iterations", "residual", "status", "is_unloading", "transforms",
                  "area_fraction_fit", "area_fraction_moment", "contact_perimeter [1/m]",
                  "contact_energy [J/m^2]", "certified_gap_error [m]"}
        table = {name: values for name, values in self.table().items()
                 if name not in others and not name.endswith("_time [s]") and np.any(values != 0)}
        rows = list(zip(*table.values()))
        left = len(rows) - most_rows
        lines = ["".join(f"<th>{html.escape(name)}</th>" for name in table)]
        lines += ["".join(f"<td>{value:.4g}</td>" for value in row) for row in rows[:most_rows]]
        return (f"<p>{html.escape(self.description or self.kind)}</p><table>"
                + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"
                + (f"<p>and {left} more load steps</p>" if left > 0 else ""))

    def contact(self, step):
        """Which points of the maps of a step are in contact: a bool for each, [y, x]. With adhesion
        and for atoms those whose gap is closed, else those under pressure."""
        pressure, gap = self.fields[step]
        return gap <= 0 if self._by_gap else pressure > 0


def _opened(path):
    if not path.is_file():
        raise Error(f"{path}: there is no such file")
    try:
        file = h5py.File(path)
    except OSError as error:
        raise Error(f"{path}: {error}") from None
    if file.attrs.get("format") not in ("asperity-result", b"asperity-result"):
        file.close()
        raise Error(f"{path}: is no result of Asperity")
    return file


class Result:
    """A result file. `result["fem"]` is a Method; iterating gives the names of the methods.
    `tables["leak"]["mass_flow"]` is a column of a table of docs/reference/results.md. The heights
    and fields of a measured map that continues by its mirror images are those of the map, or, with
    fields="cell", those of the whole cell that was pressed."""

    def __init__(self, path, exit_code=0, fields="map"):
        path = Path(path)
        source = path / "result.h5" if path.is_dir() else path
        self.folder, self.exit_code = source.parent, exit_code
        summary = self.folder / "summary.json"  # of result.h5
        has_summary = source.name == "result.h5" and summary.exists()
        self.summary = json.loads(summary.read_text("utf-8")) if has_summary else None
        with _opened(source) as file:
            self.contact_modulus = float(file.attrs["contact_modulus"])  # E* [Pa]
            self.methods = {name: Method(group, fields) for name, group in file["methods"].items()}
            surfaces = file.get("surfaces", {})
            first = sorted(surfaces, key=int)
            self.rms_height = np.array([surfaces[r].attrs["rms_height"] for r in first])  # [m]
            self.rms_slope = np.array([surfaces[r].attrs["rms_slope"] for r in first])
            self.heights = [_map(surfaces[r], "heights", fields) for r in first
                            if "heights" in surfaces[r]]
            self.tables = {name: {column: values[()] for column, values in table.items()}
                           for name, table in file.get("tables", {}).items()}

    def flux(self, method):
        """The flow along x through the gap of a method, of a case with [flow], at the heaviest
        saved load at which the gap is not sealed: x [m] and y [m] of the columns and rows, the flow
        per width |q| over its mean Q/W, [y, x], and the place (x, y) [m] that is narrowest on the
        widest path. Sides of more than 256 points are averaged over squares."""
        try:
            table = self.tables[f"flow-{method}"]
        except KeyError:
            raise KeyError(f"{method} has no flux: its case needs [flow] and [report] fields, and a "
                           "saved load at which the gap is not sealed") from None
        x, y = np.unique(table["x"]), np.unique(table["y"])
        at = np.flatnonzero(table["is_critical"])[0]
        return x, y, table["flux"].reshape(len(y), len(x)), (table["x"][at], table["y"][at])

    def __getitem__(self, name):
        try:
            return self.methods[name]
        except KeyError:
            raise KeyError(f"{name}; this result has {', '.join(self.methods)}") from None

    def __iter__(self):
        return iter(self.methods)

    def _repr_html_(self):
        """In a notebook: what the report answers, its first figure, and a table of each method."""
        text = f"<p>{html.escape(' '.join((self.summary or {}).get('answers', [])))}</p>"
        for name in ("pressure-gap", "exact-area", "adhesion-loop"):
            figure = self.folder / f"figures/{name}.svg"
            if figure.is_file():
                picture = base64.b64encode(figure.read_bytes()).decode()
                text += f'<img alt="{name}" src="data:image/svg+xml;base64,{picture}">'
                break
        return text + "".join(f"<h4>{html.escape(name)}</h4>{method._repr_html_()}"
                              for name, method in self.methods.items())


class Sweep:
    """The results of a sweep: `points[i]` is the Result at `values[i]`, a dict that has the value
    of each key, or None if this point has no result."""

    def __init__(self, folder, exit_code=0, fields="map"):
        self.folder, self.exit_code = Path(folder), exit_code
        self.summary = json.loads((self.folder / "sweep.json").read_text("utf-8"))
        keys = [(key["key"], [tomllib.loads("v = " + v)["v"] for v in key["values"]])
                for key in self.summary["keys"]]
        self.values = [{key: values[i] for (key, values), i in zip(keys, point["choice"])}
                       for point in self.summary["points"]]
        folders = [self.folder / point["folder"] for point in self.summary["points"]]
        self.points = [Result(f, fields=fields) if (f / "result.h5").exists() else None
                       for f in folders]


def _checkout():
    """The checkout in which this file lies, or from which pip has installed it."""
    here = Path(__file__).resolve().parent
    if here.name != "python":
        try:
            origin = importlib.metadata.distribution("asperity").read_text("direct_url.json")
            here = Path(urllib.parse.unquote(urllib.parse.urlsplit(json.loads(origin)["url"]).path))
        except (importlib.metadata.PackageNotFoundError, TypeError):  # not by pip, or of an index
            pass
    return here.parent


def _program():
    named = os.environ.get("ASPERITY_PROGRAM") or shutil.which("asperity")
    script = _checkout() / "asperity"
    if not named and not (script.is_file() and os.access(script, os.X_OK)):
        raise Error("the program asperity was not found: put it on the path, or name it, or the "
                    "script asperity of a checkout, by the environment variable ASPERITY_PROGRAM")
    return named or str(script)


def _ended(words):
    """The program after it has run with these words; its warnings are those of Python."""
    program = _program()
    try:
        ended = subprocess.run([program, *map(str, words)], check=False, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    except OSError as error:
        raise Error(f"{program} cannot be run: {error.strerror}; the environment variable "
                    "ASPERITY_PROGRAM names another program") from None
    for line in ended.stderr.splitlines():
        if line.startswith("warning: "):
            warnings.warn(line.removeprefix("warning: "), stacklevel=3)
    return ended


def command(*words):
    """Runs a command of docs/reference/commands.md and returns what it prints:
    command("problem", "board/hertz", "--out", folder)."""
    ended = _ended(words)
    if ended.returncode != 0:
        raise Error((ended.stderr or ended.stdout).strip() or f"exit code {ended.returncode}")
    return ended.stdout


def _heights(array):
    heights = np.ma.filled(np.ma.asarray(array, dtype=float), np.nan)
    if heights.ndim != 2:
        raise ValueError(f"heights have the shape {heights.shape}, but must be an array [y, x]")
    return heights


def _write_case(case, folder):
    case = {k: dict(v) if isinstance(v, dict) else v for k, v in case.items()}
    surface = case.get("surface", {})
    if "heights" in surface:  # an array [m] instead of a file
        np.save(folder / "heights.npy", _heights(surface.pop("heights")))
        surface.update(kind="measured", file=str(folder / "heights.npy"), format="npy",
                       height_unit="1 m")
    for table in (case, surface, case.get("mesh", {})):
        for key in {"base", "file"} & table.keys():  # relative to the working directory
            table[key] = os.path.abspath(table[key])
    (folder / "case.toml").write_text(to_toml(case), "utf-8")


def _require_answer(ended, folder):
    """The folder may hold the result of an earlier run: the program says what it has done."""
    try:
        answers = json.loads(ended.stdout)["results"]
        has_run = any(Path(answer["folder"]) == folder for answer in answers)
    except (ValueError, KeyError, TypeError):
        has_run = False
    if not has_run or not any((folder / name).exists() for name in ("result.h5", "sweep.json")):
        raise Error(f"{ended.args[0]} ended with exit code {ended.returncode}, but does not say "
                    f"that it has run the case\n{ended.stderr.strip()}".strip())


def run(case, out=None, methods=(), overrides=None, threads=0, report=False, fields="map"):
    """Runs a case and returns its Result, or the Sweep if it is one. Without `out` the files are
    in a temporary folder, which is removed. A result is also returned if a step did not converge
    (exit_code 3) or, with `report`, an expectation is not met (1); `report` also writes summary
    and report.html.

    case       a dict, or the path or name of a case
    overrides  keys of the case file and their values: {"surface.points": 128}
    fields     map: fields and heights are those of a measured map; cell: also those of the mirror
               images that continue it
    """
    with tempfile.TemporaryDirectory(prefix="asperity-") as scratch:
        folder = Path(out or scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        words = ["run", case, "--quiet", "--json", "--out", folder]
        if isinstance(case, dict):
            _write_case(case, folder)
            words[1] = folder / "case.toml"
        words += ["--methods", ",".join(methods)] if methods else []
        words += ["--threads", threads] if threads else []
        words += [] if report else ["--no-report"]
        for key, value in (overrides or {}).items():
            words += ["--set", f"{key}={_toml_value(value)}"]
        ended = _ended(words)
        if ended.returncode not in (0, 1, 3):
            raise Error(ended.stderr.strip() or f"exit code {ended.returncode}")
        _require_answer(ended, folder)
        return read(folder, ended.returncode, fields)


def press(heights, length, contact_modulus, pressures, level="none", edges="periodic", threads=0,
          fields="map", **tables):
    """Presses heights on an elastic half-space, in hard contact without friction unless the tables
    say more, by `run`. Returns the Method, with arrays [step] of one number per pressure,
    `fields[step]`, the maps (pressure [Pa], gap [m]) in double precision, each [y, x], and
    `result`, the Result that it is part of.

    heights          [m], an array [y, x] of square pixels; positive towards the half-space. Up to
                     5 % may be NaN, points that were not measured, which are interpolated
    length           side along x [m], or a text with a unit: "10 um"
    contact_modulus  E* [Pa], or a text with a unit
    pressures        one or several nominal pressures [Pa], or texts with units
    level            what is removed from the map: none, plane, bow, sphere, cylinder
    edges            periodic: the array is one cell; mirror: it continues by its mirror images;
                     free: it is pressed once, on an infinite half-space
    fields           map: the maps have the shape of the array; cell: with the mirror images
    tables           further keys of the case, by table, with numbers in SI or texts with units:
                     halfspace={"contact": "exponential", "work_of_adhesion": "50 mJ/m^2"} (pressures
                     up and down again give the hysteresis), halfspace={"hardness": "2 GPa"},
                     flow={"viscosity": "0.89 mPa s", "pressure_drop": "100 kPa"},
                     conductance={"thermal_conductivity": 0.2, "counter_thermal_conductivity": 16},
                     friction={"coefficient": 0.5}, material={"poisson_ratio": 0.3}
    """
    case = {"schema": 1, "title": "Heights from Python",
            "surface": {"heights": heights, "length": length, "level": level, "edges": edges},
            "material": {"contact_modulus": contact_modulus},
            "load": {"nominal_pressure": np.atleast_1d(pressures).tolist()},
            "halfspace": {"contact": "hard"},
            "report": {"fields": "all", "precision": "double"}}
    for name, table in tables.items():
        case[name] = {**case.get(name, {}), **table}
    result = run(case, threads=threads, fields=fields)
    contact = copy.copy(result["halfspace"])
    contact.result = result
    for name in contact.columns:
        setattr(contact, name, getattr(contact, name)[0])
    return contact


def read(path, exit_code=0, fields="map"):
    """Reads a result or a sweep that exists: its folder, its file sweep.json, or the file of a
    result, whatever its name. The fields are those of the user's map, or of the whole "cell" that
    was pressed."""
    path = Path(path)
    is_sweep = path.name == "sweep.json" or (
        (path / "sweep.json").exists() and not (path / "result.h5").exists())
    if is_sweep:
        return Sweep(path if path.is_dir() else path.parent, exit_code, fields)
    return Result(path, exit_code, fields)
