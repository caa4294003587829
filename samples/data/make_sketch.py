#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws snail.tilt: a snail under a flower, 25 strokes of a flat brush and a round one, as a hand in VR would draw them.

    make_sketch.py snail.tilt

The same bytes every time. The sketch's own space: decimetres, left-handed, y up, z away from the viewer.
"""
import io
import json
import math
import struct
import sys
import zipfile

FLAT, ROUND = 0, 1
BRUSHES = ["280c0a7a-aad8-416c-a7d2-df63d129ca70", "4391385a-cf83-4396-9e33-31e4e4930b27"]
STEP_MS = 11  # 90 samples a second

SHELL, SHELL_LIGHT, BODY, INK = (0.55, 0.27, 0.16), (0.93, 0.66, 0.36), (0.80, 0.62, 0.38), (0.12, 0.10, 0.12)
PETAL, CORE, STEM = (0.86, 0.27, 0.42), (0.98, 0.78, 0.20), (0.25, 0.45, 0.22)
GRASS = [(0.24, 0.48, 0.20), (0.36, 0.58, 0.22), (0.18, 0.40, 0.26), (0.48, 0.64, 0.26)]


def tremble(number, t):
    """What keeps a hand from a perfect line, in decimetres."""
    return [0.006 * (math.sin(23 * t + 1.7 * number + k) + 0.6 * math.sin(41 * t + 2.9 * number + 2 * k))
            for k in range(3)]


class Sketch:
    def __init__(self):
        self.strokes, self.count, self.time = b"", 0, 0

    def draw(self, brush, size, color, points, place, taper=0.12):
        """A stroke along place(t), t from 0 to 1. Pressure rises and falls over `taper` of it."""
        self.strokes += struct.pack("<i4ffII", brush, *color, 1.0, size, 1, 3) + struct.pack("<Ii", 0, points)
        for i in range(points):
            t = i / (points - 1)
            x, y, z = (p + d for p, d in zip(place(t), tremble(self.count, t)))
            pressure = min(1.0, 0.15 + min(t, 1 - t) / taper)
            tilt = 0.1 * math.sin(5 * t + self.count)  # of the controller, about the stroke's direction
            self.strokes += struct.pack("<3f4ffI", x, y, z, math.sin(tilt), 0.0, 0.0, math.cos(tilt), pressure,
                                        self.time)
            self.time += STEP_MS
        self.count += 1
        self.time += 400

    def write(self, path):
        sketch = struct.pack("<IiiIi", 0xC576A5CD, 5, 0, 0, self.count) + self.strokes
        data = io.BytesIO()
        with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as out:
            for name, content in (("data.sketch", sketch), ("metadata.json", json.dumps({"BrushIndex": BRUSHES}))):
                out.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sHHII", b"tilT", 16, 1, 0, 0) + data.getvalue())


def spiral(turns, inner, outer, x, y, bulge):
    def place(t):
        angle = 2 * math.pi * turns * t - 0.6
        radius = inner * (outer / inner) ** t
        return x + radius * math.cos(angle), y + radius * math.sin(angle), -bulge * (1 - t)
    return place


def bent(start, end, bend, depth=0.0):
    """From start to end, `bend` to the left of the straight way in its middle."""
    dx, dy = end[0] - start[0], end[1] - start[1]

    def place(t):
        off = 4 * t * (1 - t)
        return (start[0] + dx * t - dy * bend * off, start[1] + dy * t + dx * bend * off,
                start[2] + (end[2] - start[2]) * t + depth * off)
    return place


def petal(x, y, z, angle, length, width):
    def place(t):
        along, across = length * math.sin(math.pi * t), width * math.sin(2 * math.pi * t)
        return (x + along * math.cos(angle) - across * math.sin(angle),
                y + along * math.sin(angle) + across * math.cos(angle), z - 0.35 * along)
    return place


def foot(t):
    return -2.3 + 4.5 * t, 0.16 + 4.6 * max(0.0, t - 0.72) ** 1.2, 0.0


def main():
    sketch = Sketch()
    for depth in (-0.55, 0.0, 0.55):
        sketch.draw(ROUND, 0.16, SHELL if depth else SHELL_LIGHT, 150,
                    lambda t, depth=depth: [a + b for a, b in zip(
                        spiral(2.6, 0.10, 1.25, -0.35, 1.45, 0.55 - 0.4 * abs(depth))(t), (0, 0, depth * t))])
    for depth in (-0.28, 0.28):
        sketch.draw(ROUND, 0.26, BODY, 70, lambda t, depth=depth: (foot(t)[0], foot(t)[1], depth * math.sin(3 * t)),
                    taper=0.04)
    for z in (-0.22, 0.26):
        sketch.draw(ROUND, 0.09, BODY, 30, bent((2.15, 1.05, 0.5 * z), (2.6, 1.95, 1.8 * z), 0.12), taper=0.04)
        sketch.draw(ROUND, 0.10, INK, 24, lambda t, z=z: (2.6 + 0.08 * math.cos(12 * t), 2.0 + 0.08 * math.sin(12 * t),
                                                          1.8 * z))
    sketch.draw(ROUND, 0.11, STEM, 60, bent((-2.6, 0.0, 0.7), (-1.9, 3.7, 0.3), 0.10, 0.2))
    for k in range(6):
        sketch.draw(FLAT, 0.30, PETAL, 40, petal(-1.9, 3.7, 0.3, 0.3 + k * math.pi / 3, 0.85, 0.26))
    sketch.draw(FLAT, 0.26, CORE, 40, spiral(2.2, 0.03, 0.2, -1.9, 3.7, 0.0))
    for k in range(8):
        x = -3.2 + 0.85 * k + 0.2 * math.sin(9 * k)
        sketch.draw(FLAT, 0.34, GRASS[k % len(GRASS)], 36,
                    bent((x, 0.0, 0.75 + 0.3 * math.sin(4 * k)), (x + 0.45 * math.sin(5 * k), 1.2 + 0.5 * math.cos(3 * k), 1.0),
                         0.16 * math.cos(7 * k)), taper=0.4)
    sketch.write(sys.argv[1])


main()
