#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Small patches, large ones, both.
set -euo pipefail
# Three waves, and curls along them.
awk 'BEGIN {for (i = 0; i <= 300; ++i) {u = i / 300; print 1.6 * u, 0.10 * sin(18.85 * u), 0}}' > waves.xyz
filigree stylize --style builtin:curls --target waves.xyz --displacement 0.022 -o curly.xyz
awk 'BEGIN {for (i = 0; i <= 300; ++i) print 3.2 * i / 300, 0, 0}' > line.xyz
# The colour says where on the example a point comes from.
paint() {  # IN OUT
    awk '
        function mix(a, b) {return a + (b - a) * (t * 4 - k)}
        BEGIN {split("0.05 0.02 0.20 0.03 0.10 0.28 0.02 0.26 0.22 0.22 0.50 0.07 0.90 0.80 0.25", color, " ")}
        /^# columns/ {for (i = 3; i <= NF; ++i) column[$i] = i - 2; print "# columns x y z red green blue alpha"; next}
        /^#/ || NF == 0 {print; next}
        {
            t = $column["style_index"] / most; t = t > 1 ? 1 : t; k = t < 1 ? int(4 * t) : 3; c = 3 * k
            print $1, $2, $3, mix(color[c + 1], color[c + 4]), mix(color[c + 2], color[c + 5]), mix(color[c + 3], color[c + 6]), 1
        }' most="$(wc -l < index.txt)" "$1" > "$2"
}
filigree stylize --style curly.xyz --smoothing 300 --multiresolution 3:1 --save-guide guide.xyz --save-matching index.txt --target line.xyz --scale 1 --start random --tau 0.3 --columns -o small.xyz
filigree stylize --style curly.xyz --smoothing 300 --multiresolution 60:1 --target line.xyz --scale 1 --start random --tau 0.05 --columns -o large.xyz
filigree stylize --style curly.xyz --smoothing 300 --multiresolution 3:1,60:0.3 --target line.xyz --scale 1 --start random --tau 0.1 --columns -o two.xyz
filigree stylize --style curly.xyz --smoothing 300 --multiresolution 3:1 --target guide.xyz --scale 1 --columns -o example.xyz
for name in example small large two; do paint $name.xyz $name.painted.xyz; done

cat > picture.json <<'END'
{"size": [960, 560], "columns": 1,
 "all": {"camera": [0.0, 5.7], "ground": false, "aim_with": "all"},
 "panels": [
  {"title": "The example: curls along waves", "show": [{"file": "example.painted.xyz", "radius": 0.0085}], "notes": [{"at": [2.5, 0, 0], "text": "Colours below say which part of it is copied", "color": "#273555", "size": 14}]},
  {"title": "Small patches: curls go on, waves break off", "show": [{"file": "small.painted.xyz", "radius": 0.0085}]},
  {"title": "Large patches: waves go on", "show": [{"file": "large.painted.xyz", "radius": 0.0085}]},
  {"title": "Both sizes: waves and curls go on", "show": [{"file": "two.painted.xyz", "radius": 0.0085}]}]}
END
filigree panels picture.json -o multiresolution.png
