#!/usr/bin/env python3
"""The module asperity.py: dicts as cases, results as arrays, its installation by pip.

asperity_test.py PROGRAM SOURCE FOLDER: runs small cases in FOLDER, which is emptied first.
"""
import os
import re
import shutil
import subprocess
import sys
import tomllib
import warnings
from pathlib import Path

import h5py
import numpy as np

CASE = {
    "schema": 1,
    "title": 'quotes " and \\ and umlauts äöü',
    "surface": {"kind": "wave-1d", "length": "1 um", "points": np.int64(32),
                "amplitude": "2 nm", "wavelength": "1 length"},
    "material": {"youngs_modulus": 2e9, "poisson_ratio": 0.3},
    "load": {"nominal_pressure": {"from": "1e-3 E*", "to": "4e-3 E*", "steps": 3,
                                  "spacing": "log"}},
    "halfspace": {"contact": "hard", "loose": {"tolerance": 1e-4}},
    "report": {"fields": "all"},
    "expect": {"iterations_max": [{"below": 1000, "methods": ["halfspace"]}]},
}


def check_toml(asperity):
    """A TOML parser reads back what was written."""
    odd = {"a b": 1, "text": "\x7f \n \" \\", "x": {"y.z": {"list": [1, 2.5, "t"], "flag": True}, "e": 1e-30}}
    assert tomllib.loads(asperity.to_toml(odd)) == odd, asperity.to_toml(odd)
    expected = {**CASE, "surface": {**CASE["surface"], "points": 32}}
    assert tomllib.loads(asperity.to_toml(CASE)) == expected
    for wrong in (None, object(), {1, 2}):
        try:
            asperity.to_toml({"a": wrong})
        except TypeError as error:
            assert "no counterpart" in str(error)
        else:
            raise AssertionError(f"{wrong!r} was written")


def check_run(asperity, folder):
    """The arrays are those of the file, and the contact width is Westergaard's."""
    result = asperity.run(CASE, out=folder / "wave")
    curve = result["halfspace"]
    assert result.exit_code == 0 and list(result) == ["halfspace", "halfspace.loose"]
    assert curve.mean_gap.shape == (1, 3) and curve.kind == "halfspace"
    with h5py.File(folder / "wave/result.h5") as file:
        same = file["methods/halfspace/0/curve/mean_gap"][()]
    assert np.array_equal(curve.mean_gap[0], same)
    modulus = 2e9 / (1 - 0.3**2)
    assert np.isclose(result.contact_modulus, modulus)
    assert np.allclose(curve.nominal_pressure, modulus * np.array([1e-3, 2e-3, 4e-3]))
    full = np.pi * modulus * 2e-9 / 1e-6  # pressure of full contact
    width = 2 / np.pi * np.arcsin(np.sqrt(curve.nominal_pressure[0] / full))
    assert np.all(abs(curve.area_fraction[0] - width) < 2 / 32), (curve.area_fraction, width)
    assert sorted(curve.fields) == [0, 1, 2]
    pressure, gap = curve.fields[2]
    assert pressure.shape == gap.shape == (32, 32)
    assert np.isclose(pressure.mean(), curve.nominal_pressure[0, 2], rtol=1e-5)
    again = asperity.read(folder / "wave/result.h5")
    assert np.array_equal(again["halfspace"].mean_gap, curve.mean_gap)
    other = folder / "wave/other.h5"
    shutil.copy(folder / "wave/result.h5", other)
    with h5py.File(other, "r+") as file:
        file["methods/halfspace/0/curve/mean_gap"][...] += 1
    theirs = asperity.read(other)
    assert np.array_equal(theirs["halfspace"].mean_gap, curve.mean_gap + 1)
    with h5py.File(other, "r+") as file:  # rows may be in any order
        for column in file["methods/halfspace/0/curve"].values():
            column[...] = column[()][[2, 0, 1]]
    assert np.array_equal(asperity.read(other)["halfspace"].mean_gap, curve.mean_gap + 1)
    with h5py.File(other, "r+") as file:
        file["methods/halfspace/0/curve/step"][0] = 3
    missing = asperity.read(other)["halfspace"].mean_gap
    assert missing.shape == (1, 4) and np.isnan(missing[0, 2]), missing
    assert np.array_equal(missing[0, [0, 1, 3]], curve.mean_gap[0] + 1), missing
    with h5py.File(other, "r+") as file:
        del file["methods/halfspace/0/curve/mean_gap"]
        file["methods/halfspace/0/curve"].create_dataset("mean_gap", (10**9,), "f8", chunks=(1000,))
    (folder / "wave/none.h5").write_text("no HDF5")
    with h5py.File(folder / "wave/foreign.h5", "w") as file:
        file["x"] = [1.0]
    for wrong, words in (("lost.h5", "there is no such file"), ("none.h5", "none.h5: "),
                         ("foreign.h5", "is no result of Asperity"),
                         ("other.h5", "(1000000000,), but must have (3,)")):
        try:
            asperity.read(folder / "wave" / wrong)
        except asperity.Error as error:
            assert words in str(error), error
        else:
            raise AssertionError(f"{wrong} was read")
    try:
        result["hafspace"]
    except KeyError as error:
        assert "this result has halfspace" in str(error)
    else:
        raise AssertionError("there is no such method")


def check_heights(asperity, folder):
    """An array is used as the surface, and temporary files are removed."""
    x = np.arange(32) * 2 * np.pi / 32
    heights = 2e-9 * np.cos(x)[None, :] * np.ones((32, 1))
    case = {**CASE, "surface": {"heights": heights, "length": "1 um", "level": "none",
                                "edges": "periodic"}}
    result = asperity.run(case, methods=["halfspace"], threads=1)
    assert np.allclose(result.heights[0], heights, atol=1e-15)
    theirs = asperity.read(folder / "wave")["halfspace"]
    assert np.allclose(result["halfspace"].mean_gap, theirs.mean_gap, atol=1e-14)
    assert not result.folder.exists()


def check_notebook(asperity, folder):
    """A notebook shows the answers, the first figure and a table of each method."""
    shown = asperity.run(CASE, out=folder / "shown", report=True)._repr_html_() # pylint: disable=protected-access
    assert "of the area touches" in shown and shown.count("data:image/svg+xml;base64,PD94") == 1, shown[:500]
    assert shown.count("<h4>") == 2, shown


def check_press(asperity, folder):
    """Arrays go in and come out: the wave of the case, and loads that the maps carry."""
    x = np.arange(32) * 2 * np.pi / 32
    heights = 2e-9 * np.cos(x)[None, :] * np.ones((32, 1))
    theirs = asperity.read(folder / "wave")["halfspace"]
    pressures = theirs.nominal_pressure[0]
    contact = asperity.press(heights, 1e-6, 2e9 / (1 - 0.3**2), pressures)
    assert contact.mean_gap.shape == (3,) and contact.units["mean_gap"] == "m"
    assert contact.units["nominal_pressure"] == "Pa" and contact.units["area_fraction"] == "1"
    assert np.allclose(contact.mean_gap, theirs.mean_gap[0], atol=1e-14)
    for step, (pressure, gap) in contact.fields.items():
        assert np.isclose(pressure.mean(), pressures[step], rtol=1e-12)  # double precision
        assert np.all(np.abs(gap[pressure > 0]) < 1e-15)
    wide = np.ma.masked_greater(heights[:16], 1.99e-9)
    mirrored, same = (asperity.press(h, "1 um", "2 GPa", "1 MPa", level="plane", edges="mirror")
                      for h in (wide, wide.filled(np.nan)))
    assert mirrored.mean_gap.shape == (1,) and mirrored.fields[0][0].shape == (16, 32)
    cell = asperity.press(wide, "1 um", "2 GPa", "1 MPa", level="plane", edges="mirror",
                          fields="cell").fields[0]
    for shown, whole in zip(mirrored.fields[0], cell):
        assert whole.shape == (32, 64) and np.array_equal(whole[:16, :32], shown)
    assert mirrored.mean_gap == same.mean_gap
    # A table has what was computed, with units, and a notebook shows it without the cost.
    table = contact.table()
    assert list(table)[1] == "nominal_pressure [Pa]" and np.array_equal(table["mean_gap [m]"], contact.mean_gap)
    assert all(np.shape(column) == (3,) and np.isfinite(column).any() for column in table.values()), table
    shown = contact._repr_html_() # pylint: disable=protected-access
    assert shown.count("<tr>") == 4 and "nominal_pressure [Pa]" in shown and "cpu_time" not in shown, shown
    # Further tables of the case: a hardness caps the pressure, and studies have columns and tables.
    capped = asperity.press(heights, 1e-6, 2e9, 1e6, halfspace={"hardness": "3 MPa"},
                            conductance={"thermal_conductivity": 0.2, "counter_thermal_conductivity": 16},
                            flow={"viscosity": "0.89 mPa s", "pressure_drop": "100 kPa"})
    assert capped.fields[0][0].max() <= 3e6 * (1 + 1e-9) and capped.result["halfspace"].mean_gap == capped.mean_gap
    assert {"thermal_conductance [W/(m^2 K)]", "leak_rate_x [m^3/s]"} <= set(capped.table()), list(capped.table())
    slip = asperity.press(heights, 1e-6, 2e9, 1e6, friction={"coefficient": 0.5}, material={"poisson_ratio": 0.3})
    assert "stick_stiffness_x [Pa/m]" in slip.table(), list(slip.table())
    for wrong, words in ((heights[0], "[y, x]"), (heights * np.nan, "all points are missing")):
        try:
            asperity.press(wrong, 1e-6, 2e9, 1e6)
        except (ValueError, asperity.Error) as error:
            assert words in str(error), error
        else:
            raise AssertionError("wrong heights were pressed")


def check_sweep(asperity, folder):
    """The points of a sweep in their order; a case in the same folder is then no sweep."""
    case = {**CASE, "sweep": {"surface.amplitude": ["1 nm", 2e-9]}}
    sweep = asperity.run(case, out=folder / "sweep", methods=["halfspace"])
    assert sweep.values == [{"surface.amplitude": "1 nm"}, {"surface.amplitude": 2e-9}]
    areas = [point["halfspace"].area_fraction[0, 0] for point in sweep.points]
    theirs = asperity.read(folder / "wave")["halfspace"]
    assert areas[0] > areas[1] == theirs.area_fraction[0, 0]
    shutil.rmtree(folder / "sweep/points/001")
    assert asperity.read(folder / "sweep").points[1] is None
    assert isinstance(asperity.run(CASE, out=folder / "sweep"), asperity.Result)


def check_command(asperity, folder):
    """What a command prints; its warnings are those of Python; what cannot be started is named."""
    assert "wave-1d" in asperity.command("list")
    program = os.environ["ASPERITY_PROGRAM"]
    script = folder / "program"
    script.write_text("#!/bin/sh\necho warning: few digits >&2\n")
    script.chmod(0o755)
    os.environ["ASPERITY_PROGRAM"] = str(script)
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        asperity.command("list")
    assert [(str(w.message), w.filename) for w in seen] == [("few digits", __file__)], seen
    try:
        asperity.run(CASE)  # exit code 0, but no result
    except asperity.Error as error:
        assert "few digits" in str(error)
    else:
        raise AssertionError("there is no result")
    try:
        asperity.run(CASE, out=folder / "wave")  # which has the result of another run
    except asperity.Error as error:
        assert "does not say that it has run the case" in str(error), error
    else:
        raise AssertionError("the result of an earlier run was returned")
    script.chmod(0o644)
    try:
        asperity.command("list")
    except asperity.Error as error:
        assert str(error).startswith(f"{script} cannot be run: ") and "ASPERITY_PROGRAM" in str(error)
    else:
        raise AssertionError("the program was run")
    os.environ["ASPERITY_PROGRAM"] = program


def check_installation(source, folder):
    """What pip installs finds the script of its checkout, and says what to do if that is gone."""
    version = tomllib.loads((source / "python/pyproject.toml").read_text())["project"]["version"]
    assert version == re.search(r"project\(asperity VERSION (\S+)", (source / "CMakeLists.txt").read_text())[1]
    shutil.copytree(source / "python", folder / "a checkout/python")
    script = folder / "a checkout/asperity"
    script.write_text("#!/bin/sh\necho of the checkout\n")
    script.chmod(0o755)
    subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index",
                    "--root-user-action=ignore", "--target",
                    folder / "site", folder / "a checkout/python"], check=True)
    environment = {**os.environ, "PYTHONPATH": str(folder / "site"), "PATH": "/no/such/folder"}
    del environment["ASPERITY_PROGRAM"]

    def listed():
        return subprocess.run([sys.executable, "-c", "import asperity; print(asperity.command('list'))"],
                              env=environment, cwd=folder, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    assert listed().stdout == "of the checkout\n\n", listed()
    script.unlink()
    assert "by the environment variable ASPERITY_PROGRAM" in listed().stderr.splitlines()[-1], listed()


def check_options_and_errors(asperity):
    coarse = asperity.run("wave-1d", methods=["halfspace"], overrides={"surface.points": 16})
    assert coarse.heights[0].shape == (16, 16)
    strict = {**CASE, "expect": {"iterations_max": {"below": 0, "methods": ["halfspace"]}}}
    assert asperity.run(strict, report=True).exit_code == 1
    for wrong, words in ((dict(CASE, load={}), "nominal_pressure"), ("polymr", "polymer")):
        try:
            asperity.run(wrong)
        except asperity.Error as error:
            assert words in str(error), error
        else:
            raise AssertionError("a wrong case was run")


def check_flux(asperity, folder):
    """Along the valleys of a wave the flux is u^3 over its mean, exactly, and the widest path is
    that of the largest gap."""
    y = np.arange(32) * 2 * np.pi / 32
    case = {**CASE, "surface": {"heights": 2e-9 * np.cos(y)[:, None] * np.ones((32, 48)),
                                "length": "1.5 um", "level": "none", "edges": "periodic"},
            "halfspace": {"contact": "hard"}, "report": {"fields": "all", "precision": "double"},
            "flow": {"viscosity": 1e-3, "pressure_drop": 1e4}, "expect": {}}
    result = asperity.run(case, out=folder / "flux")
    pressure, gap = result["halfspace"].fields[2]
    cubed = np.where(pressure > 0, 0, gap)**3
    x, y, flux, narrowest = result.flux("halfspace")
    assert flux.shape == (len(y), len(x)) == (32, 48)
    assert np.allclose(flux, cubed / cubed.mean(), atol=1e-6)
    assert np.isclose(narrowest[1], y[np.argmax(gap[:, 0])])
    assert np.isclose(x[1], 1.5e-6 / 48) and "flow-halfspace" in result.tables
    try:
        result.flux("theory")
    except KeyError as error:
        assert "needs [flow]" in str(error)
    else:
        raise AssertionError("the theory has no flux")


def check_missing_package():
    """Without h5py the module says what to install."""
    sys.modules["h5py"] = None  # import then raises ImportError
    try:
        import asperity  # noqa: F401
    except ImportError as error:
        assert "h5py is not installed: apt-get install" in str(error), error
    else:
        raise AssertionError("the module needs h5py")
    del sys.modules["h5py"]


def main(program, source, scratch):
    folder = Path(scratch)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    os.chdir(folder)
    os.environ["ASPERITY_PROGRAM"] = program
    os.environ["ASPERITY_CACHE"] = str(folder / "cache")
    sys.path.insert(0, str(Path(source) / "python"))
    check_missing_package()
    import asperity
    check_toml(asperity)
    check_run(asperity, folder)
    check_heights(asperity, folder)
    check_notebook(asperity, folder)
    check_press(asperity, folder)
    check_flux(asperity, folder)
    check_sweep(asperity, folder)
    check_command(asperity, folder)
    check_installation(Path(source), folder)
    check_options_and_errors(asperity)


if __name__ == "__main__":
    main(*sys.argv[1:])
