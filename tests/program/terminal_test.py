#!/usr/bin/env python3
"""On a terminal, every message of the progress fits into one line, and the text after the
progress is in a separate line.

Usage: terminal_test.py PROGRAM FOLDER"""
import fcntl
import os
import pathlib
import pty
import shutil
import struct
import subprocess
import sys
import termios

CASE = """schema = 1
title = "a rough surface"
surface = { kind = "self-affine", length = "1 um", points = 64, seed = 1, realizations = 2, rms_slope = 0.1, hurst = 0.8, wavelength_long = "1 length", wavelength_roll_off = "0.5 length", wavelength_short = "8 h" }
material = { youngs_modulus = "2 GPa", poisson_ratio = 0.3 }
load = { nominal_pressure = { from = "1e-3 E*", to = "5e-2 E*", steps = 6, spacing = "log" } }
halfspace = { contact = "hard" }
"""


def text_on_terminal(command, columns):
    """The output of the command on a terminal of this width."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen(command, stdout=slave, stderr=subprocess.STDOUT,
                               stdin=subprocess.DEVNULL)
    os.close(slave)
    written = b""
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        written += part
    os.close(master)
    assert process.wait() == 0, written.decode()
    return written.decode()


def main(program, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    case = folder / "case.toml"
    case.write_text(CASE)
    for columns in (40, 80):
        written = text_on_terminal([program, "run", case, "--no-cache", "--no-report", "--out",
                                    folder / "out"], columns)
        drawn = [part.split("\n")[0].rstrip("\r") for part in written.split("\r\x1b[K")[1:]]
        bars = [part for part in drawn if part.startswith("[")]
        assert len(bars) >= 12, written
        assert max(map(len, bars)) < columns, bars
        assert any(part.startswith("12 steps: 12 computed") for part in drawn), written


main(sys.argv[1], pathlib.Path(sys.argv[2]))
