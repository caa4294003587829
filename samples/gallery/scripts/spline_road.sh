#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A road over hills: as wide all along, on the ground, smoother than the ground.
set -euo pipefail
# Hills, in bands of height, with the rough ground of noise.
awk 'function bump(x, y, a, b, c) { return exp(-((x - a) ^ 2 + (y - b) ^ 2) / c) }
function rough(x, y) { return sin(7.3 * x + 2 * sin(3.1 * y)) * sin(6.1 * y + 1.7 * sin(4.3 * x)) }
function height(x, y) {
    return 1.25 * bump(x, y, -3.3, 1.7, 2.6) + 1.5 * bump(x, y, 2.3, 2.2, 2.4) + 0.95 * bump(x, y, 0.4, -2, 2.2) +
        0.8 * bump(x, y, 5.2, -2.2, 2.5) + 0.7 * bump(x, y, -5.3, -2.3, 2.2) + 0.3 * bump(x, y, 5.6, 2.4, 1.2) +
        0.1 * sin(1.3 * x + 0.5) * sin(1.1 * y) + 0.014 * rough(x, y) * (1 + 0.5 * rough(2.3 * y, 1.9 * x))
}
BEGIN {
    nx = 260; ny = 150; bands = 12
    for (j = 0; j <= ny; ++j) for (i = 0; i <= nx; ++i) {
        x = -6.5 + 13 * i / nx; y = -3.75 + 7.5 * j / ny
        h[i, j] = height(x, y)
        printf "v %.5f %.5f %.5f\n", x, y, h[i, j]
    }
    for (j = 0; j < ny; ++j) for (i = 0; i < nx; ++i) {
        a = j * (nx + 1) + i + 1; b = a + 1; c = b + nx + 1; d = a + nx + 1
        band = int(bands * ((h[i, j] + h[i + 1, j + 1]) / 2 + 0.12) / 1.65)
        band = band < 0 ? 0 : band >= bands ? bands - 1 : band
        faces[band] = faces[band] "f " a " " b " " c "\nf " a " " c " " d "\n"
    }
    for (band = 0; band < bands; ++band) printf "usemtl band%d\n%s", band, faces[band]
}' > hills.obj
printf '%s\n' '-6.45 -0.6 0' '-4.4 -0.5 0' '-2.6 -0.9 0' '-1.2 0.5 0' '0.2 1.5 0' '1.1 0.2 0' '2.7 -0.5 0' '3.5 -1.6 0' '4.4 0.1 0' '6.45 0.7 0' > places.xyz

along() { filigree spline hills.obj places.xyz --smoothing-scale 0.25 --quiet "$@"; }
along -o middle.xyz --on-mesh --height 0.03 --road 0.36 --road-output road.obj --road-height 0.02 --road-spacing 0.04 --road-columns 8
along -o left.xyz --on-mesh --offset 0.15 --height 0.028
along -o right.xyz --on-mesh --offset -0.15 --height 0.028
# A dash, a gap.
awk '{
    step = NR > 1 ? sqrt(($1 - x) ^ 2 + ($2 - y) ^ 2 + ($3 - z) ^ 2) : 0
    x = $1; y = $2; z = $3; length_so_far += step
    now = length_so_far % 0.3 < 0.16
    if (was && !now) print ""
    if (now) print
    was = now
}' middle.xyz > dashes.xyz

cat > picture.json <<'END'
{"size": [960, 520],
 "all": {"camera": [-14, 38], "margin": 0.83, "ground": false},
 "panels": [{"show": [
  {"file": "hills.obj", "border": 0, "regions": [
   {"color": "#5d7a55", "roughness": 0.9}, {"color": "#67845a", "roughness": 0.9}, {"color": "#728d60", "roughness": 0.9},
   {"color": "#7f9767", "roughness": 0.9}, {"color": "#8fa06f", "roughness": 0.9}, {"color": "#a0a879", "roughness": 0.9},
   {"color": "#b0ae85", "roughness": 0.9}, {"color": "#bcb194", "roughness": 0.9}, {"color": "#c4b5a1", "roughness": 0.9},
   {"color": "#cfc2b3", "roughness": 0.9}, {"color": "#dfd7cd", "roughness": 0.9}, {"color": "#f0ede8", "roughness": 0.9}]},
  {"file": "road.obj", "color": "#3a4048", "roughness": 0.8},
  {"file": "dashes.xyz", "color": "#f4d35e", "radius": 0.012, "shadow": false},
  {"file": "left.xyz", "color": "#f5f2ea", "radius": 0.01, "shadow": false},
  {"file": "right.xyz", "color": "#f5f2ea", "radius": 0.01, "shadow": false}]}]}
END
filigree panels picture.json -o spline_road.png
