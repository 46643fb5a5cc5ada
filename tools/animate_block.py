#!/usr/bin/env python3
"""An animation of a full block along its loading path: mesh, contact, stress.

    tools/animate_block.py RESULT/fem-0/block.pvd PICTURE.gif [--top 40]
    tools/animate_block.py RESULT/fem-0/block.pvd PICTURE.png --step 5

Takes the files that the full block writes for ParaView: of each step, the block
and its contact surface. Draws this surface with the cells coloured by the
number of their halvings and by contact, and a section along x through the middle
of the block with the von Mises stress, up to `top` [MPa]. With --step, one step
becomes a PNG. The files must be those of a block of hexahedra that are boxes.
Needs gnuplot with the terminals gif and pngcairo.
"""
import argparse
import math
import re
import subprocess
import sys
from pathlib import Path

from render_block import read_part

LEVELS = ("#eef2f7", "#d5e0ee", "#b4c9e2", "#8caed3", "#628fc0", "#3f70a8")
CONTACT = "#c8322b"
STRESS = ((0, "#ffffff"), (0.15, "#dce9f5"), (0.4, "#86b6d9"), (0.65, "#f6c244"),
          (0.85, "#d9472b"), (1, "#7a0f1f"))


def steps_of(series):
    """The file of each step of a .pvd."""
    found = re.findall(r'timestep="[^"]*"[^>]*file="([^"]*)"', series.read_text())
    if not found:
        raise SystemExit(f"animate_block: {series} names no steps")
    return [series.parent / name for name in found]


def pressure_of(step):
    """The nominal pressure [Pa], which is the time of a .vtu."""
    part = re.search(r'Source="([^"]*)"', step.read_text())[1]
    time = re.search(r'Name="TIME"[^>]*>\s*([^<\s]+)', (step.parent / part).read_text())
    return float(time[1]) if time else math.nan


def parts_of(step):
    """The arrays of all .vtu files of a .pvtu."""
    for name in re.findall(r'Source="([^"]*)"', step.read_text()):
        yield read_part(step.parent / name)


def boxes(arrays, corners):
    """(nodes, number of its first element) of each piece of a cell, a box."""
    places, ends, start = arrays["Points"], arrays["offsets"], 0
    for piece, end in enumerate(ends):
        nodes = arrays["connectivity"][start:end]
        if len(nodes) != corners:
            raise SystemExit("animate_block: the cells are no boxes")
        yield piece, nodes, [places[3 * node:3 * node + 3] for node in nodes]
        start = end


def whole_cell(low, high, level, edge):
    """The cell that contains a piece, from the edge of a cell of that level."""
    width = edge / 2 ** level
    return tuple((math.floor(0.5 * (a + b) / width) * width,
                  (math.floor(0.5 * (a + b) / width) + 1) * width) for a, b in zip(low, high))


def face_of(step, edge):
    """Polygons (outline, colour) of the contact surface, and the rectangles of its cells."""
    polygons, cells = [], set()
    for arrays in parts_of(step):
        contact, level = arrays["contact"], arrays["level"]
        for _, nodes, places in boxes(arrays, 4):
            low = [min(place[i] for place in places) for i in range(2)]
            high = [max(place[i] for place in places) for i in range(2)]
            halvings = round(level[nodes[0]])
            known = [contact[node] for node in nodes if not math.isnan(contact[node])]
            touches = bool(known) and 2 * sum(known) >= len(known) and sum(known) > 0
            colour = CONTACT if touches else LEVELS[min(halvings, len(LEVELS) - 1)]
            polygons.append((low, high, colour))
            cells.add(whole_cell(low, high, halvings, edge))
    return polygons, cells


def section_of(step, place, edge):
    """Rectangles (low, high, von Mises [MPa]) of the section at y = place, and its cells."""
    polygons, cells = [], set()
    for arrays in parts_of(step):
        stress, level = arrays["von_mises"], arrays["level"]
        for piece, nodes, places in boxes(arrays, 8):
            ys = [p[1] for p in places]
            if not min(ys) <= place < max(ys):
                continue
            low = [min(p[i] for p in places) for i in (0, 2)]
            high = [max(p[i] for p in places) for i in (0, 2)]
            mean = sum(stress[node] for node in nodes) / len(nodes) * 1e-6
            polygons.append((low, high, mean))
            halvings = level[piece] if len(level) == len(arrays["offsets"]) else level[nodes[0]]
            cells.add(whole_cell(low, high, round(halvings), edge))
    return polygons, cells


def colour_at(share):
    """The colour of STRESS at a share of the scale."""
    share = min(max(share, 0.0), 1.0)
    for (a, one), (b, other) in zip(STRESS, STRESS[1:]):
        if share <= b:
            t = (share - a) / (b - a)
            mixed = [round((1 - t) * int(one[i:i + 2], 16) + t * int(other[i:i + 2], 16))
                     for i in (1, 3, 5)]
            return "#%02x%02x%02x" % tuple(mixed)
    return STRESS[-1][1]


def rectangle(low, high, style, unit, flip=False):
    a, b = (-high[1], -low[1]) if flip else (low[1], high[1])
    return (f"set object rectangle from {low[0] * unit:.5g},{a * unit:.5g} "
            f"to {high[0] * unit:.5g},{b * unit:.5g} {style}")


def panel(polygons, cells, unit, flip):
    lines = ["unset object"]
    lines += [rectangle(low, high, f"fillcolor rgb '{colour}' fillstyle solid noborder behind",
                        unit, flip) for low, high, colour in polygons]
    lines += [rectangle((x[0], y[0]), (x[1], y[1]),
                        "fillstyle empty border rgb '#3a4450' linewidth 0.5 front", unit, flip)
              for x, y in cells]
    return lines


def frame(number, pressure, face, section, size, chosen):
    """What gnuplot is told for one step."""
    unit = 1.0 / size[0]
    depth = size[1] * unit
    polygons, cells = face
    stressed, cut = section
    coloured = [(low, high, colour_at(mean / chosen.top)) for low, high, mean in stressed]
    contact = sum((high[0] - low[0]) * (high[1] - low[1]) for low, high, colour in polygons
                  if colour == CONTACT) * unit * unit
    lines = ["set multiplot", "unset key", "unset colorbox", "unset border", "unset tics",
             "set size 0.48,0.82", "set origin 0.01,0.02",
             "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0",
             "set label 1 'contact surface: cells by their halvings, contact in red' "
             "at screen 0.01,0.875 left",
             f"set label 2 'step {number}: p = {pressure * 1e-6:.3g} MPa, "
             f"{100 * contact:.1f} % in contact, {len(cells)} cells at the surface' "
             "at screen 0.01,0.95 left",
             f"set label 3 'section: von Mises stress, white 0 to dark red "
             f"{chosen.top:g} MPa' at screen 0.51,0.875 left",
             "set size ratio -1"]
    lines += panel(polygons, cells, unit, False)
    lines += ["plot [0:1] [0:1] NaN notitle", "unset label",
              "set origin 0.51,0.02", "set size 0.48,0.82", "set size ratio -1"]
    lines += panel(coloured, cut, unit, True)
    lines += [f"plot [0:1] [{-max(1.0, depth)}:0] NaN notitle", "unset multiplot"]
    return lines


def main(arguments):
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("series", type=Path, help="the .pvd of the block")
    words.add_argument("picture", type=Path, help=".gif, or .png with --step")
    words.add_argument("--top", type=float, default=40.0, help="largest stress drawn [MPa]")
    words.add_argument("--step", type=int, help="this step only, from 0")
    words.add_argument("--pause", type=float, default=0.9, help="between two steps [s]")
    chosen = words.parse_args(arguments)
    surface = chosen.series.with_name(chosen.series.stem + "_surface.pvd")
    steps = list(zip(steps_of(chosen.series), steps_of(surface)))
    length = max(max(arrays["Points"][0::3]) for arrays in parts_of(steps[0][1]))
    depth = max(max(arrays["Points"][2::3]) for arrays in parts_of(steps[0][0]))
    edge = length / chosen_coarsest(steps[0][1], length)
    terminal = "pngcairo size 980,560 font 'sans,11'"
    if chosen.step is None:
        terminal = f"gif animate delay {round(100 * chosen.pause)} loop 0 size 980,560"
    else:
        steps = steps[chosen.step:chosen.step + 1]
    lines = [f"set terminal {terminal}", f"set output '{chosen.picture}'"]
    for number, (block, face) in enumerate(steps, start=chosen.step or 0):
        lines += frame(number, pressure_of(block), face_of(face, edge),
                       section_of(block, 0.5 * length, edge), (length, depth), chosen)
    subprocess.run(["gnuplot"], input="\n".join(lines) + "\n", text=True, check=True)


def chosen_coarsest(face, length):
    """The number of coarsest cells along x, from the width and level of one piece."""
    for arrays in parts_of(face):
        for _, nodes, places in boxes(arrays, 4):
            width = max(p[0] for p in places) - min(p[0] for p in places)
            pieces = round(length / width / 2 ** round(arrays["level"][nodes[0]]))
            return pieces // 2 if pieces % 2 == 0 else pieces
    raise SystemExit("animate_block: the contact surface has no cells")


if __name__ == "__main__":
    main(sys.argv[1:])
