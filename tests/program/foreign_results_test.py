"""Result files that other programs write with h5py: the minimum that
docs/reference/results.md requires is sufficient, also beside a result of ours, and a hostile
file is refused by exit code 2 and a message that names the object; it starts
no program, opens no other file and takes a negligible amount of memory.

Arguments: asperity, an empty folder.
"""
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import numpy

MODULUS = 2e9
CURVE = "methods/bem.mine/0/curve"
OUR_CASE = """schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 32
seed = 1
rms_height = "3 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "4 h"
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = ["0.001 E*", "0.01 E*"]
[halfspace]
contact = "hard"
"""
WAIT = 100  # seconds: what hangs ends here, and nothing good comes near


def write_least(path):
    """The minimum that docs/reference/results.md requires."""
    with h5py.File(path, "w") as file:
        file.attrs["format"] = "asperity-result"
        file.attrs["format_version"] = 1
        file.attrs["contact_modulus"] = MODULUS
        curve = file.create_group(CURVE)
        curve["nominal_pressure"] = [1e6, 2e6, 4e6]
        curve["mean_gap"] = [3e-9, 2e-9, 1e-9]


def asperity(arguments, folder, **environment):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=folder, text=True, timeout=WAIT,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        env=os.environ | {"ASPERITY_CACHE_SIZE": "0"} | environment,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))


def page_of(folder):
    """The report is well-formed in the parts that we fill in: no name adds a tag."""
    return (folder / "report.html").read_text(encoding="utf-8")


def check_least(folder):
    write_least(folder / "theirs.h5")
    done = asperity(["report", "theirs.h5", "--out", "alone"], folder)
    assert done.returncode == 0, done.stdout
    page = page_of(folder / "alone")
    assert "bem.mine" in page and "theirs" in page
    # Heights and times are not stated, so that there is no u/h_rms and no cost.
    assert "not drawn" not in done.stdout and "could not be drawn" not in page, done.stdout
    assert "nan s per step" not in page
    assert not list((folder / "alone/figures").glob("*")), done.stdout

    with h5py.File(folder / "theirs.h5", "a") as file:
        file[CURVE]["area_fraction"] = [0.01, 0.02, 0.04]
        file[CURVE]["iterations"] = [7, 8, 9]
        file.create_group("surfaces/0").attrs["rms_height"] = 1e-9
    done = asperity(["report", "theirs.h5", "--out", "more", "--figures", "svg"], folder)
    assert done.returncode == 0 and "not drawn" not in done.stdout, done.stdout
    for name in ("pressure-gap", "area-pressure", "cost"):
        assert (folder / f"more/figures/{name}.svg").exists(), done.stdout
    page = page_of(folder / "more")
    assert "at most 9 iterations" in page and "nan s per step" not in page

    empty = folder / "empty-path"
    empty.mkdir()
    done = asperity(["report", "theirs.h5", "--out", "without", "--figures", "svg"], folder,
                    PATH=str(empty))
    assert done.returncode == 4 and "figure not drawn: " in done.stdout, done.stdout
    assert "could not be drawn" in page_of(folder / "without")
    done = asperity(["report", "theirs.h5", "--out", "without"], folder, PATH=str(empty))
    assert done.returncode == 0, done.stdout

    (folder / "case.toml").write_text(OUR_CASE)
    ours = asperity(["run", "case.toml", "--out", "ours", "--no-report"], folder)
    assert ours.returncode == 0, ours.stdout
    done = asperity(["report", "ours", "theirs.h5", "--out", "both"], folder)
    assert done.returncode == 0, done.stdout
    page = page_of(folder / "both")
    assert "bem.mine" in page and "halfspace" in page
    csv = (folder / "both/figures/pressure-gap.csv").read_text()
    assert "bem.mine" in csv and "halfspace" in csv, csv


def external_link(file, folder):
    os.mkfifo(folder / "pipe")
    file["surfaces"] = h5py.ExternalLink("pipe", "/surfaces")


def soft_way_to_a_link(file, folder):
    file["outside"] = h5py.ExternalLink("/dev/zero", "/")
    file["surfaces"] = h5py.SoftLink("/outside/surfaces")


def external_storage(file, folder):
    del file[CURVE]["mean_gap"]
    file[CURVE].create_dataset("mean_gap", (3,), "f8",
                               external=[("/etc/passwd", 0, 24)])


def virtual_dataset(file, folder):
    del file[CURVE]["mean_gap"]
    layout = h5py.VirtualLayout((3,), "f8")
    layout[:] = h5py.VirtualSource("other.h5", "x", (3,))
    file[CURVE].create_virtual_dataset("mean_gap", layout)


def huge_column(file, folder):
    del file[CURVE]["mean_gap"]
    file[CURVE].create_dataset("mean_gap", (2 ** 45,), "f8", chunks=(1024,))


def huge_pressure(file, folder):
    del file[CURVE]["nominal_pressure"]
    file[CURVE].create_dataset("nominal_pressure", (2 ** 45,), "f8",
                               chunks=(1024,))


def wide(group, name, rows=10 ** 9):
    """A dataset whose values the file does not store."""
    if name in group:
        del group[name]
    group.create_dataset(name, (rows,), "f8", chunks=(10 ** 6,))


def wide_column(file, folder):
    wide(file[CURVE], "mean_gap")


def wide_columns(file, folder):
    for name in ("mean_gap", "nominal_pressure"):
        wide(file[CURVE], name)


def many_steps(file, folder):
    """Packed to a thousandth, these are values that the file has."""
    for name in ("mean_gap", "nominal_pressure"):
        del file[CURVE][name]
        file[CURVE].create_dataset(name, data=numpy.ones(2 * 10 ** 6), compression="gzip")


def wide_spectrum(file, folder):
    file["surfaces/0/spectrum/wavevector"] = [1.0, 2.0]
    wide(file["surfaces/0/spectrum"], "height_spectrum")


def wide_table(file, folder):
    file["tables/t/a"] = [1.0, 2.0]
    wide(file["tables/t"], "b")


def wide_list(file, folder):
    file["skipped/what"] = ["x"]
    wide(file["skipped"], "why")


def wide_maps(file, folder):
    for name in ("pressure", "gap"):
        file.create_dataset("methods/bem.mine/0/fields/0/" + name, (30000, 30000), "f4",
                            chunks=(1000, 1000))


def huge_map(file, folder):
    file.create_dataset("surfaces/0/heights", (2 ** 22, 2 ** 22), "f8",
                        chunks=(256, 256))


def huge_extent(file, folder):
    file.create_dataset("surfaces/0/heights", (2 ** 40, 2), "f4",
                        chunks=(256, 2))


def huge_texts(file, folder):
    file[CURVE].create_dataset("note", (2 ** 31,), "S1000000",
                               chunks=(1,))


def huge_variable_texts(file, folder):
    file[CURVE].create_dataset("note", (2 ** 40,), h5py.string_dtype(),
                               chunks=(1024,))


def two_dimensions(file, folder):
    del file[CURVE]["mean_gap"]
    file[CURVE]["mean_gap"] = numpy.zeros((3, 1))


def no_dimension(file, folder):
    del file[CURVE]["nominal_pressure"]
    file[CURVE]["nominal_pressure"] = 1e6


def points_out_of_range(file, folder):
    file.create_group("surfaces/0").attrs["points_x"] = 1e300


def far_realization(file, folder):
    file.move(CURVE, "methods/bem.mine/999999/curve")


def other_shape(file, folder):
    fields = file.create_group("methods/bem.mine/0/fields/0")
    fields["pressure"] = numpy.ones((4, 2))
    fields["gap"] = numpy.ones((2, 4))


def dataset_for_a_group(file, folder):
    file["surfaces"] = 1.0


def group_for_a_dataset(file, folder):
    del file[CURVE]["mean_gap"]
    file[CURVE].create_group("mean_gap")


def nested_case(file, folder):
    file.attrs["case_text"] = "a = " + "[" * 20000


def latin_1_title(file, folder):
    file.attrs["title"] = numpy.bytes_(b"Stra\xdfe")


def title_that_moves_the_cursor(file, folder):
    file.attrs["title"] = "a\x1b[2Jb"


def list_of_titles(file, folder):
    file.attrs["title"] = ["a", "b"]


def compound_modulus(file, folder):
    file.attrs["contact_modulus"] = numpy.zeros(1, [("a", "f8")])[0]


HOSTILE = {
    external_link: "/surfaces: ",
    soft_way_to_a_link: "/surfaces: ",
    external_storage: "mean_gap: stores its values in another file",
    virtual_dataset: "mean_gap: stores its values in another file",
    huge_column: "mean_gap",
    huge_pressure: "mean_gap has 3 values, but must have 35184372088832, as ",
    wide_column: "mean_gap has 1000000000 values, but must have 3, as ",
    wide_columns: "nominal_pressure has 1000000000 values, but must have at most 1000000",
    many_steps: "nominal_pressure has 2000000 values, but must have at most 1000000",
    wide_spectrum: "height_spectrum has 1000000000 values, but must have 2, as ",
    wide_table: "/b has 1000000000 values, but must have 2, as a",
    wide_list: "why has 1000000000 values, but must have 1, as what",
    wide_maps: "pressure: has 900000000 values, but the file stores only 0 bytes of them",
    huge_map: "heights = 4194304 points, but must be",
    huge_extent: "heights = 1099511627776 points, but must be",
    huge_texts: "note has 2147483648 values, but must have 3, as ",
    huge_variable_texts: "note has 1099511627776 values, but must have 3, as ",
    two_dimensions: "mean_gap: has 2 dimensions, but must have one",
    no_dimension: "nominal_pressure: has 0 dimensions, but must have one",
    points_out_of_range: "points_x = 1e+300 points, but must be an integer",
    far_realization: "999999 is realisation 999999, but must be below 1000",
    other_shape: "gap has [2, 4] values, but must have [4, 2], as pressure",
    dataset_for_a_group: "/surfaces: cannot open this group",
    group_for_a_dataset: "mean_gap: cannot find this dataset",
    nested_case: "is nested more than 32 levels deep",
    latin_1_title: 'title = "Straße", but must be UTF-8',
    title_that_moves_the_cursor: 'title = "a?[2Jb", but must be UTF-8',
    list_of_titles: "title: cannot read this attribute as one text",
    compound_modulus: "contact_modulus: cannot read this attribute",
}

HOSTILE_NAMES = ["'; system('touch owned'); '", "`touch owned`", 'a"b', "a\nb",
                 "system(\"touch owned\")", "<script>alert(1)</script>",
                 "@x", "a|b", "a%b", "\u00fc", "a" * 101]


def refused(write, expected, root, name):
    folder = root / name
    folder.mkdir()
    write_least(folder / "theirs.h5")
    with h5py.File(folder / "theirs.h5", "a") as file:
        write(file, folder)
    try:
        done = asperity(["report", "theirs.h5", "--out", "out"], folder)
    except subprocess.TimeoutExpired:
        return f"{name}: hangs"
    if done.returncode != 2:
        return f"{name}: exit code {done.returncode}: {done.stdout[:300]}"
    if expected not in done.stdout:
        return f"{name}: {done.stdout[:300]}\n  instead of {expected}"
    if (folder / "out").exists() or (folder / "owned").exists():
        return f"{name}: left {os.listdir(folder)}"
    return ""


def check_names(root):
    """Each hostile name as that of a method; one as that of a table and of a column."""
    def as_method(name):
        return lambda file, _: file.move("methods/bem.mine", "methods/" + name)
    places = [as_method(name) for name in HOSTILE_NAMES]
    places += [lambda file, _: file.create_group("tables/" + HOSTILE_NAMES[0]),
               lambda file, _: file.create_dataset("tables/t/" + HOSTILE_NAMES[0], data=[1.0])]
    return [refused(write, "must have 1 to 100 characters", root, f"name-{index}")
            for index, write in enumerate(places)]


def check_hostile_texts(root):
    """Any text is shown letter by letter."""
    folder = root / "texts"
    folder.mkdir()
    evil = "'; system('touch owned'); `touch owned` \"<script>x</script>&amp;"
    write_least(folder / "theirs.h5")
    with h5py.File(folder / "theirs.h5", "a") as file:
        for name in ["name", "title", "status", "case_hash"]:
            file.attrs[name] = evil
        method = file["methods/bem.mine"]
        method.attrs["kind"] = method.attrs["description"] = evil
        method["0/curve"]["status"] = [0, 0, 1]
        method["0/curve"]["note"] = ["", "", evil]
        file.create_group("provenance").attrs[evil] = evil
        heights = numpy.random.default_rng(1).normal(size=(16, 16)) * 1e-9
        surface = file.create_group("surfaces/0")
        surface["heights"] = heights
        surface.attrs["length_x"] = surface.attrs["length_y"] = 1e-6
        q = 2 * numpy.pi * numpy.fft.fftfreq(16, 1e-6 / 16)
        power = numpy.abs(numpy.fft.fft2(heights) / heights.size) ** 2
        surface.attrs["rms_slope"] = (
            (q[None, :] ** 2 + q[:, None] ** 2) * power).sum() ** 0.5
        fields = method.create_group("0/fields/2")
        fields["pressure"] = numpy.maximum(heights, 0.0) * 1e15
        fields["gap"] = numpy.maximum(-heights, 0.0)
        file["methods/A_B.c d"] = method
    done = asperity(["report", "theirs.h5", "theirs.h5", "--out", "out"],
                    folder)
    assert done.returncode == 0, done.stdout
    assert not list(folder.rglob("owned")), "a command was run"
    assert "<script>x" not in page_of(folder / "out")
    figures = list((folder / "out/figures").rglob("*.svg"))
    assert len(figures) > 5, done.stdout
    for figure in figures:
        ElementTree.parse(figure)
        assert not set(figure.stem) - set("abcdefghijklmnopqrstuvwxyz0123456789-")


def main():
    root = pathlib.Path(sys.argv[2])
    shutil.rmtree(root, ignore_errors=True)
    root.mkdir(parents=True)
    check_least(root)
    check_hostile_texts(root)
    failures = [refused(write, expected, root, write.__name__)
                for write, expected in HOSTILE.items()]
    failures += check_names(root)
    largest = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    if largest > 500:
        failures.append(f"{largest:.0f} MiB of memory")
    for failure in filter(None, failures):
        print(failure)
    sys.exit(any(failures))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv[1])
    main()
