#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Models owl.obj: an owl on its stone, 30 cm high, polygonized from blended round solids (naive surface nets), with the
flaws that exported models have: a seam of doubled vertices around the neck, a patch wound the wrong way, a triangle that is
there twice, and vertices that nothing uses. `filigree mesh repair` mends them; the surface is closed then.

    make_mesh.py owl.obj

The same bytes every time. Metres, y up, looking along +z.
"""
import math
import sys

CELL = 0.0075
LOW, COUNT = (-0.12, -0.0107, -0.12), (32, 46, 32)
NECK = 0.195


def length(*v):
    return math.sqrt(sum(x * x for x in v))


def ellipsoid(p, centre, radii):
    q = [(a - c) / r for a, c, r in zip(p, centre, radii)]
    return (length(*q) - 1.0) * min(radii)


def cone(p, a, b, ra, rb):
    """A round cone from a to b."""
    ab, ap = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, p)]
    t = min(1.0, max(0.0, sum(x * y for x, y in zip(ap, ab)) / sum(x * x for x in ab)))
    return length(*(x - t * y for x, y in zip(ap, ab))) - (ra + t * (rb - ra))


def blend(a, b, k):
    h = max(k - abs(a - b), 0.0) / k
    return min(a, b) - 0.25 * h * h * k


def solid(x, y, z):
    """Below 0 inside. One half says it all."""
    x = abs(x)
    p = (x, y, z)
    d = blend(ellipsoid(p, (0, 0.125, 0), (0.070, 0.100, 0.064)), ellipsoid(p, (0, 0.235, 0.006), (0.066, 0.052, 0.056)), 0.035)
    d = blend(d, ellipsoid((x, y - 0.35 * (z + 0.01), z), (0.067, 0.125, -0.008), (0.019, 0.078, 0.052)), 0.010)  # wings
    d = blend(d, cone(p, (0, 0.075, -0.050), (0, 0.020, -0.088), 0.028, 0.016), 0.020)  # tail
    d = blend(d, cone(p, (0.040, 0.268, 0.004), (0.064, 0.318, -0.004), 0.020, 0.004), 0.015)  # ears
    d = blend(d, ellipsoid(p, (0.029, 0.240, 0.052), (0.031, 0.032, 0.013)), 0.006)  # face
    d = max(d, -ellipsoid(p, (0.029, 0.242, 0.070), (0.021, 0.021, 0.012)))
    d = min(d, length(x - 0.029, y - 0.242, z - 0.059) - 0.0125)  # eyes
    d = blend(d, cone(p, (0, 0.236, 0.062), (0, 0.210, 0.080), 0.011, 0.003), 0.004)  # beak
    d = blend(d, ellipsoid(p, (0.030, 0.028, 0.044), (0.020, 0.016, 0.026)), 0.020)  # feet
    wave = 0.004 * math.sin(3 * math.atan2(z, x) + 1)
    return blend(d, ellipsoid(p, (0, 0.008, 0.004), (0.086 + wave, 0.017, 0.082 + wave)), 0.010)  # stone


def onto_surface(p):
    for _ in range(4):
        d, e = solid(*p), 1e-4
        g = [(solid(*(c + e * (k == i) for i, c in enumerate(p))) - solid(*(c - e * (k == i) for i, c in enumerate(p)))) / (2 * e)
             for k in range(3)]
        norm = sum(x * x for x in g)
        p = [c - 0.8 * d * x / max(norm, 0.25) for c, x in zip(p, g)]
    return p


def polygonize():
    corner = {(i, j, k): solid(*(LOW[a] + CELL * n for a, n in enumerate((i, j, k))))
              for i in range(COUNT[0] + 1) for j in range(COUNT[1] + 1) for k in range(COUNT[2] + 1)}
    vertices, index = [], {}
    for i in range(COUNT[0]):
        for j in range(COUNT[1]):
            for k in range(COUNT[2]):
                crossings = []
                for axis in range(3):
                    for b in range(2):
                        for c in range(2):
                            a = [i, j, k]
                            a[(axis + 1) % 3] += b
                            a[(axis + 2) % 3] += c
                            e = list(a)
                            e[axis] += 1
                            u, v = corner[tuple(a)], corner[tuple(e)]
                            if (u < 0) != (v < 0):
                                a[axis] += u / (u - v)
                                crossings.append(a)
                if crossings:
                    mean = [sum(x) / len(crossings) for x in zip(*crossings)]
                    index[i, j, k] = len(vertices)
                    vertices.append(onto_surface([l + CELL * m for l, m in zip(LOW, mean)]))
    triangles = []
    for (i, j, k), value in corner.items():
        for axis in range(3):
            e = [i, j, k]
            e[axis] += 1
            if tuple(e) not in corner or (value < 0) == (corner[tuple(e)] < 0):
                continue
            b, c = (axis + 1) % 3, (axis + 2) % 3
            quad = []
            for db, dc in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
                cell = [i, j, k]
                cell[b] += db
                cell[c] += dc
                quad.append(index[tuple(cell)])
            if value >= 0:
                quad.reverse()
            p, q, r, s = quad
            if math.dist(vertices[p], vertices[r]) <= math.dist(vertices[q], vertices[s]):
                triangles += [(p, q, r), (p, r, s)]
            else:
                triangles += [(p, q, s), (q, r, s)]
    return vertices, triangles


def flaw(vertices, triangles):
    """As two programs and a hasty hand leave a model."""
    def middle(t, k):
        return sum(vertices[v][k] for v in t) / 3
    doubled = {}
    above = [t for t in triangles if middle(t, 1) > NECK]
    below = [t for t in triangles if middle(t, 1) <= NECK]
    for v in {v for t in above for v in t} & {v for t in below for v in t}:
        doubled[v] = len(vertices) + len(doubled)
    vertices += [vertices[v] for v in doubled]
    above = [tuple(doubled.get(v, v) for v in t) for t in above]
    back = [math.dist((middle(t, 0), middle(t, 1), middle(t, 2)), (0.0, 0.14, -0.064)) < 0.016 for t in below]
    below = [t[::-1] if turned else t for t, turned in zip(below, back)]
    vertices += [[0.2, 0.0, 0.2], [0.2, 0.1, 0.2], [0.2, 0.2, 0.2]]
    return vertices, below + above + [above[0]]


def main():
    vertices, triangles = flaw(*polygonize())
    with open(sys.argv[1], "w", encoding="ascii") as out:
        out.write("# An owl on its stone: made by make_mesh.py, flaws included.\n")
        for x, y, z in vertices:
            out.write(f"v {x:.5f} {y:.5f} {z:.5f}\n")
        for a, b, c in triangles:
            out.write(f"f {a + 1} {b + 1} {c + 1}\n")


main()
