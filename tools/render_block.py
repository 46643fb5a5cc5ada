#!/usr/bin/env python3
"""A picture of a solved block: von Mises on its contact surface and on a cut.

    tools/render_block.py STEP.pvtu PICTURE.png [--cut 0.5] [--warp 1] [--top 2e8]

Takes the files that the full block writes for ParaView, leaves out the cells in
front of the cut (a share of the block's width) and draws what is then seen from
the front, the right and above, the contact surface upwards. Displacements are
drawn `warp` times; colours end at `top` [Pa], without it at the largest value.
Needs gnuplot with pngcairo.
"""
import argparse
import base64
import re
import struct
import subprocess
import sys
import zlib
from pathlib import Path

CODES = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt32": "I",
         "UInt8": "B", "Int8": "b", "Int64": "q"}
ARRAY = re.compile(r'<DataArray\s([^>]*)>(.*?)</DataArray>', re.S)
# Faces of a cell by its VTK type: hexahedron, tetrahedron of 4 and 10 nodes.
HEXAHEDRON = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
TETRAHEDRON = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
FACES = {12: HEXAHEDRON, 10: TETRAHEDRON, 24: TETRAHEDRON}
SMOOTHING = 3  # pieces of a quadrilateral along each edge


def numbers(kind, text):
    """One zlib block in base64 behind its header of four 32-bit numbers."""
    text = text.strip()
    blocks, size, _, packed = struct.unpack("<4I", base64.b64decode(text[:24])[:16])
    if blocks == 0:
        return ()
    if blocks != 1:
        raise SystemExit("render_block: more than one zlib block in an array")
    raw = zlib.decompress(base64.b64decode(text[24:])[:packed])
    return struct.unpack(f"<{size // struct.calcsize(CODES[kind])}{CODES[kind]}", raw)


def read_part(path):
    """Arrays of a .vtu by name; the coordinates are called Points."""
    arrays = {}
    for head, text in ARRAY.findall(path.read_text()):
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', head))
        if attributes["format"] == "binary":
            arrays[attributes.get("Name", "Points")] = numbers(attributes["type"], text)
    return arrays


def cells_of(arrays):
    """(faces, nodes) of each cell, a node as ((x, y, z), (u_x, u_y, u_z), von Mises)."""
    places, moved, stress = arrays["Points"], arrays["displacement"], arrays["von_mises"]
    nodes = [(places[3 * i:3 * i + 3], moved[3 * i:3 * i + 3], stress[i])
             for i in range(len(stress))]
    start = 0
    for end, kind in zip(arrays["offsets"], arrays["types"]):
        if kind not in FACES:
            raise SystemExit(f"render_block: cells of VTK type {kind} are not known")
        yield FACES[kind], [nodes[i] for i in arrays["connectivity"][start:end]]
        start = end


def skin(cells, cut):
    """Faces of the cells behind the cut that no two of them share."""
    lengths = [max(node[0][i] for _, nodes in cells for node in nodes) for i in range(3)]
    grain = 1e-6 * min(lengths)
    faces = {}
    for shape, nodes in cells:
        if sum(node[0][1] for node in nodes) / len(nodes) < cut * lengths[1]:
            continue
        for face in shape:
            corners = [nodes[i] for i in face]
            key = frozenset(tuple(round(x / grain) for x in corner[0]) for corner in corners)
            if key in faces:
                del faces[key]
            else:
                faces[key] = corners
    return [face for face in faces.values() if is_seen(face, lengths, cut, grain)]


def is_seen(face, lengths, cut, grain):
    """On the contact surface, on the right side, or in front."""
    def all_at(axis, place):
        return all(abs(corner[0][axis] - place) < 10 * grain for corner in face)
    if all_at(2, 0.0) or all_at(0, lengths[0]):
        return True
    return not (all_at(2, lengths[2]) or all_at(0, 0.0) or all_at(1, lengths[1]))


def pieces(face, warp):
    """Small polygons of (x, y, height) in micrometres and MPa, bilinear in the face."""
    corners = [tuple((x + warp * u) * 1e6 for x, u in zip(place, moved)) + (stress * 1e-6,)
               for place, moved, stress in face]
    if len(corners) == 3:
        yield corners
        return

    def at(s, t):
        shares = ((1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t)
        return tuple(sum(w * c[i] for w, c in zip(shares, corners)) for i in range(4))
    steps = [i / SMOOTHING for i in range(SMOOTHING + 1)]
    for s, s_next in zip(steps, steps[1:]):
        for t, t_next in zip(steps, steps[1:]):
            yield [at(s, t), at(s_next, t), at(s_next, t_next), at(s, t_next)]


def script(polygons, picture, top):
    """What gnuplot is told; z points up out of the contact surface."""
    lines = ["$skin << EOD"]
    for corners in polygons:  # each a surface of two rows of two points
        rows = [f"{x:.5g} {y:.5g} {-z:.5g} {value:.4g}" for x, y, z, value in corners]
        lines += [rows[0], rows[1], "", rows[-1], rows[2], "", ""]
    lines += ["EOD",
              "set terminal pngcairo size 1000,640 font 'sans,13'",
              f"set output '{picture}'",
              "set view 58, 24, 1.7", "set view equal xyz", "set xyplane relative 0",
              "unset border", "unset xtics", "unset ytics", "unset ztics",
              "set pm3d depthorder corners2color mean",
              "set palette defined (0 '#20204c', 1 '#2f5d9b', 2 '#3fa7a0', 3 '#b6d36a',"
              " 4 '#f6c244', 5 '#d9472b', 6 '#7a0f1f')",
              f"set cbrange [0:{top * 1e-6:g}]" if top else "set cbrange [0:*]",
              "set cblabel 'von Mises stress [MPa]'",
              "set colorbox user origin 0.9,0.2 size 0.02,0.6",
              "set lmargin at screen 0.02", "set rmargin at screen 0.88",
              "splot $skin using 1:2:3:4 with pm3d notitle"]
    return "\n".join(lines) + "\n"


def main(arguments):
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("step", type=Path, help=".pvtu, or one .vtu")
    words.add_argument("picture", type=Path)
    words.add_argument("--cut", type=float, default=0.5)
    words.add_argument("--warp", type=float, default=1.0)
    words.add_argument("--top", type=float)
    chosen = words.parse_args(arguments)
    parts = [chosen.step]
    if chosen.step.suffix == ".pvtu":
        parts = [chosen.step.parent / name
                 for name in re.findall(r'Source="([^"]*)"', chosen.step.read_text())]
    cells = [cell for part in parts for cell in cells_of(read_part(part))]
    polygons = [piece for face in skin(cells, chosen.cut) for piece in pieces(face, chosen.warp)]
    subprocess.run(["gnuplot"], input=script(polygons, chosen.picture, chosen.top), text=True,
                   check=True)


if __name__ == "__main__":
    main(sys.argv[1:])
