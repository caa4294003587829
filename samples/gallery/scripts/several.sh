#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Three strokes in one style; colours say which is copied.
set -euo pipefail
# Three strokes, one above the other, as one style.
filigree stylize --style builtin:loops --target builtin:zigzag --scale 1 --sigma 0 -o zigzag.xyz
awk '!/^#/ && NF {print $1, $2 + 0.26, $3} END {print ""}' zigzag.xyz >> strokes.xyz
filigree stylize --style builtin:loops --target builtin:knots --scale 1 --sigma 0 -o knots.xyz
awk '!/^#/ && NF {print $1, $2 + 0, $3} END {print ""}' knots.xyz >> strokes.xyz
filigree stylize --style builtin:loops --target builtin:curls --scale 1 --sigma 0 -o curls.xyz
awk '!/^#/ && NF {print $1, $2 + -0.26, $3} END {print ""}' curls.xyz >> strokes.xyz
filigree stylize --style strokes.xyz --target builtin:spiral --displacement 0.035 --save-guide guide.xyz --columns -o result.xyz
# The result in the colours of what it copies: the guide has as many points as the style.
awk '
    NR == FNR {if ($0 ~ /^#/) next; if (NF == 0) {if (n > 0) end[++strokes] = n; next} ++n; next}
    /^# columns/ {for (i = 3; i <= NF; ++i) column[$i] = i - 2; print "# columns x y z red green blue alpha"; next}
    /^#/ || NF == 0 {print; next}
    {
        i = $column["style_index"]
        print $1, $2, $3, i < end[1] ? "0.66 0.035 0.020" : i < end[2] ? "0.85 0.36 0.03" : "0.010 0.200 0.190", 1
    }' guide.xyz result.xyz > painted.xyz

cat > picture.json <<'END'
{"size": [960, 420],
 "panels": [
  {"title": "Three strokes, one style", "camera": [5.7, 5.7], "show": [{"file": "strokes.xyz", "color": "#d43527", "radius": 0.007, "curves": [0, 1]}, {"file": "strokes.xyz", "color": "#eda230", "radius": 0.007, "curves": [1, 1]}, {"file": "strokes.xyz", "color": "#197c79", "radius": 0.007, "curves": [2, 1]}]},
  {"title": "The result, in the colours of what it copies", "camera": [16.7, 27.8], "show": [{"file": "painted.xyz", "radius": 0.007}]}]}
END
filigree panels picture.json -o several.png
