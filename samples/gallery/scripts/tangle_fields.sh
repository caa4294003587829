#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The distance from a border, and the blend between two.
set -euo pipefail
filigree mesh repair builtin:dish -o dish.obj
# Vertices of edges with one triangle: those within 0.3 m of the middle are the hole's, the others the rim's.
borders=$(awk '
    $1 == "v" {radius[++n] = sqrt($2 * $2 + $4 * $4)}
    $1 == "f" {for (i = 2; i <= 4; ++i) {a = $i; b = $(i % 3 + 2); ++sides[a < b ? a " " b : b " " a]}}
    END {
        for (s in sides) if (sides[s] == 1) {split(s, ends, " "); border[ends[1]]; border[ends[2]]}
        for (v in border) print (radius[v] < 0.3 ? "hole" : "rim"), v - 1
    }' dish.obj)
for border in hole rim; do
    vertices=$(awk -v border=$border '$1 == border {print $2}' <<< "$borders" | sort -n | paste -sd ';')
    filigree geodesic dish.obj --source "$vertices" -o $border.txt
done
paste hole.txt rim.txt | awk '{print $1 / ($1 + $2)}' > blend.txt

cat > picture.json <<'END'
{"size": [960, 360],
 "all": {"camera": [16.7, 39.2], "margin": 1.05},
 "panels": [
  {"title": "Distance from the hole, a line every 4 cm", "show": [{"file": "dish.obj", "field": "hole.txt", "every": 0.04, "line_width": 1, "line_color": [1, 1, 1]}]},
  {"title": "Blend from hole to rim: lines follow both", "show": [{"file": "dish.obj", "field": "blend.txt", "every": 0.1, "line_width": 1, "line_color": [1, 1, 1]}]}]}
END
filigree panels picture.json -o tangle_fields.png
