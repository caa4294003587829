#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Cables between masts, and a rope at rest.
set -euo pipefail
# Hills, masts on them, and what hangs from these: a point a mast for each of three wires.
awk 'function bump(x, y, a, b, c) { return exp(-((x - a) ^ 2 + (y - b) ^ 2) / c) }
function height(x, y) {
    z = 9 * bump(x, y, 32, 24, 320) + 7 * bump(x, y, 84, -6, 420) + 6 * bump(x, y, 4, -14, 200)
    z += 10 * bump(x, y, 120, 30, 600) + 6 * bump(x, y, -20, 30, 300)
    return z + 5 * bump(x, y, 56, -20, 240) + 0.5 * sin(0.21 * x) * sin(0.17 * y)
}
function line(file, x1, y1, z1, x2, y2, z2) { printf "%.4f %.4f %.4f\n%.4f %.4f %.4f\n\n", x1, z1, -y1, x2, z2, -y2 > file }
BEGIN {
    nx = 260; ny = 200; bands = 30
    for (j = 0; j <= ny; ++j) for (i = 0; i <= nx; ++i) {
        x = -40 + 190 * i / nx; y = -70 + 140 * j / ny
        h[i, j] = height(x, y)
        printf "v %.4f %.4f %.4f\n", x, h[i, j], -y > "hills.obj"
    }
    for (j = 0; j < ny; ++j) for (i = 0; i < nx; ++i) {
        a = j * (nx + 1) + i + 1; b = a + 1; c = b + nx + 1; d = a + nx + 1
        band = int(bands * ((h[i, j] + h[i + 1, j + 1]) / 2 + 0.5) / 10)
        band = band < 0 ? 0 : band >= bands ? bands - 1 : band
        faces[band] = faces[band] "f " a " " b " " c "\nf " a " " c " " d "\n"
    }
    for (band = 0; band < bands; ++band) printf "usemtl band%d\n%s", band, faces[band] > "hills.obj"
    count = 5
    for (m = 0; m < count; ++m) {
        x = 24 * m; y = 6 * sin(0.55 * m + 0.4); z = height(x, y); top = z + 13
        turn = 0.14 * cos(0.55 * m + 0.4); ax = -sin(turn); ay = cos(turn)
        line("masts.xyz", x - 0.9 * ax, y - 0.9 * ay, z - 1, x - 0.25 * ax, y - 0.25 * ay, top)
        line("masts.xyz", x + 0.9 * ax, y + 0.9 * ay, z - 1, x + 0.25 * ax, y + 0.25 * ay, top)
        for (k = 1; k < 5; ++k) {
            low = 0.9 - 0.65 * (k - 1) / 5; high = 0.9 - 0.65 * k / 5; s = k % 2 ? 1 : -1
            line("struts.xyz", x - s * low * ax, y - s * low * ay, z - 1 + 14 * (k - 1) / 5, x + s * high * ax, y + s * high * ay, z - 1 + 14 * k / 5)
        }
        line("masts.xyz", x - 3.2 * ax, y - 3.2 * ay, top - 1.2, x + 3.2 * ax, y + 3.2 * ay, top - 1.2)
        for (w = -1; w <= 1; ++w) {
            wx = x + 3 * w * ax; wy = y + 3 * w * ay; wz = top - 1.2
            line("strings.xyz", wx, wy, wz, wx, wy, wz - 0.9)
            points[w] = points[w] sprintf("%.4f %.4f %.4f\n", wx, wz - 0.9, -wy)
        }
    }
    for (w = -1; w <= 1; ++w) print points[w] > "points.xyz"
}'
filigree spline space points.xyz -o wires.xyz --cable --slack 0.02 --gravity 0,-1,0 --quiet

# A rope over a log and a crate, down to the ground.
cat > yard.json <<'END'
{"clearance": 0.035, "obstacles": [
  {"half_space": {"through": [0, 0, 0], "outwards": [0, 1, 0]}},
  {"capsule": {"from": [0.85, 0.5, 1.2], "to": [0.65, 0.5, -1.2], "radius": 0.5}},
  {"box": {"centre": [-1.15, 0.35, 0], "half": [0.4, 0.35, 0.8]}}]}
END
printf '%s\n' '-2.6 1.9 0.1' '2.6 2.1 -0.15' > hooks.xyz
filigree spline space hooks.xyz -o rope.xyz --cable --slack 0.5 --cable-segments 120 --obstacles yard.json --gravity 0,-1,0 --quiet
printf '%s\n' '0.85 0.5 1.2' '0.65 0.5 -1.2' > log.xyz
printf '%s\n' '-2.6 0 0.1' '-2.6 1.95 0.1' '' '2.6 0 -0.15' '2.6 2.15 -0.15' > posts.xyz
awk 'BEGIN {
    for (i = 0; i < 8; ++i) print "v", -1.15 + (i % 2 ? 0.4 : -0.4), (i > 3 ? 0.7 : 0), (int(i / 2) % 2 ? -0.8 : 0.8)
    split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", c, " ")
    for (f = 0; f < 6; ++f) print "f", c[4 * f + 1], c[4 * f + 2], c[4 * f + 3] "\nf", c[4 * f + 1], c[4 * f + 3], c[4 * f + 4]
}' > crate.obj

# From meadows to stone, a colour a band.
awk 'function part(a, b, t, k) { return int(a[k] + t * (b[k] - a[k]) + 0.5) }
BEGIN {
    stops = split("84 116 82,112 141 95,156 168 118,186 178 146,205 194 176", stop, ",")
    for (band = 0; band < 30; ++band) {
        at = band / 29 * (stops - 1.001); first = int(at)
        split(stop[first + 1], a, " "); split(stop[first + 2], b, " ")
        printf "%s{\"color\": \"#%02x%02x%02x\", \"roughness\": 0.9}", band ? ", " : "", part(a, b, at - first, 1), part(a, b, at - first, 2), part(a, b, at - first, 3)
    }
}' > colors.json
cat > picture.json <<END
{"size": [960, 400], "columns": 2,
 "panels": [
  {"title": "Three wires of four spans: catenaries", "camera": [-34, 11], "margin": 1, "ground": false, "aim": [[0, 0, 0], [96, 4, 0], [0, 16, 0], [96, 20, 0]], "show": [
   {"file": "hills.obj", "border": 0, "regions": [$(cat colors.json)]},
   {"file": "masts.xyz", "color": "#5a6470", "radius": 0.2}, {"file": "struts.xyz", "color": "#5a6470", "radius": 0.1},
   {"file": "strings.xyz", "color": "#e8e4d8", "radius": 0.14}, {"file": "wires.xyz", "color": "#1d232b", "radius": 0.09}]},
  {"title": "A rope at rest on a crate, a log and the ground", "camera": [-20, 15], "margin": 1.08, "show": [
   {"file": "log.xyz", "color": "#8a5a33", "radius": 0.5, "sides": 32}, {"file": "crate.obj", "color": "#c49a5a", "roughness": 0.7},
   {"file": "posts.xyz", "color": "#5a6470", "radius": 0.05}, {"file": "rope.xyz", "color": "#b3382c", "radius": 0.035}]}]}
END
filigree panels picture.json -o cables.png
