#!/usr/bin/env python3
"""The module asperity.py: dicts as cases, results as arrays.

asperity_test.py PROGRAM SOURCE FOLDER: runs small cases in FOLDER, which is emptied first.
"""
import os
import shutil
import sys
import tomllib
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
    check_options_and_errors(asperity)


if __name__ == "__main__":
    main(*sys.argv[1:])
