#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The guide of a flow that goes on for longer, and one of the user.
set -euo pipefail
# Three waves, and curls along them.
awk 'BEGIN {for (i = 0; i <= 300; ++i) {u = i / 300; print 1.6 * u, 0.10 * sin(18.85 * u), 0}}' > waves.xyz
filigree stylize --style builtin:curls --target waves.xyz --displacement 0.022 -o curly.xyz
awk 'BEGIN {for (i = 0; i <= 300; ++i) {x = 1.9 * (i / 300 - 0.5); print x, -0.35 * x * x, 0}}' > arch.xyz
filigree stylize --style curly.xyz --smoothing 300 --target arch.xyz --scale 1 --save-guide smooth.xyz -o both.xyz
filigree stylize --style curly.xyz --guide waves.xyz --target arch.xyz --scale 1 --save-guide drawn.xyz -o curls.xyz
cat > picture.json <<'END'
{"size": [960, 460], "columns": 2,
 "all": {"camera": [2.9, 5.7], "ground": false, "margin": 1.04},
 "panels": [
  {"title": "A guide smoothed 300 times as much", "keys": [{"color": "#959597", "text": "example"}, {"color": "#197c79", "text": "guide, straight"}], "show": [{"file": "curly.xyz", "color": "#959597", "radius": 0.007}, {"file": "smooth.xyz", "color": "#197c79", "radius": 0.011, "in_front": true}], "aim": [[-0.02, -0.16, 0], [1.62, -0.16, 0], [-0.02, 0.16, 0], [1.62, 0.16, 0], [0.8, 0.4, 0]]},
  {"title": "A guide that you draw", "keys": [{"color": "#959597", "text": "example"}, {"color": "#d43527", "text": "guide, along the waves"}], "show": [{"file": "curly.xyz", "color": "#959597", "radius": 0.007}, {"file": "drawn.xyz", "color": "#d43527", "radius": 0.011, "in_front": true}], "aim": [[-0.02, -0.16, 0], [1.62, -0.16, 0], [-0.02, 0.16, 0], [1.62, 0.16, 0], [0.8, 0.4, 0]]},
  {"title": "Its result on an arch: waves and curls", "aim_with": "below", "show": [{"file": "both.xyz", "color": "#197c79", "radius": 0.009}]},
  {"title": "Its result on an arch: curls alone", "aim_with": "below", "show": [{"file": "curls.xyz", "color": "#d43527", "radius": 0.009}]}]}
END
filigree panels picture.json -o guide.png
