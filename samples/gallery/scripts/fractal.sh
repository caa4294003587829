#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A closed curve, stylized, and stylized again.
set -euo pipefail
awk 'BEGIN {print "# closed"; for (i = 0; i < 300; ++i) {a = 6.2831853 * i / 300; print 0.6 * sin(a), 0, -0.6 * cos(a)}}' > circle.xyz
filigree stylize --style builtin:loops --target circle.xyz --displacement 0.080 -o once.xyz
filigree stylize --style builtin:loops --target once.xyz --displacement 0.020 -o twice.xyz
cat > picture.json <<'END'
{"size": [960, 320],
 "all": {"camera": [5.7, 54.3], "aim_with": "all"},
 "panels": [
  {"title": "A closed curve", "show": [{"file": "circle.xyz", "color": "#273555", "radius": 0.014}]},
  {"title": "in a style", "show": [{"file": "once.xyz", "color": "#197c79", "radius": 0.009}]},
  {"title": "and in it once more", "show": [{"file": "twice.xyz", "color": "#d43527", "radius": 0.004}]}]}
END
filigree panels picture.json -o fractal.png
