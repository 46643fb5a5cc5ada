"""Free boundaries from a map to a report: the half-space uses the map itself,
other methods its mirror images; the report compares the two, a second run finds
every step in the cache, and a Hertzian contact has no periodic images.

Arguments: asperity, an empty folder.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

PROGRAM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
MAP_CASE = """schema = 1
[surface]
kind = "measured"
file = "map.txt"
level = "plane"
edges = "free"
[material]
contact_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["0.001 E*", "0.01 E*", "0.05 E*"]
[theory]
gamma = 0.4
[halfspace]
[halfspace.mirror]
boundaries = "periodic"
[fem]
element = "Q1"
[report]
fields = 3
"""
SPHERE_CASE = """schema = 1
[surface]
kind = "sphere"
length = "1 mm"
points = 256
radius = "10 length"
edges = "free"
[material]
contact_modulus = "2 GPa"
[load]
# Contact radii of 0.1 and 0.4 lengths.
nominal_pressure = ["1.3333333333333334e-4 E*", "8.533333333333333e-3 E*"]
[halfspace]
[expect]
approach_error = { below = 1e-3 }
contact_radius_error = { below = 2e-3 }
"""
ROUGH_CASE = """schema = 1
[surface]
kind = "self-affine"
length = "10 um"
points = 16
seed = 3
realizations = 2
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "8 h"
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = "10 MPa"
[halfspace]
boundaries = "free"
[halfspace.images]
boundaries = "periodic"
"""


def asperity(*arguments, expected=0):
    answer = subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=FOLDER, text=True, timeout=300,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        env=os.environ | {"ASPERITY_CACHE": str(FOLDER / "cache")})
    assert answer.returncode == expected, (arguments, answer.stdout)
    return answer.stdout


def write_map():
    """Rough heights of 48 by 32 points on 4.8 by 1.6 um, with a tilt."""
    random = numpy.random.default_rng(5)
    spectrum = numpy.fft.rfft2(random.standard_normal((32, 48)))
    fx = numpy.fft.rfftfreq(48)[None, :]
    fy = 0.5 * numpy.fft.fftfreq(32)[:, None]
    spectrum *= (numpy.hypot(fx, fy) + 0.04) ** -1.8
    heights = numpy.fft.irfft2(spectrum, s=(32, 48))
    heights *= 5.0 / heights.std()
    heights += 0.5 * numpy.arange(48)[None, :]
    numpy.savetxt(FOLDER / "map.txt", heights,
                  header="Width: 4.8 um\nHeight: 1.6 um\nValue units: nm")


def check_map():
    (FOLDER / "map.toml").write_text(MAP_CASE)
    text = asperity("run", "map.toml", "--out", "map")
    assert "12 steps: 12 computed" in text, text
    with h5py.File(FOLDER / "map" / "result.h5") as file:
        mirrored = file["surfaces/0/heights"][...]
        own = file["methods/halfspace/0/surface"]
        heights = own["heights"][...]
        assert mirrored.shape == (64, 96) and heights.shape == (32, 48)
        # The mean is removed from each map: they differ by its roundoff.
        numpy.testing.assert_allclose(mirrored[:32, :48], heights, rtol=0,
                                      atol=1e-22)
        numpy.testing.assert_allclose(mirrored[32:, 48:], heights[::-1, ::-1],
                                      rtol=0, atol=1e-22)
        pressure = file["methods/halfspace/0/fields/0/pressure"]
        assert pressure.shape == (32, 48)
        for method in ("halfspace.mirror", "fem"):
            group = file[f"methods/{method}/0"]
            assert "surface" not in group
            assert group["fields/0/pressure"].shape == (64, 96)
        free = file["methods/halfspace/0/curve/area_fraction"][...]
        mirror = file["methods/halfspace.mirror/0/curve/area_fraction"][...]
        bound = file["methods/halfspace/0/curve/certified_gap_error"][...]
    assert numpy.all(bound < 1e-2 * heights.std()), bound
    # The boundaries matter, but do not dominate.
    difference = numpy.abs(mirror / free - 1.0)
    assert numpy.all(difference > 1e-3) and numpy.all(difference < 0.3), difference
    page = (FOLDER / "map" / "report.html").read_text()
    assert "Free and periodic boundaries" in page
    assert "; 48 × 32 points over " in page, "the map itself is described"
    text = (FOLDER / "map" / "methods.txt").read_text()
    assert "continued by its mirror images where boundaries are periodic. It had 48 × 32" in text
    assert f"{100 * free[1]:.3g} %" in page and f"{100 * mirror[1]:.3g} %" in page
    again = asperity("run", "map.toml", "--out", "again", "--no-report")
    assert "0 computed, 12 from the cache" in again, again
    certified = json.loads(asperity("certify", "map", "--json"))
    assert "halfspace" in json.dumps(certified)


def check_map_alone():
    """No method needs the mirror images: neither their heights nor the map a
    second time are in the result, and the numbers are the same. The fields are
    not those of the cache, which are in single precision."""
    periodic = '[halfspace.mirror]\nboundaries = "periodic"\n[fem]\nelement = "Q1"\n'
    (FOLDER / "alone.toml").write_text(
        MAP_CASE.replace(periodic, "") + 'precision = "double"\n')
    text = asperity("run", "alone.toml", "--out", "alone")
    assert "3 computed, 3 from the cache" in text, text
    with h5py.File(FOLDER / "map" / "result.h5") as both, \
            h5py.File(FOLDER / "alone" / "result.h5") as alone:
        surface, own = alone["surfaces/0"], both["methods/halfspace/0/surface"]
        assert "surface" not in alone["methods/halfspace/0"]
        assert numpy.array_equal(surface["heights"], own["heights"])
        for name in ("rms_height", "rms_slope", "rms_curvature", "skewness"):
            assert surface.attrs[name] == both["surfaces/0"].attrs[name], name
        assert numpy.array_equal(surface["spectrum/height_spectrum"],
                                 both["surfaces/0/spectrum/height_spectrum"])
        for place in ("theory/0/curve/mean_gap", "halfspace/0/curve/mean_gap"):
            assert numpy.array_equal(alone["methods"][place], both["methods"][place])
        for field in ("pressure", "gap"):
            place = f"methods/halfspace/0/fields/0/{field}"
            assert both[place].dtype == "float32" and alone[place].dtype == "float64"
            assert numpy.array_equal(alone[place][...].astype("float32"), both[place])
            assert not numpy.array_equal(alone[place], both[place]), field
    bounds = [json.loads(asperity("certify", name, "--json")) for name in ("map", "alone")]
    single, double = [[field["duality_gap [J/m^2]"] for field in bound
                       if field["method"] == "halfspace"] for bound in bounds]
    assert max(double) < 0.5 * max(single), (single, double)


def check_refusals():
    text = asperity("problem", "map.toml", expected=2)
    assert "halfspace.boundaries = \"periodic\" is allowed" in text, text
    text = asperity("run", "map.toml", "--set", "load={mean_gap=[1e-9]}", "--out",
                    "refused", expected=2)
    assert "please prescribe nominal_pressure" in text, text
    assert not (FOLDER / "refused").exists()


def check_sphere():
    (FOLDER / "sphere.toml").write_text(SPHERE_CASE)
    text = asperity("run", "sphere.toml", "--out", "sphere")
    assert text.count("\nok ") == 2, text
    # With periodic images the exact solution is that of a square array of spheres.
    text = asperity("run", "sphere.toml", "--set", 'surface.edges="periodic"',
                    "--out", "images")
    assert "approach_error" in text and text.count("\nok ") == 2, text


def check_realizations():
    """The table of both boundaries is of one realisation, and says so."""
    (FOLDER / "rough.toml").write_text(ROUGH_CASE)
    asperity("run", "rough.toml", "--out", "rough")
    page = (FOLDER / "rough" / "report.html").read_text()
    assert "Realisation 0 of 2. The same surface" in page
    assert "Realisation 0 of" not in (FOLDER / "map" / "report.html").read_text()


shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
write_map()
check_map()
check_map_alone()
check_refusals()
check_sphere()
check_realizations()
print("free boundaries: as described")
