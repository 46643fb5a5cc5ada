#!/usr/bin/env python3
"""`asperity surface` from the command line: numbers, files, messages.

surface_command_test.py PROGRAM FOLDER: runs the program on maps that are written
into FOLDER, and on the real maps of the folder ASPERITY_TEST_DATA if it is set.
"""
import bz2
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np


def run(program, *words, code=0):
    """The output of a command, after a check of its exit code; with --json, only the
    standard output."""
    ended = subprocess.run([program, "surface", *map(str, words)], text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert ended.returncode == code, f"{words}: {ended.returncode}\n{ended.stdout}{ended.stderr}"
    return ended.stdout + ("" if "--json" in words else ended.stderr)


def write_map(path, heights):
    path.write_text("\n".join(" ".join(f"{h:.12g}" for h in row) for row in heights) + "\n")


def wave(points):
    """16 waves of 3 nm along x, and a tilt."""
    x = np.arange(points) / points
    return 3.0 * np.cos(2 * np.pi * 16 * x)[None, :] + 0.5 * np.arange(points)[:, None]


def rough(points, seed, side, hurst=0.8, roll_off=8):
    """A corner of a self-affine surface of twice the side; heights in nm."""
    n = 2 * points
    rng = np.random.default_rng(seed)
    q = np.hypot(*np.meshgrid(np.fft.fftfreq(n, 1 / n), np.fft.fftfreq(n, 1 / n)))
    q /= 2 * side
    with np.errstate(divide="ignore"):
        amplitude = np.maximum(q, roll_off) ** (-1 - hurst)
    amplitude[0, 0] = 0
    heights = np.fft.ifft2(np.fft.fft2(rng.standard_normal((n, n))) * amplitude).real
    return heights[:points, :points] * 1e3


def check_wave(program, folder):
    map_file = folder / "wave.txt"
    write_map(map_file, wave(128))
    scale = ["--length", "10 um", "--height-unit", "nm"]
    answer = json.loads(run(program, map_file, *scale, "--json"))
    found = answer["maps"][0]["parameters"]
    # The tilt is removed, and both methods find 3 nm/sqrt(2); forward differences see sin(x)/x of it.
    rms = 3e-9 / np.sqrt(2)
    slope = 2 * np.pi * 16 / 10e-6 * rms
    assert abs(found["sq"]["value"] / rms - 1) < 2e-2
    assert abs(found["sq"]["by_spectrum"] / rms - 1) < 2e-2
    assert abs(found["sdq"]["by_spectrum"] / slope - 1) < 2e-2
    assert abs(found["sdq"]["value"] / slope - np.sinc(16 / 128)) < 2e-2
    assert not (folder / "out").exists(), "--json wrote a report"
    printed = run(program, map_file, *scale, "--no-report")
    assert "128 x 128 points over 10 µm x 10 µm" in printed and "Sq" in printed
    assert not (folder / "out").exists(), "--no-report wrote a report"
    assert run(program, map_file, *scale, "--no-report", "--quiet") == ""


def check_report(program, folder):
    map_file = folder / "rough.txt"
    write_map(map_file, rough(96, 1, 1.0))
    printed = run(program, map_file, "--length", "10 um", "--height-unit", "nm", "--contact-modulus",
                  "2 GPa", "--tip-radius", "10 nm", "--out", folder / "page", "--figures", "svg", "--width",
                  "60mm", "--units", "reduced")
    assert "contact by Persson's theory" in printed
    page = (folder / "page/report.html").read_text()
    assert page.count("data:image/svg+xml") == 8 and "could not be drawn" not in page
    # All figures can be explored, the map without the library of the curves.
    assert page.count('<script type="application/json">') == 8
    drawn = {path.stem for path in (folder / "page/figures").glob("*.svg")}
    assert {"topography", "map-spectrum", "predicted-area", "predicted-cut-off"} <= drawn, drawn
    # The same figures for a journal, in the units that were asked for.
    journal = folder / "page/journal"
    assert {path.stem for path in journal.glob("*.svg")} == drawn, list(journal.iterdir())
    picture = (journal / "predicted-area.svg").read_text()
    assert 'width="60mm"' in picture and "MPa" not in picture, picture[:300]
    assert "MPa" in (folder / "page/figures/predicted-area.svg").read_text()
    kept = json.loads((folder / "page/surface.json").read_text())
    loads = kept["contact"]["loads"]
    assert len(loads) == 31 and loads[0]["mean_gap"] > loads[-1]["mean_gap"]
    # A/A_0 = erf(sqrt(2) p/(E* h')) at the largest load, p = E* h'
    assert abs(loads[-1]["area_fraction"] - 0.954499736) < 1e-6
    # Down to the end of the reliable range, the cut-off leaves h', and the light load is E* h'/100.
    rows = [line.split(",") for line in (folder / "page/figures/predicted-cut-off.csv").read_text().splitlines()[1:]]
    end = 2e6 * np.pi / kept["maps"][0]["reliable"]["high"]
    light = [float(row[3]) for row in rows if float(row[2]) >= end * (1 - 1e-6)]
    assert abs(light[-1] - 0.0159566) < 1e-6 and light[0] > light[-1], light
    # The table is one that a case reads.
    case = folder / "case.toml"
    case.write_text('schema = 1\n[surface]\nkind = "spectrum"\nfile = "page/spectrum.txt"\n'
                    '[material]\ncontact_modulus = "2 GPa"\n[load]\n'
                    'nominal_pressure = ["0.01 E*"]\n[theory]\ngamma = 0.42\n')
    subprocess.run([program, "run", case, "--out", folder / "run", "--no-report"], check=True,
                   stdout=subprocess.DEVNULL)


def check_several(program, folder):
    """Each map is analysed for itself, and repeated scans limit each other."""
    write_map(folder / "wide.txt", rough(128, 2, 1.0))
    write_map(folder / "narrow.txt", rough(128, 3, 0.1))
    scales = ["--height-unit", "nm", "--json"]
    channels = run(program, folder / "wide.txt", "--channels")
    assert "128 x 128" in channels, channels
    listed = json.loads(run(program, folder / "wide.txt", "--channels", "--json"))
    assert listed[0]["file"] == str(folder / "wide.txt") and listed[0]["points"] == [128, 128], listed
    one = json.loads(run(program, folder / "wide.txt", "--length", "10 um", *scales))
    two = json.loads(run(program, folder / "narrow.txt", "--length", "1 um", *scales))
    for part, length in (("wide", "10.0"), ("narrow", "1.0")):
        text = (folder / f"{part}.txt").read_text()
        (folder / f"{part}-gwyddion.txt").write_text(
            f"# Width: {length} µm\n# Height: {length} µm\n# Value units: nm\n" + text)
    both = json.loads(run(program, folder / "wide-gwyddion.txt", folder / "narrow-gwyddion.txt", "--json"))
    for part, alone in zip(both["maps"], (one["maps"][0], two["maps"][0])):
        for end in ("low", "high"):
            assert np.isclose(part["reliable"][end], alone["reliable"][end]), (end, part["reliable"])
    message = run(program, folder / "wide-gwyddion.txt", folder / "narrow-gwyddion.txt", "--contact-modulus",
                  "2 GPa", "--no-report")
    assert "one map or line scan" in message, message
    assert "\nmean " in message and "\nstandard deviation " in message and "\noutliers: none\n" in message, message
    # Two scans of one place: what they do not share limits the range of both, and a third place none.
    place, rng = rough(128, 2, 1.0), np.random.default_rng(7)
    for scan in ("first", "second"):
        noise = rng.normal(0.0, np.diff(place).std(), place.shape)
        write_map(folder / f"{scan}.txt", place + (noise + np.roll(noise, 1, 0) + np.roll(noise, 1, 1)) / 3)
        (folder / f"{scan}.txt").write_text("# Width: 10.0 µm\n# Height: 10.0 µm\n# Value units: nm\n"
                                            + (folder / f"{scan}.txt").read_text())
    maps = json.loads(run(program, folder / "first.txt", folder / "second.txt",
                          folder / "narrow-gwyddion.txt", "--json"))["maps"]
    reasons = [entry["reliable"]["high_reason"] for entry in maps]
    assert reasons == ["noise between scans", "noise between scans", "sampling"], reasons


def check_against(program, folder):
    """Two faces are the sum of their heights, of which the second is turned over along x."""
    one, other = rough(64, 5, 1.0), rough(64, 6, 1.0)[:, :48]
    for name, heights in (("one", one), ("other", other)):
        write_map(folder / f"face-{name}.txt", heights)
        text = (folder / f"face-{name}.txt").read_text()
        (folder / f"face-{name}.txt").write_text(f"# Width: {heights.shape[1] / 8} µm\n# Height: 8.0 µm\n"
                                                 "# Value units: nm\n" + text)
    words = [folder / "face-one.txt", "--against", folder / "face-other.txt", "--level", "none", "--no-report"]
    printed = run(program, *words, "--write", folder / "faces.npy")
    assert "face-one.txt against face-other.txt: 48 x 64 points" in printed, printed
    expected = one[:, :48] - one.mean() + other[:, ::-1] - other.mean()
    written = np.load(folder / "faces.npy") * 1e9
    assert np.allclose(written, expected - expected.mean(), atol=1e-6 * np.abs(expected).max())
    check_pressed_faces(program, folder, words[:3])
    write_map(folder / "coarse.txt", other)
    message = run(program, folder / "wave.txt", "--against", folder / "coarse.txt", "--length", "10 um",
                  "--height-unit", "nm", code=2)
    assert "apart, but must be as those of wave.txt" in message, message


def check_pressed_faces(program, folder, faces):
    """`run A --against B` is `run` of their sum, keeps that sum, and names both."""
    import h5py # pylint: disable=import-outside-toplevel
    body = ["--counter-youngs-modulus", "70 GPa", "--counter-poisson-ratio", "0.3", "--youngs-modulus", "2 GPa",
            "--poisson-ratio", "0.4", "--pressure", "1 MPa", "--quiet", "--no-report"]
    message = subprocess.run([program, "run", *faces, "--pressure", "1 MPa", "--out", folder / "lost"], check=False,
                             capture_output=True, text=True)
    assert message.returncode == 2 and "--contact-modulus" in message.stderr, message.stderr
    assert not (folder / "lost").exists()
    message = subprocess.run([program, "run", faces[0], "--against", folder / "nothing.txt", *body], check=False,
                             capture_output=True, text=True)
    assert message.returncode == 2 and f"there is no map file {folder / 'nothing.txt'}" in message.stderr, message.stderr
    pressed = subprocess.run([program, "run", *faces, *body, "--level", "bow", "--out", folder / "faces-pressed", "--json"],
                             check=True, capture_output=True, text=True)
    answers = json.loads(pressed.stdout)["results"][0]["summary"]["answers"]
    assert answers[0].startswith("At 1 MPa ") and "of the area touches" in answers[0], answers
    run(program, *faces, "--level", "bow", "--no-report", "--write", folder / "levelled.gwy")
    subprocess.run([program, "run", folder / "levelled.gwy", *body, "--level", "none", "--out", folder / "faces-sum"], check=True)
    curves = []
    for result in ("faces-pressed", "faces-sum"):
        with h5py.File(folder / result / "result.h5") as file:
            curves.append(file["methods/halfspace/0/curve/mean_gap"][:])
            text = file.attrs["case_text"]
        sources = [line for line in text.splitlines() if line.startswith("#") and "SHA-256" in line]
        assert len(sources) == (2 if result == "faces-pressed" else 0), text
    assert np.array_equal(*curves) and curves[0][0] > 0.0, curves
    assert (folder / "faces-pressed/face-one-against-face-other.gwy").read_bytes()[:4] == b"GWYP"


def check_line(program, folder):
    x = np.arange(4096) / 4096
    rng = np.random.default_rng(5)
    q = np.maximum(np.fft.rfftfreq(4096, 1 / 4096), 10.0)
    z = np.fft.irfft(np.fft.rfft(rng.standard_normal(4096)) * q ** -1.3)
    table = folder / "line.txt"
    table.write_text("\n".join(f"{a:.9g}\t{b:.9g}" for a, b in zip(4000 * x, z)))
    message = run(program, table, code=2)
    assert "is a line scan" in message and "--length" in message
    answer = json.loads(run(program, table, "--length", "4 mm", "--height-unit", "um", "--json"))
    line = answer["lines"][0]
    assert line["points"] == 4096 and len(line["spectrum"]) > 5
    run(program, table, "--length", "4 mm", "--height-unit", "um", "--out", folder / "line-page")
    assert "could not be drawn" not in (folder / "line-page/report.html").read_text()


def check_channels(program, folder):
    """A number is text for a channel, and attributes of other datasets do not matter."""
    import h5py # pylint: disable=import-outside-toplevel
    heights = rough(32, 4, 1.0)
    scale = ["--length", "1 um", "--height-unit", "nm", "--json"]
    write_map(folder / "one.txt", heights)
    expected = json.loads(run(program, folder / "one.txt", *scale))["maps"][0]["parameters"]
    for channel in (["--channel", "1"], ["--set", "surface.channel=1"]):
        found = json.loads(run(program, folder / "one.txt", *scale, *channel))
        assert found["maps"][0]["parameters"] == expected
    message = run(program, folder / "one.txt", *scale[:-1], "--channel", "2", code=2)
    assert "has only one channel" in message, message
    with h5py.File(folder / "two.h5", "w") as file:
        file["a"], file["b"] = heights, heights
        file["a"].attrs["unit"] = "nm"
        file["a"].attrs["length"] = 1e-6
        file["b"].attrs["units"] = ["m", "m"]
        file["b"].attrs["length"] = [1.0, 2.0]
        file["c"] = np.arange(3)
        file["c"].attrs["units"] = [1, 2]
    for channel in ("a", "/a", "1"):
        found = json.loads(run(program, folder / "two.h5", "--channel", channel, "--json"))
        assert abs(found["maps"][0]["parameters"]["sq"]["value"] / expected["sq"]["value"] - 1) < 1e-9
    found = json.loads(run(program, folder / "two.h5", "--channel", "2", *scale))
    assert abs(found["maps"][0]["parameters"]["sq"]["value"] / expected["sq"]["value"] - 1) < 1e-9
    message = run(program, folder / "two.h5", "--channel", "b", "--length", "1 um", code=2)
    assert "surface.height_unit is missing: the unit of" in message, message
    assert "/b" in run(program, folder / "two.h5", "--channels")


def check_encodings(program, folder):
    """What neither we nor Gwyddion read is named, with what helps."""
    text = "1 2 3\n4 5 6\n7 8 10\n"
    for name, content, expected in [
            ("bom.txt", text.encode("utf-16"), "iconv"), ("le.txt", text.encode("utf-16-le"), "iconv"),
            ("be.txt", text.encode("utf-16-be"), "iconv"),
            ("map.txt.gz", gzip.compress(text.encode()), "gunzip"),
            ("map.txt.bz2", bz2.compress(text.encode()), "bunzip2"),
            ("latin.txt", "1 2\n3 \xf6\n".encode("latin-1"), "found '\xf6'")]:
        (folder / name).write_bytes(content)
        message = run(program, folder / name, "--length", "1 um", "--height-unit", "nm", code=2)
        assert expected in message, message


def check_fields(program, folder):
    """Fields of a result as maps: the pressure has the mean of the load, and the gap is closed
    where there is pressure. Gwyddion, where it is installed, reads the same map with its units."""
    (folder / "press.toml").write_text(
        'schema = 1\n[surface]\nkind = "sphere"\nlength = "1 mm"\npoints = 32\nradius = "10 mm"\n'
        '[material]\ncontact_modulus = "2 GPa"\n[load]\nnominal_pressure = ["1e-4 E*", "3e-4 E*"]\n'
        '[halfspace]\ncontact = "hard"\n[halfspace.free]\nboundaries = "free"\n[report]\nfields = "all"\n')
    out = folder / "pressed"
    subprocess.run([program, "run", folder / "press.toml", "--out", out, "--no-report"], check=True,
                   stdout=subprocess.DEVNULL)
    answer = json.loads(run(program, out, "--field", "pressure", "--write", folder / "p.npy", "--json"))
    assert answer["unit"] == "Pa" and answer["method"] == "halfspace" and answer["step"] == 1, answer
    assert answer["points"] == [32, 32] and np.allclose(answer["lengths"], 1e-3)
    pressure = np.load(folder / "p.npy")
    assert abs(pressure.mean() / 6e5 - 1) < 1e-6 and abs(answer["nominal_pressure"] / 6e5 - 1) < 1e-6
    run(program, out / "result.h5", "--field", "gap", "--write", folder / "g.npy")
    gap = np.load(folder / "g.npy")
    assert (gap[pressure > 0] < 1e-13).all() and gap[0, 0] > 1e-6 and (gap > -1e-13).all()
    run(program, out, "--field", "pressure", "--step", "0", "--method", "halfspace.free", "--write",
        folder / "p0.h5")
    import h5py # pylint: disable=import-outside-toplevel
    with h5py.File(folder / "p0.h5") as file:
        assert abs(file["pressure"][:].mean() / 2e5 - 1) < 1e-6 and file["pressure"].attrs["unit"] in ("Pa", b"Pa")
    for name, unit in [("pressure", "Pa"), ("gap", "m"), ("heights", "m")]:
        run(program, out, "--field", name, "--write", folder / f"{name}.gwy")
        files = [folder / f"{name}.gwy"]
        if shutil.which("gwyddion"):
            files.append(folder / f"{name}-again.gwy")
            subprocess.run(["gwyddion", f"--convert-to-gwy={files[1]}", files[0]], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for file in files:
            channel = json.loads(run(program, file, "--channels", "--json"))[0]
            assert channel["unit"] == unit and channel["points"] == [32, 32], channel
    if shutil.which("gwyddion"):
        run(program, folder / "gap-again.gwy", "--level", "none", "--no-report", "--write", folder / "again.npy")
        assert np.allclose(np.load(folder / "again.npy"), gap - gap.mean(), rtol=0, atol=1e-16)
    run(program, out, "--field", "gap", "--write", folder / "gap.x3p")
    found = json.loads(run(program, folder / "gap.x3p", "--json"))["maps"][0]
    assert np.allclose(found["lengths"], 1e-3)
    run(program, out, "--field", "pressure", "--write", folder / "p.txt")
    assert "# Value units: Pa" in (folder / "p.txt").read_text()
    for words, expected in [
            (["--field", "pressure"], "--write pressure.gwy"),
            (["--field", "pressure", "--write", folder / "p.x3p"], "X3P holds lengths only"),
            (["--field", "pressur", "--write", folder / "a.gwy"], "--field"),
            (["--field", "gap", "--step", "7", "--write", folder / "a.gwy"],
             "saved are, by method and step: halfspace 0, halfspace 1, halfspace.free 0"),
            (["--field", "gap", "--method", "fem", "--write", folder / "a.gwy"], "no fields of fem")]:
        message = run(program, out, *words, code=2)
        assert expected in message, message
    assert not (folder / "a.gwy").exists() and not (folder / "p.x3p").exists()


def check_faults(program, folder):
    """Spikes, form and missing points are named when the map is read, each in at most 20 words."""
    ground = rough(128, 11, 1.0, hurst=0.7, roll_off=8)
    ground *= 430 / ground.std()
    scale = ["--length", "1 mm", "--height-unit", "nm"]
    faulty = ground.copy()
    faulty.flat[751 + 1092 * np.arange(15)] += 5000
    faulty += 20e3 * ((np.arange(128) - 63.5) / 63.5)[None, :] ** 2
    for k in range(164):
        faulty.flat[100 * k] = np.nan
    for name, heights, expected in [("clean", ground, 0), ("faulty", faulty, 3)]:
        map_file = folder / f"{name}.txt"
        write_map(map_file, heights)
        printed = run(program, map_file, *scale, "--no-report")
        lines = [line for line in printed.splitlines() if "warning: " in line]
        assert len(lines) == expected, printed
        assert all(len(line.split()) <= 20 for line in lines), lines
        assert len(json.loads(run(program, map_file, *scale, "--json"))["maps"][0]["warnings"]) == expected
        pressed = subprocess.run(
            [program, "run", map_file, *scale, "--contact-modulus", "1 GPa", "--set",
             "load.nominal_pressure=1 MPa", "--methods", "theory", "--out", folder / f"{name}-run", "--no-report"],
            text=True, check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        begun = [line for line in pressed.stderr.splitlines() if line.startswith("warning: ")]
        assert len(begun) == expected, pressed.stderr
        assert all(len(line.split()) <= 20 for line in begun), begun
    assert "15 spikes of up to 5" in printed and "164 of 16384 points" in printed, printed
    assert "--set surface.crop_x" in printed, printed
    # What the lines name removes them; it is an option where there is one.
    named = re.findall("; (.*) removes", printed)
    assert named == ["--remove-spikes 8", "--level bow"], named
    mended = run(program, folder / "faulty.txt", *scale, "--no-report", *" ".join(named).split(),
                 "--set", "surface.max_missing=0.1")
    assert [line for line in mended.splitlines() if "warning" in line][0].startswith("  warning: 164 of"), mended
    assert "spikes of" not in mended and "form:" not in mended, mended


def check_few_rows(program, folder):
    """No wave of a map of few rows is reliable: the message names the file and what would help."""
    heights = np.random.default_rng(4).integers(0, 10, (4, 101))
    write_map(folder / "long.txt", heights)
    message = run(program, folder / "long.txt", "--length", "101 um", "--height-unit", "nm", "--no-report", code=2)
    assert "long.txt: 101 x 4 points: no wavelength is reliable" in message, message
    assert "8 times its larger spacing" in message and "--periodic" in message, message
    # The larger spacing exceeds a quarter of the shorter side.
    (folder / "strip.txt").write_text("# Width: 5 um\n# Height: 10 um\n# Value units: nm\n"
                                      "2 4 2 3\n5 1 0 2\n0 4 4 0\n1 6 0 4\n")
    message = run(program, folder / "strip.txt", "--no-report", code=2)
    assert "strip.txt: 4 x 4 points: no wavelength is reliable" in message, message


def check_case(program, folder):
    answer = json.loads(run(program, "wave-1d", "--json"))
    found = answer["maps"][0]
    amplitude = 0.003183098861837907 * found["lengths"][0]
    assert abs(found["parameters"]["sq"]["value"] / (amplitude / np.sqrt(2)) - 1) < 1e-9
    assert found["is_periodic"] and found["self_affine"] is None
    run(program, "self-affine", "--set", "surface.points=64", "--set", "surface.wavelength_short=8 h",
        "--no-report")
    write_map(folder / "some.txt", rough(32, 4, 1.0))
    (folder / "of-map.toml").write_text(
        'schema = 1\n[surface]\nkind = "measured"\nfile = "some.txt"\nlength = "1 um"\nheight_unit = "1 nm"\n'
        'level = "plane"\nedges = "mirror"\n[material]\ncontact_modulus = "1 GPa"\n'
        '[load]\nnominal_pressure = ["1 MPa"]\n[halfspace]\n')
    assert "second-order form" in run(program, folder / "of-map.toml", "--level", "bow", "--no-report")


def check_conversion(program, folder):
    heights = rough(32, 4, 1.0)
    write_map(folder / "some.txt", heights)
    run(program, folder / "some.txt", "--length", "1 um", "--height-unit", "nm", "--level", "none",
        "--no-report", "--write", folder / "some.npy")
    kept = np.load(folder / "some.npy")
    assert np.allclose(kept, 1e-9 * (heights - heights.mean()), atol=1e-18)


def check_messages(program, folder):
    scale = ["--length", "1 um", "--height-unit", "nm"]
    some = folder / "some.txt"
    flat = folder / "flat.txt"
    write_map(flat, np.zeros((8, 8)))
    line = folder / "inch.csv"
    line.write_text("Lateral [in],Raw [uin]\n"
                    + "".join(f"{0.1 + 0.001 * i:.3f},{i % 3}\n" for i in range(40)))
    tiny = folder / "tiny.txt"
    write_map(tiny, np.eye(3))
    for words, expected in [
            ([folder / "none.txt"], "there is no such file"),
            (["polimer"], "polymer"),
            (["paper"], "is a collection"),
            ([some], '--length "20 um"'),
            ([some, "--length", "1 Pa", "--height-unit", "nm"], '--length = "1 Pa" has the unit Pa'),
            ([some, "--length", "10", "--height-unit", "nm"],
             '--length = "10" has no unit; allowed: m, mm, um, nm, angstrom'),
            ([some, "--length", "1 um", "--height-unit", "5"], '--height-unit = "5" has no unit'),
            ([some, "--length", "1 um", "--height-unit", "Nm"], "nearest: nm"),
            ([line, "--length-unit", "3", "--height-unit", "nm"], '--length-unit = "3" has no unit'),
            ([line, "--length-unit", "mm"], "gives the unit 'in'"),
            ([some, "--tip-radius", "10", *scale], '--tip-radius = "10" has no unit'),
            ([some, *scale, "--level", "spere"], '--level = "spere", but must be'),
            ([some, *scale, "--tip-radius", "-1 nm"], "--tip-radius"),
            ([some, *scale, "--contact-modulus", "2 nm"], "--contact-modulus"),
            ([some, *scale, "--gamma", "2"], "--gamma"),
            ([some, *scale, "--write", folder / "a.docx"], ".npy"),
            ([some, *scale, "--set", "surface.levl=bow"], "level"),
            ([flat, *scale], "flat"),
            ([tiny, *scale], "tiny.txt: points per side"),
            ([], "input")]:
        message = run(program, *words, "--no-report", code=2)
        assert expected in message, f"{words}: {message}"
    assert not (folder / "a.docx").exists()


def check_real_maps(program):
    data = Path(os.environ.get("ASPERITY_TEST_DATA", ""), "afm-20um-256.txt")
    if not data.exists():
        print("skipped: ASPERITY_TEST_DATA names no folder of real maps")
        return
    found = json.loads(run(program, data, "--level", "bow", "--json"))["maps"][0]
    assert found["points"] == [256, 256]
    assert abs(found["parameters"]["sq"]["value"] - 6e-9) < 1e-9 # as its README says


def main(program, scratch):
    folder = Path(scratch)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    os.chdir(folder)
    os.environ["ASPERITY_CACHE"] = str(folder / "cache")
    check_wave(program, folder)
    check_conversion(program, folder)
    check_messages(program, folder)
    check_faults(program, folder)
    check_few_rows(program, folder)
    check_case(program, folder)
    check_several(program, folder)
    check_against(program, folder)
    check_line(program, folder)
    check_channels(program, folder)
    check_encodings(program, folder)
    check_fields(program, folder)
    check_report(program, folder)
    check_real_maps(program)


if __name__ == "__main__":
    main(*sys.argv[1:])
