#!/usr/bin/env python3
"""The Debian package: its fields, files and checksum.

deb_test.py TOOL BUILD FOLDER: tools/package builds the package into FOLDER, which is inspected.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

FILES = ["./usr/bin/asperity", "./usr/lib/asperity/asperity_fem.so",
         "./usr/share/asperity/cases/polymer/case.toml", "./usr/share/man/man1/asperity.1",
         "./usr/share/doc/asperity/copyright", "./usr/lib/python3/dist-packages/asperity.py"]
DEPENDS = ["libdeal.ii-9.4.1", "libgmsh4.8", "libhdf5-openmpi-103", "libfftw3-double3",
           "libfftw3-mpi3", "gnuplot-nox | gnuplot"]


def run(*words, **settings):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, check=True,
                          **settings).stdout


def main(tool, build, scratch):
    folder = Path(scratch).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    run(tool, folder, env=os.environ | {"ASPERITY_BUILD": build})
    package, = folder.glob("asperity_*.deb")
    assert {path.name for path in folder.iterdir()} == {package.name, "SHA256SUMS"}
    assert run("sha256sum", "--check", "SHA256SUMS", cwd=folder) == f"{package.name}: OK\n"
    depends = run("dpkg-deb", "--field", package, "Depends")
    lost = [name for name in DEPENDS if name not in depends]
    assert not lost, (lost, depends)
    assert "asperity" not in depends, "a library of our own is no dependency"
    listed = run("dpkg-deb", "--contents", package)
    missing = [name for name in FILES if f" {name}\n" not in listed]
    assert not missing, (missing, listed)
    assert "/home/" not in listed, listed


if __name__ == "__main__":
    main(*sys.argv[1:])
