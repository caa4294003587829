#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Temperature 0, 1 and 10.
set -euo pipefail
for tau in 0 1 10; do
    filigree stylize --style builtin:knots --target builtin:s_curve --displacement 0.040 --tau $tau --save-path path.txt --save-matching index.txt -o curve_$tau.xyz
    # One piece for each run that is copied: to the right the place on the result, upwards that on the example.
    awk -v style="$(wc -l < index.txt)" '{
        for (i = 1; i <= NF; ++i) {
            if (i == 1 || $i != $(i - 1) + 1) print (i > 1 ? "\n" : "") (i - 1) / NF - 1e-4, $i / style, 0
            print (i - 1) / NF, $i / style, 0
        }
    }' path.txt > runs_$tau.xyz
done
printf '0 1 0\n0 0 0\n1 0 0\n' > axes.xyz

cat > picture.json <<'END'
{"size": [960, 720], "columns": 3,
 "panels": [
  {"title": "Temperature 0", "camera": [11.3, 6.7], "aim_with": "above", "show": [{"file": "curve_0.xyz", "color": "#d43527", "radius": 0.01}]},
  {"title": "Temperature 1", "camera": [11.3, 6.7], "aim_with": "above", "show": [{"file": "curve_1.xyz", "color": "#d43527", "radius": 0.01}]},
  {"title": "Temperature 10", "camera": [11.3, 6.7], "aim_with": "above", "show": [{"file": "curve_10.xyz", "color": "#d43527", "radius": 0.01}]},
  {"title": "copies long runs of the example", "camera": [0, 0], "ground": false, "aim": [[-0.02, -0.12, 0], [1.02, 1.22, 0]], "notes": [{"at": [0.5, 0, 0], "text": "along the result \u2192", "by": [0, 16], "color": "#273555", "size": 14}, {"at": [0, 1, 0], "text": "along the example \u2191", "by": [0, -14], "color": "#273555", "size": 14, "align": "left"}], "show": [{"file": "runs_0.xyz", "color": "#273555", "radius": 0.007}, {"file": "axes.xyz", "color": "#959597", "radius": 0.003}]},
  {"title": "shorter runs: more variation", "camera": [0, 0], "ground": false, "aim": [[-0.02, -0.12, 0], [1.02, 1.22, 0]], "notes": [{"at": [0.5, 0, 0], "text": "along the result \u2192", "by": [0, 16], "color": "#273555", "size": 14}, {"at": [0, 1, 0], "text": "along the example \u2191", "by": [0, -14], "color": "#273555", "size": 14, "align": "left"}], "show": [{"file": "runs_1.xyz", "color": "#273555", "radius": 0.007}, {"file": "axes.xyz", "color": "#959597", "radius": 0.003}]},
  {"title": "single points: noise", "camera": [0, 0], "ground": false, "aim": [[-0.02, -0.12, 0], [1.02, 1.22, 0]], "notes": [{"at": [0.5, 0, 0], "text": "along the result \u2192", "by": [0, 16], "color": "#273555", "size": 14}, {"at": [0, 1, 0], "text": "along the example \u2191", "by": [0, -14], "color": "#273555", "size": 14, "align": "left"}], "show": [{"file": "runs_10.xyz", "color": "#273555", "radius": 0.007}, {"file": "axes.xyz", "color": "#959597", "radius": 0.003}]}]}
END
filigree panels picture.json -o temperature.png
