"""Half-spaces and condensed blocks whose rows the ranks of mpirun share: the rows, fields and tables
of one process, also when a run is resumed by another number of ranks, and for
steps that the cache of one process has kept.

Arguments: asperity, mpirun, an empty folder, same_maps. Tolerance: none, equal bits.
"""
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
import zipfile
from pathlib import Path

from rough_case import rough_case

CASE = rough_case("shared", points=512, realizations=1, steps=4, methods="""[theory]
gamma = 0.42
[halfspace]
contact = "hard"
[halfspace.thin]
contact = "penalty"
penalty = "100 E*/h"
thickness = "0.5 length"
top = "sliding"
[halfspace.island]
boundaries = "free"
[fem.q1]
element = "Q1"
[fem]
element = "Q2"
""")
SHARED = ["fem", "fem.q1", "halfspace", "halfspace.island", "halfspace.thin"]
PATIENCE = 200.0  # [s]


class Runner:
    def __init__(self, program, mpirun, folder, same_maps):
        self.program, self.mpirun, self.folder = program, mpirun, folder
        self.same_maps = same_maps

    def start(self, *words, ranks=1, output=subprocess.PIPE, cache="cache"):
        environment = os.environ | {
            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1",
            "XDG_CACHE_HOME": str(self.folder / cache)}
        several = [self.mpirun, "-np", str(ranks), "--oversubscribe"] if ranks > 1 else []
        return subprocess.Popen([*several, self.program, *words], cwd=self.folder, text=True,
                                env=environment, stdout=output,
                                stderr=subprocess.STDOUT)

    def run(self, *words, ranks=1, code=0, cache="cache"):
        process = self.start(*words, ranks=ranks, cache=cache)
        output, _ = process.communicate(timeout=280)
        assert process.returncode == code, f"{words}: {process.returncode}, not {code}\n{output}"
        return output

    def expect_same_maps(self, one, other):
        """The heights and fields bit by bit, of which diff says nothing."""
        answer = subprocess.run([self.same_maps, one, other], cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        assert answer.returncode == 0, answer.stdout


def shared_by(output):
    """The methods whose rows are shared, with the number of ranks."""
    return re.findall(r"^(\S+), realization 0: (\d) ranks share the rows", output, re.M)


def check_bits(runner):
    ask = ["run", "shared.toml", "--no-cache"]
    assert not shared_by(runner.run(*ask, "--out", "alone"))
    for ranks in (2, 3):
        output = runner.run(*ask, "--out", f"on-{ranks}", ranks=ranks)
        assert sorted(shared_by(output)) == [(name, str(ranks)) for name in SHARED], output
        runner.run("diff", "alone", f"on-{ranks}", "--tolerance", "0")


def check_surface_by_rows(runner):
    """Without methods that need the whole surface, no rank holds it. What the
    result keeps is the same, also if the surface is rescaled."""
    scaled = ["--set", "surface.rescale=true", "--set", 'surface.amplitudes="gaussian"']
    for name, settings, all_ranks in (("plain", [], (2, 3)), ("scaled", scaled, (2,))):
        ask = ["run", "shared.toml", "--methods", ",".join(["theory", *SHARED]), "--exactly",
               "--no-cache", "--no-report", *settings]
        alone = runner.run(*ask, "--out", f"{name}-alone")
        assert "generate the rows" not in alone, alone
        for ranks in all_ranks:
            folder = f"{name}-{ranks}"
            output = runner.run(*ask, "--out", folder, ranks=ranks)
            assert f"{ranks} ranks generate the rows of the surface" in output, output
            runner.run("diff", f"{name}-alone", folder, "--tolerance", "0")
            runner.expect_same_maps(f"{name}-alone", folder)


def case_with(surface):
    """The case of the test with other lines of its table [surface]."""
    return re.sub(r"(?s)\[surface\].*?(?=\[material\])", f"[surface]\n{surface}\n", CASE)


def write_listed_x3p(path, text, points):
    """An X3P file whose main.xml contains the heights of a text matrix [m]."""
    axis = "<AxisType>I</AxisType><Increment>1e-9</Increment>"
    heights = "".join(f"<Datum>{number}</Datum>" for line in text.splitlines()
                      if not line.startswith("#") for number in line.split())
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", f"""<p><Record1><FeatureType>SUR</FeatureType><Axes>
<CX>{axis}</CX><CY>{axis}</CY><CZ><AxisType>A</AxisType><DataType>D</DataType></CZ></Axes></Record1>
<Record3><MatrixDimension><SizeX>{points}</SizeX><SizeY>{points}</SizeY><SizeZ>1</SizeZ>
</MatrixDimension><DataList>{heights}</DataList></Record3></p>""")


def check_other_surfaces(runner):
    """Ranks read the rows of a map file that permits it, also of mirror images,
    and compute those of an exact shape; of other maps rank 0 sends the rows."""
    maps = {"map.npy": 512, "large.npy": 640, "map.h5": 256, "map.txt": 512, "map.gwy": 512, "map.x3p": 512}
    for name, points in maps.items():
        runner.run("surface", "shared.toml", "--no-report", "--write", name, "--set",
                   f"surface.points={points}", "--set", 'surface.wavelength_short="16 nm"')
    # More points are missing than without max_missing are filled.
    heights = (runner.folder / "map.npy").read_bytes()
    for name, number in {"holes.npy": math.nan, "marks.npy": -9999.0}.items():
        marked = bytearray(heights)
        for point in range(512 * 512):
            if point % 512 % 12 == 11:
                struct.pack_into("<d", marked, len(marked) - 8 * (512 * 512 - point), number)
        (runner.folder / name).write_bytes(marked)
    text = (runner.folder / "map.txt").read_text()
    write_listed_x3p(runner.folder / "listed.x3p", text, points=512)
    measured = 'kind = "measured"\nlevel = "bow"\nfile = '
    scales = 'length = "1 um"\nheight_unit = "1 m"\n'
    sent = ("rank 0 builds the whole surface, because the format of the map cannot be read "
            "by rows, and sends its rows to 2")
    cases = {
        "npy": (f'"map.npy"\n{scales}edges = "periodic"', "2 ranks read the rows of the surface"),
        "cropped": ('"large.npy"\nlength = "640 nm"\nheight_unit = "1 m"\nedges = "periodic"\n'
                    'crop_length_x = "601 nm"\ncrop_length_y = "511 nm"',
                    "2 ranks read the rows of the surface"),
        "hdf5": ('"map.h5"\nedges = "mirror"', "2 ranks read the rows of the surface"),
        "spikes": ('"map.h5"\nedges = "mirror"\nremove_spikes = 3\nalign_lines = "median"',
                   "2 ranks read the rows of the surface"),
        "window": (f'"holes.npy"\n{scales}edges = "window"\nremove_spikes = 3\nmax_missing = 0.2\n'
                   "press_windowed_map = true",
                   "2 ranks read the rows of the surface"),
        "x3p": ('"map.x3p"\nedges = "periodic"', sent),
        "sent": ('"listed.x3p"\nedges = "periodic"', sent),
        "gwy": ('"map.gwy"\nedges = "periodic"', sent),
        "text": ('"map.txt"\nedges = "periodic"', sent),
        "marks": (f'"marks.npy"\n{scales}edges = "periodic"\nmissing_value = -9999\nmax_missing = 0.2',
                  "2 ranks read the rows of the surface")}
    cases = {name: (measured + text, line) for name, (text, line) in cases.items()}
    # The map itself is pressed once, and its continuation by no method.
    cases["island"] = tuple(text.replace("periodic", "mirror") for text in cases["npy"])
    cases["island-sent"] = cases["sent"]
    cases["wave"] = ('kind = "wave-2d"\nlength = "1 um"\npoints = 512\namplitude = "1 nm"\n'
                     'wavelength = "0.5 um"', "2 ranks generate the rows of the surface")
    for name, (surface, line) in cases.items():
        (runner.folder / f"{name}.toml").write_text(case_with(surface))
        methods = "halfspace.island" if "island" in name else "halfspace"
        ask = ["run", f"{name}.toml", "--methods", methods, "--exactly",
               "--no-cache", "--no-report", "--set", 'load.nominal_pressure=["0.001 E*"]']
        runner.run(*ask, "--out", f"{name}-alone")
        output = runner.run(*ask, "--out", f"{name}-2", ranks=2)
        assert line in output, output
        assert len(shared_by(output)) == 1, output
        runner.run("diff", f"{name}-alone", f"{name}-2", "--tolerance", "0")
        runner.expect_same_maps(f"{name}-alone", f"{name}-2")


def stresses(folder):
    """The data of the figures of the stress inside, by the names of their files."""
    found = {path.name: path.read_bytes() for path in (folder / "figures").glob("stress-*.csv")}
    assert len(found) >= 2, found.keys()
    return found


def check_stress_inside(runner):
    """The ranks compute the stress inside by rows: the numbers of one process."""
    free = '[halfspace.island]\nboundaries = "free"\n'
    (runner.folder / "stress.toml").write_text(CASE.replace(free, ""))
    ask = ["run", "stress.toml", "--methods", "halfspace.thin", "--exactly", "--no-cache",
           "--set", "report.stress_inside=true", "--set", 'report.fields="all"', "--set",
           'load.nominal_pressure=["0.003 E*", "0.01 E*"]']
    runner.run(*ask, "--out", "stress-alone")
    alone = stresses(runner.folder / "stress-alone")
    output = runner.run(*ask, "--out", "stress-2", ranks=2)
    assert "not computed" not in output, output
    assert stresses(runner.folder / "stress-2") == alone


def check_studies(runner):
    """Flow, spots, conductance and slip are those of one process, with periodic and with free
    borders; a method with adhesion says that rank 0 solves it alone."""
    studies = ["flow={ viscosity = 1e-3, pressure_drop = 1e5 }", "spots={}",
               "conductance={ thermal_conductivity = 50.0, counter_thermal_conductivity = 16.0, "
               "gap_conductivity = 0.026, smallest_gap = 1e-9 }", "friction.coefficient=0.3",
               'load.nominal_pressure=["0.002 E*", "0.003 E*"]']
    others = ["winkler.stiffness=1 E*/h", "magnification={ nominal_pressure = 1e6, from = 1.0, "
              "to = 8.0, points = 4 }"]
    adhesive = ['halfspace.sticky.contact="exponential"', "halfspace.sticky.work_of_adhesion=1e-4"]
    ask = ["run", "shared.toml", "--methods", "theory,halfspace,halfspace.island,halfspace.sticky,winkler",
           "--exactly", "--no-cache"]
    for setting in studies + others + adhesive:
        ask += ["--set", setting]
    runner.run(*ask, "--out", "studies-alone")
    output = runner.run(*ask, "--out", "studies-2", ranks=2)
    assert "halfspace.sticky, realization 0: rank 0 solves it alone, because the solver of " \
        "adhesion" in output, output
    runner.run("diff", "studies-alone", "studies-2", "--tolerance", "0")
    for name in ("curves.csv", "figures/partial-slip.csv"):
        alone, shared = ((runner.folder / folder / name).read_bytes()
                         for folder in ("studies-alone", "studies-2"))
        assert alone == shared, name


def check_plan(runner):
    output = runner.run("run", "shared.toml", "--dry-run", ranks=2)
    for name in SHARED:
        assert output.count(f"{name}: 2 ranks share the rows") == 1, output
    assert output.count("share the rows") == len(SHARED), output
    assert "ranks" not in runner.run("run", "shared.toml", "--dry-run")


def check_small(runner):
    """A small grid is not shared."""
    output = runner.run("run", "shared.toml", "--no-cache", "--no-report", "--methods",
                        "halfspace", "--exactly", "--set", "surface.points=256", "--set",
                        'load.nominal_pressure=["0.01 E*"]', "--out", "small", ranks=2)
    assert not shared_by(output), output


def check_any_grid(runner):
    """Grids whose numbers of points are no powers of two are shared."""
    ask = ["run", "shared.toml", "--no-cache", "--no-report", "--methods", "fem,fem.q1,halfspace",
           "--exactly", "--set", "surface.points=518", "--set",
           'load.nominal_pressure=["0.01 E*"]']
    runner.run(*ask, "--out", "518-alone")
    output = runner.run(*ask, "--out", "518-3", ranks=3)
    assert len(shared_by(output)) == 3, output
    runner.run("diff", "518-alone", "518-3", "--tolerance", "0")
    runner.expect_same_maps("518-alone", "518-3")


def check_too_many_ranks(runner):
    """A map of few rows cannot be divided: plan and run say why."""
    row = " ".join(str(x % 7) for x in range(16384))
    (runner.folder / "wide.txt").write_text(f"{row}\n" * 16)
    (runner.folder / "wide.toml").write_text(case_with(
        'kind = "measured"\nlevel = "plane"\nfile = "wide.txt"\nlength = "1024 um"\n'
        'length_y = "1 um"\nheight_unit = "1 nm"\nedges = "periodic"'))
    ask = ["run", "wide.toml", "--methods", "halfspace", "--exactly", "--no-cache", "--no-report",
           "--set", 'load.nominal_pressure=["0.01 E*"]']
    sentence = ("rank 0 solves it alone, because a grid of 16384 by 16 points can be divided among "
                "at most 2 ranks")
    assert f"halfspace: {sentence}" in runner.run(*ask, "--dry-run", ranks=3)
    output = runner.run(*ask, "--out", "wide", ranks=3)
    assert f"halfspace, realization 0: {sentence}" in output, output
    assert "alone" not in runner.run(*ask, "--dry-run", ranks=2)


def check_cache(runner):
    """Steps that one process kept are taken over, and ranks continue from its
    state; one process continues from theirs."""
    ask = ["run", "shared.toml", "--methods", "halfspace", "--exactly", "--no-report"]
    short = ["--set", 'load.nominal_pressure=["0.001 E*", "0.003 E*"]']
    longer = ["--set", 'load.nominal_pressure=["0.001 E*", "0.003 E*", "0.01 E*"]']
    longest = ["--set", 'load.nominal_pressure=["0.001 E*", "0.003 E*", "0.01 E*", "0.02 E*"]']
    runner.run(*ask, *longest, "--no-cache", "--out", "fresh")
    runner.run(*ask, *short, "--out", "kept")
    output = runner.run(*ask, *longer, "--out", "kept", ranks=2)
    assert "3 steps: 1 computed, 2 from the cache" in output, output
    output = runner.run(*ask, *longest, "--out", "kept")
    assert "4 steps: 1 computed, 3 from the cache" in output, output
    assert "again" not in output, output
    runner.run("diff", "fresh", "kept", "--tolerance", "0")


def entries(folder, kind):
    """The entries of a cache of this kind by their names."""
    return {path.name: path.read_bytes() for path in folder.rglob(f"*.{kind}")}


def check_cache_by_rows(runner):
    """The entries of ranks have the bytes of one process, apart from CPU times and
    the hash of all, and their maps are read again, also by rows."""
    ask = ["run", "shared.toml", "--methods", "halfspace", "--exactly", "--no-report", "--set",
           "surface.points=1024", "--set", "report.fields=1"]
    one = ["--set", 'load.nominal_pressure=["0.003 E*"]']
    runner.run(*ask, *one, "--out", "by-one", cache="one")
    runner.run(*ask, *one, "--out", "by-two", cache="two", ranks=2)
    states = entries(runner.folder / "one", "state")
    assert len(states) == 1 and entries(runner.folder / "two", "state") == states
    steps = [entries(runner.folder / cache, "step") for cache in ("one", "two")]
    assert len(steps[0]) == 1 and steps[0].keys() == steps[1].keys()
    maps = 2 * 4 * 1024 * 1024  # bytes of pressure and gap
    for name, step in steps[0].items():
        other = steps[1][name]
        assert len(step) == len(other) > maps
        differing = sum(a != b for a, b in zip(step, other))
        assert differing <= 64 + 4 * 8, differing  # the hash and four CPU times
    output = runner.run(*ask, *one, "--out", "again", cache="two")
    assert "1 steps: 0 computed, 1 from the cache" in output, output
    runner.run("diff", "by-one", "again", "--tolerance", "0")
    runner.expect_same_maps("by-one", "again")


def check_kill(runner):
    """A killed rank ends all; --resume on other ranks computes what is missing."""
    ask = ["run", "shared.toml", "--no-cache", "--methods", "halfspace", "--exactly",
           "--set", "surface.points=1024"]
    runner.run(*ask, "--out", "whole-1024")
    log = runner.folder / "killed.log"
    with open(log, "w", encoding="utf-8") as file:
        process = runner.start(*ask, "--out", "killed", ranks=3, output=file)
    end = time.monotonic() + PATIENCE
    while "] 1/4" not in log.read_text(encoding="utf-8"):
        assert time.monotonic() < end and process.poll() is None, "no step"
        time.sleep(0.01)
    ranks = subprocess.run(["pgrep", "-P", str(process.pid)], stdout=subprocess.PIPE, text=True,
                           check=True).stdout.split()
    os.kill(int(ranks[-1]), signal.SIGKILL)
    start = time.monotonic()
    code = process.wait(timeout=280)
    assert code != 0 and time.monotonic() - start < 30.0, log.read_text(encoding="utf-8")
    output = runner.run(*ask, "--out", "killed", "--resume", ranks=2)
    assert shared_by(output) == [("halfspace", "2")], output
    assert 0 < int(re.search(r"(\d) steps: ", output)[1]) < 4, output
    runner.run("diff", "killed", "whole-1024", "--tolerance", "0")


def main(program, mpirun, folder, same_maps):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "shared.toml").write_text(CASE)
    runner = Runner(program, mpirun, folder, same_maps)
    for check in (check_plan, check_bits, check_surface_by_rows,
                  check_other_surfaces, check_stress_inside, check_studies, check_small,
                  check_any_grid, check_too_many_ranks, check_cache,
                  check_cache_by_rows, check_kill):
        check(runner)


if __name__ == "__main__":
    main(*sys.argv[1:])
