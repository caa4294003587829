#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A road over hills: as wide all along, on the ground, smoother than the ground.
set -euo pipefail
# Hills, in bands of height, with the rough ground of noise.
awk 'function bump(x, y, a, b, c) { return exp(-((x - a) ^ 2 + (y - b) ^ 2) / c) }
function rough(x, y) { return sin(7.3 * x + 2 * sin(3.1 * y)) * sin(6.1 * y + 1.7 * sin(4.3 * x)) }
function height(x, y) {
    z = 1.25 * bump(x, y, -3.3, 1.7, 2.6) + 1.5 * bump(x, y, 2.3, 2.2, 2.4) + 0.95 * bump(x, y, 0.4, -2, 2.2)
    z += 0.8 * bump(x, y, 5.2, -2.2, 2.5) + 0.7 * bump(x, y, -5.3, -2.3, 2.2) + 0.3 * bump(x, y, 5.6, 2.4, 1.2)
    z += 1.1 * bump(x, y, -0.6, 4.6, 2.8) + 1.3 * bump(x, y, 6.2, 4.8, 3) + 0.9 * bump(x, y, -6.8, 4.4, 3)
    z += 0.1 * sin(1.3 * x + 0.5) * sin(1.1 * y)
    return z + 0.014 * rough(x, y) * (1 + 0.5 * rough(2.3 * y, 1.9 * x))
}
BEGIN {
    nx = 340; ny = 220; bands = 30
    for (j = 0; j <= ny; ++j) for (i = 0; i <= nx; ++i) {
        x = -8.5 + 17 * i / nx; y = -6 + 12 * j / ny
        h[i, j] = height(x, y)
        printf "v %.5f %.5f %.5f\n", x, h[i, j], -y
    }
    for (j = 0; j < ny; ++j) for (i = 0; i < nx; ++i) {
        a = j * (nx + 1) + i + 1; b = a + 1; c = b + nx + 1; d = a + nx + 1
        band = int(bands * ((h[i, j] + h[i + 1, j + 1]) / 2 + 0.12) / 1.65)
        band = band < 0 ? 0 : band >= bands ? bands - 1 : band
        faces[band] = faces[band] "f " a " " b " " c "\nf " a " " c " " d "\n"
    }
    for (band = 0; band < bands; ++band) printf "usemtl band%d\n%s", band, faces[band]
}' > hills.obj
printf '%s\n' '-8.4 0 0.9' '-5.6 0 0.4' '-3 0 0.9' '-1.3 0 -0.6' '0.1 0 -1.6' '1 0 -0.2' '2.6 0 0.5' '3.7 0 1.1' '4.6 0 0.1' '5.3 0 -1.1' '8.4 0 -1' > places.xyz

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

# From meadows to snow, a colour a band.
awk 'function part(a, b, t, k) { return int(a[k] + t * (b[k] - a[k]) + 0.5) }
BEGIN {
    stops = split("84 116 82,112 141 95,156 168 118,186 178 146,198 182 164,240 237 232", stop, ",")
    for (band = 0; band < 30; ++band) {
        at = band / 29 * (stops - 1.001); first = int(at)
        split(stop[first + 1], a, " "); split(stop[first + 2], b, " ")
        printf "%s{\"color\": \"#%02x%02x%02x\", \"roughness\": 0.9}", band ? ", " : "", part(a, b, at - first, 1), part(a, b, at - first, 2), part(a, b, at - first, 3)
    }
}' > colors.json
cat > picture.json <<END
{"size": [960, 440],
 "all": {"camera": [-18, 34], "margin": 1, "ground": false, "aim": [[-4.7, 0, 1.2], [4.7, 0, 1.2], [-4.6, 1.3, -2.2], [5, 1.3, -2.2]]},
 "panels": [{"show": [
  {"file": "hills.obj", "border": 0, "regions": [$(cat colors.json)]},
  {"file": "road.obj", "color": "#3a4048", "roughness": 0.8},
  {"file": "dashes.xyz", "color": "#f4d35e", "radius": 0.012, "shadow": false},
  {"file": "left.xyz", "color": "#f5f2ea", "radius": 0.01, "shadow": false},
  {"file": "right.xyz", "color": "#f5f2ea", "radius": 0.01, "shadow": false}]}]}
END
filigree panels picture.json -o spline_road.png
