"""Copies an answer with two mistakes: pressures in MPa, rows and columns exchanged.

Usage: wrong_answer.py ANSWER COPY
"""
import pathlib
import shutil
import sys

import numpy

answer, copy = map(pathlib.Path, sys.argv[1:])
shutil.copytree(answer, copy)
for field in copy.glob("*.npy"):
    numpy.save(field, 1e-6 * numpy.load(field).T)
