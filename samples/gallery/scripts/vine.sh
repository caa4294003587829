#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One closed curve, stylized five times.
set -euo pipefail
filigree stylize --style builtin:braid --points 1500 --target builtin:vine --displacement 0.075 --sigma 0.6 --strokes 5 -o vine.xyz
cat > picture.json <<'END'
{"size": [960, 480],
 "all": {"camera": [14.0, 11.0], "margin": 1.06, "aim_with": "all"},
 "panels": [
  {"title": "One closed curve", "show": [{"file": "builtin:vine", "color": "#599530", "radius": 0.012}]},
  {"title": "Stylized five times", "show": [{"file": "vine.xyz", "color": "#599530", "radius": 0.012, "curves": [0, 1]}, {"file": "vine.xyz", "color": "#81aa3f", "radius": 0.008, "curves": [1, 1]}, {"file": "vine.xyz", "color": "#906538", "radius": 0.015, "curves": [2, 1]}, {"file": "vine.xyz", "color": "#6f5030", "radius": 0.01, "curves": [3, 1]}, {"file": "vine.xyz", "color": "#3f7c45", "radius": 0.007, "curves": [4, 1]}]}]}
END
filigree panels picture.json -o vine.png
