"""A measured map with mirror images: its numbers, maps and figures are about the map.

The same cell is also pressed as a periodic map. All intensive columns of both are the same, the
extensive ones are those of a map of a quarter of the area, and spots are counted on the map.

Arguments: asperity, an empty folder, the folder of asperity.py.
"""
import os
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

PROGRAM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, sys.argv[3])
os.environ["ASPERITY_PROGRAM"] = PROGRAM
os.environ["ASPERITY_CACHE"] = str(FOLDER / "cache")

ROWS, COLUMNS = 12, 16
CASE = """schema = 1
[surface]
kind = "measured"
file = "{file}.npy"
length = "{length} nm"
level = "none"
edges = "{edges}"
height_unit = "1 m"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["2 MPa", "8 MPa", "20 MPa"]
[halfspace]
contact = "hard"
[fem]
contact = "hard"
element = "Q1"
[fem.block]
solver = "full"
element = "Q1"
contact = "hard"
depth = "0.5 length"
stiffness = true
[flow]
viscosity = "1 mPa s"
pressure_drop = "100 kPa"
[spots]
[conductance]
thermal_conductivity = "5 W/(m K)"
counter_thermal_conductivity = "20 W/(m K)"
[friction]
coefficient = 0.3
tangential_load = [0.5]
[report]
fields = "all"
precision = "double"
stress_inside = true
"""
# What a column is about: "same" for the map and the cell; "map": a quarter of the cell's; "spots":
# counted on the map; "work": of the computation.
EXTENT = {"normal_stiffness": "map", "tangential_stiffness": "map",
          "spot_count": "spots", "largest_spot": "spots", "gap_count": "spots",
          "largest_gap": "spots"}
WORK = {"iterations", "residual", "certified_gap_error", "estimated_gap_error", "cpu_time",
        "transforms", "transform_time", "observation_time", "linear_iterations",
        "preconditioner_setups", "unknowns", "memory", "step", "status", "is_unloading"}
# m^3 and m^3/s are the flow of a square and of the seal.
OF_A_SQUARE = {"flow_conductance_x", "flow_conductance_y", "leak_rate_x", "leak_rate_y",
               "effective_medium"}


def asperity(*arguments):
    answer = subprocess.run([PROGRAM, *map(str, arguments)], cwd=FOLDER, text=True, timeout=500,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert answer.returncode == 0, (arguments, answer.stdout)
    return answer.stdout


def write_maps():
    random = numpy.random.default_rng(3)
    spectrum = numpy.fft.rfft2(random.standard_normal((ROWS, COLUMNS)))
    fx, fy = numpy.fft.rfftfreq(COLUMNS)[None, :], numpy.fft.fftfreq(ROWS)[:, None]
    spectrum *= (numpy.hypot(fx, fy) + 0.1) ** -1.5
    heights = numpy.fft.irfft2(spectrum, s=(ROWS, COLUMNS))
    heights *= 5e-9 / heights.std()
    heights -= heights.mean()
    upper = numpy.hstack([heights, heights[:, ::-1]])
    numpy.save(FOLDER / "map.npy", heights)
    numpy.save(FOLDER / "cell.npy", numpy.vstack([upper, upper[::-1]]))
    for name, edges, length in (("map", "mirror", 400), ("cell", "periodic", 800)):
        (FOLDER / f"{name}.toml").write_text(
            CASE.format(file=name, edges=edges, length=length))
        asperity("run", f"{name}.toml", "--out", name)


def parts(inside):
    """Sizes of the sets of neighbours of a map, of which nothing continues."""
    left, sizes = set(zip(*map(list, numpy.nonzero(inside)))), []
    while left:
        found, size = [left.pop()], 0
        while found:
            row, column = found.pop()
            size += 1
            for place in ((row - 1, column), (row + 1, column), (row, column - 1),
                          (row, column + 1)):
                if place in left:
                    left.remove(place)
                    found.append(place)
        sizes.append(size)
    return sizes


def check_columns(own, periodic, shown):
    """own, periodic: groups of a method; shown: its maps on the user's map."""
    seen = set()
    for name, values in own["curve"].items():
        if name == "note" or name in WORK:
            continue
        unit = values.attrs["unit"]
        extensive = unit in ("N", "N/m", "m^2", "m^3", "m^3/s") or name.endswith("_count")
        extent = EXTENT.get(name, "same")
        assert not extensive or extent != "same" or name in OF_A_SQUARE, f"{name}: what is it about?"
        mine, theirs = values[...], periodic["curve"][name][...]
        if numpy.all(numpy.isnan(mine)) and numpy.all(numpy.isnan(theirs)):
            continue
        seen.add(name)
        if extent == "spots":
            continue
        numpy.testing.assert_allclose(
            mine, theirs / 4 if extent == "map" else theirs, rtol=2e-6,
            atol=1e-9 * numpy.nanmax(abs(theirs)), err_msg=f"{own.name}: {name}")
    node = (400e-9 / COLUMNS) ** 2
    for step, (pressure, gap) in shown.items():
        for name, inside in (("spot", pressure > 0), ("gap", pressure <= 0)):
            sizes = parts(inside)
            assert own["curve"][f"{name}_count"][step] == len(sizes), (own.name, step, name, sizes)
            numpy.testing.assert_allclose(own["curve"][f"largest_{name}"][step],
                                          max(sizes) * node, rtol=1e-9)
    return seen


def check_numbers(asperity_module):
    mine = asperity_module.read(FOLDER / "map")
    whole = asperity_module.read(FOLDER / "map", fields="cell")
    assert numpy.allclose(mine.heights[0], numpy.load(FOLDER / "map.npy"), atol=1e-20)
    assert whole.heights[0].shape == (2 * ROWS, 2 * COLUMNS)
    seen = set()
    with h5py.File(FOLDER / "map/result.h5") as map_file, \
            h5py.File(FOLDER / "cell/result.h5") as cell_file:
        for place in ("surfaces/0", "methods/halfspace/0/fields/0", "methods/fem.block/0/fields/2"):
            for file, factor in ((map_file, 1), (cell_file, 2)):
                assert file[place].attrs["map_points_x"] == factor * COLUMNS, place
                assert file[place].attrs["map_points_y"] == factor * ROWS, place
        for method in map_file["methods"]:
            own, periodic = (file[f"methods/{method}/0"] for file in (map_file, cell_file))
            shown, cell = mine[method].fields, whole[method].fields
            if "fields" in own:
                assert len(shown) == 4  # the tangential load adds one
            for step, maps in shown.items():
                for one, other, name in zip(maps, cell[step], ("pressure", "gap")):
                    assert one.shape == (ROWS, COLUMNS) and other.shape == (2 * ROWS, 2 * COLUMNS)
                    assert numpy.array_equal(one, other[:ROWS, :COLUMNS])
                    assert numpy.array_equal(other, own[f"fields/{step}/{name}"][...])
            seen |= check_columns(own, periodic, shown)
    expected = {"normal_stiffness", "tangential_stiffness", "spot_count", "largest_gap",
                "leak_rate_x", "flow_conductance_y", "effective_medium", "spot_radii",
                "relative_conductance", "thermal_conductance", "mean_gap", "elastic_energy"}
    assert expected <= seen, expected - seen
    x, y, flux, narrowest = mine.flux("halfspace")
    assert flux.shape == (ROWS, COLUMNS) and max(x) < 400e-9 and max(y) < 300e-9
    assert narrowest[0] < 400e-9 and narrowest[1] < 300e-9
    stress = mine.tables["stress-inside-halfspace"]
    assert max(stress["x"]) < 400e-9 and max(stress["y"]) < 300e-9


def size_of(path):
    """The shape of a map in the data of a figure: its first row has the number of columns."""
    rows = [line.split(",") for line in path.read_text().splitlines() if line.strip()]
    return len(rows) - 1, len(rows[0]) - 1


def check_figures():
    maps = sorted(path for path in (FOLDER / "map/figures").glob("*.csv")
                  if path.name.startswith(("surface-map", "maps-", "traction-"))
                  and path.stem.split("-")[-1] not in ("halfspace", "fem", "block"))
    shapes = {path.name: size_of(path) for path in maps}
    assert len(shapes) >= 13, sorted((FOLDER / "map/figures").iterdir())
    assert set(shapes.values()) == {(ROWS, COLUMNS)}, shapes
    words = (FOLDER / "map/methods.txt").read_text()
    assert f"{COLUMNS} × {ROWS} points over 400 nm × 300 nm" in words, words
    # The load of the table is that of the map.
    page = (FOLDER / "map/report.html").read_text()
    assert "240 nN" in page and "2.4 µN" in page  # 2 MPa and 20 MPa on .12 um^2


def check_field():
    for words, shape in (((), (ROWS, COLUMNS)), (("--cell",), (2 * ROWS, 2 * COLUMNS))):
        for field in ("pressure", "gap", "heights"):
            name = f"{field}{len(words)}.npy"
            answer = asperity("surface", "map", "--field", field, "--write", name, *words)
            assert f"{shape[1]} x {shape[0]} points" in answer, answer
            assert numpy.load(FOLDER / name).shape == shape


def main():
    import asperity as asperity_module
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    write_maps()
    check_numbers(asperity_module)
    check_figures()
    check_field()


main()
