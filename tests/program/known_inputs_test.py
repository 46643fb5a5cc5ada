#!/usr/bin/env python3
"""Inputs that once gave a wrong answer without a word, each with the right answer under its name.

known_inputs_test.py PROGRAM SOURCE FOLDER: the inputs are in tests/inputs. The right answers are those of
independent codes or exact formulas.
"""
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np


class Inputs:
    def __init__(self, program, source, folder):
        self.program, self.inputs, self.folder = program, source / "tests/inputs", folder

    def ended(self, *words):
        return subprocess.run([self.program, *map(str, words)], text=True, check=False, cwd=self.folder,
                              capture_output=True)

    def answer(self, *words):
        ended = self.ended(*words)
        assert ended.returncode == 0, f"exit code {ended.returncode}\n{ended.stdout}{ended.stderr}"
        return ended.stdout

    def surface(self, name, *words):
        text = self.answer("surface", self.inputs / name, *words, "--no-report", "--json")
        return json.loads(text)["maps"][0]

    def result(self, case, *words):
        out = self.folder / Path(case).stem
        self.answer("run", case, *words, "--no-report", "--out", out)
        return asperity.read(out)


def adhesive_flow(at):
    """An adhesive contact of 4 % was sealed; it leaks as the hard one beside it, in which less is closed."""
    result = at.result(at.inputs / "adhesive-flow.toml")
    hard, sticky = (result[f"halfspace.{law}"].leak_rate_x[0, 0] for law in ("hard", "sticky"))
    assert np.isclose(hard, 3.5e-15, rtol=0.02), hard
    assert 0.9 * hard < sticky < hard, (hard, sticky)


def sticky_map(at):
    """98 % of the map were shown in contact."""
    result = at.result(at.inputs / "sticky-map.toml", "--set", 'report.fields="all"')
    method = result["halfspace"]
    assert np.isclose(method.area_fraction[0, 0], 0.041, atol=1e-3)
    assert np.isclose(method.contact(0).mean(), method.area_fraction[0, 0], rtol=1e-12)


def stiff_sphere(at):
    """Rows missed their prescribed tension by up to 16 % and were called converged."""
    loads = at.result(at.inputs / "stiff-sphere.toml")["halfspace"].nominal_pressure[0]
    assert np.allclose(loads, [0.0, -98.17, -294.5, -490.9], atol=1e-3), loads


def strip(at):
    """The analysis of a map whose larger spacing exceeds a quarter of its side ended by a signal."""
    ended = at.ended("surface", at.inputs / "strip-gw.txt", "--no-report")
    assert ended.returncode == 2 and "strip-gw.txt: 4 x 4 points" in ended.stderr, ended


def rows_apart(at):
    """Curvature and Nayak's parameter depended on the distance of the rows."""
    for length in 16, 48:
        found = at.surface("rows-apart.txt", "--level", "none", "--length", "16 um", "--height-unit", "um",
                           "--set", f"surface.length_y={length} um")["parameters"]
        assert np.isclose(found["rms_curvature"]["value"], 1.996e5, rtol=1e-3), found
        assert np.isclose(found["nayak"]["value"], 1.694, rtol=1e-3), found


def curves(at):
    """Curves as Excel and pandas save them had unknown columns."""
    at.result(at.inputs / "adhesive-flow.toml")
    for name in "excel-utf8.csv", "quoted.csv":
        at.answer("report", at.folder / "adhesive-flow", at.inputs / name, "--out", at.folder / "page")


def missing_in_x3p(at):
    """A point without a datum was refused; it is missing, and filled."""
    at.answer("surface", at.inputs / "x3p-absxy-missing.x3p", "--no-report")


def inches(at):
    """A unit that contradicts the header of the file was accepted."""
    ended = at.ended("surface", at.inputs / "inch.csv", "--length-unit", "mm", "--no-report")
    assert ended.returncode == 2 and "gives the unit 'in'" in ended.stderr, ended


def blocked(at):
    """A refused run of several maps blocked its own folder."""
    maps, out = at.folder / "maps", at.folder / "maps-out"
    maps.mkdir()
    for s in 1, 2:
        rows = "".join(f"{s}e-9 -{j}e-9 {j}e-9 0\n" for j in range(1, 5))
        (maps / f"{s}.txt").write_text("# Channel: Z\n# Width: 4 um\n# Height: 4 um\n# Value units: m\n" + rows)
    (maps / "plain.txt").write_text(rows) # a map without its length
    words = ("run", maps, "--contact-modulus", "2 GPa", "--no-report", "--out", out)
    refused = at.ended(*words)
    assert refused.returncode == 2 and "plain.txt" in refused.stderr, refused
    assert not out.exists()
    (maps / "plain.txt").unlink()
    at.answer(*words)


def blur(at):
    """A map that the instrument blurred by 0.4 pixel had H = 1.21 [1.13, 1.28]; it is 0.8."""
    n, length, hurst, roll_off = 512, 10e-6, 0.8, 4e-6
    q = 2 * np.pi * np.fft.fftfreq(n, length / n)
    wavevector = np.hypot(*np.meshgrid(q, q, indexing="ij"))
    size = np.where(wavevector > 0, np.maximum(wavevector, 2 * np.pi / roll_off)**(-1 - hurst), 0)
    noise = np.fft.fft2(np.random.default_rng(50).standard_normal((n, n)))
    heights = np.fft.ifft2(noise * size * np.exp(-((wavevector * 8e-9)**2) / 2)).real
    np.save(at.folder / "blur.npy", 25e-9 / heights.std() * heights)
    found = at.surface(at.folder / "blur.npy", "--length", "10 um", "--height-unit", "m")
    hurst = found["self_affine"]["hurst"]
    assert hurst["low"] < 0.8 < hurst["high"] and abs(hurst["value"] - 0.8) < 0.05, hurst


def describe(at):
    """Tabor's parameter and curvature of a sphere were those of cusps at its border, and of the grid."""
    text = at.answer("describe", "adhesive-sphere")
    for name, value in ("rms_curvature", 1e6), ("tabor_parameter", 0.8877), ("stickiness", 2.504):
        line, = (line for line in text.splitlines() if line.split()[:1] == [name])
        assert np.isclose(float(line.split()[1]), value, rtol=1e-3), line


def ridge(at):
    """A ridge that closes every row of a map that is pressed once leaked around the border."""
    x, y = np.meshgrid((np.arange(64) + 0.5) / 64, (np.arange(64) + 0.5) / 64)
    np.save(at.folder / "ridge.npy", 1e-6 * np.exp(-(((x - 0.3 - 0.4 * y) / 0.05)**2)))
    method = at.result(at.folder / "ridge.npy", "--length", "100 um", "--height-unit", "m", "--contact-modulus",
                       "1 GPa", "--set", "surface.edges=free", "--set", "surface.level=none", "--set",
                       "load.nominal_pressure=2 MPa", "--set", "spots={}", "--flow", "water")["halfspace"]
    assert method.leak_rate_x[0, 0] == 0.0
    assert method.leak_rate_y[0, 0] > 0.0
    assert method.gap_count[0, 0] == 2  # before and behind the ridge, in the figure, too
    at.answer("report", at.folder / "ridge", "--only", "spots")
    rows = (at.folder / "ridge/figures/spots-halfspace.csv").read_text().splitlines()
    assert rows[-1].startswith('"gap') and rows[-1].endswith(",2"), rows


def main(program, source, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    at = Inputs(program, source, folder)
    failed = 0
    for test in (adhesive_flow, sticky_map, stiff_sphere, strip, rows_apart, curves,
                 missing_in_x3p, inches, blocked, blur, describe, ridge):
        try:
            test(at)
        except (AssertionError, AttributeError, KeyError, TypeError, ValueError) as error:
            failed += 1
            print(f"{test.__name__}: {test.__doc__}\n  {type(error).__name__}: {error}")
    sys.exit(failed > 0)


if __name__ == "__main__":
    sys.path.insert(0, str(Path(sys.argv[2]).resolve() / "python"))
    os.environ["ASPERITY_PROGRAM"] = sys.argv[1]
    os.environ["ASPERITY_CACHE"] = str(Path(sys.argv[3]).resolve() / "cache")
    import asperity
    main(sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve())
