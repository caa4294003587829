#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One result at three magnitudes.
set -euo pipefail
filigree stylize --style builtin:curls --target builtin:spiral --displacement 0.040 --columns -o curls.xyz
cat > picture.json <<'END'
{"size": [960, 330],
 "all": {"camera": [16.7, 23.3], "aim_with": "all"},
 "panels": [
  {"title": "Magnitude 0", "show": [{"file": "curls.xyz", "color": "#197c79", "radius": 0.009, "magnitude": -1}]},
  {"title": "Magnitude 0.5", "show": [{"file": "curls.xyz", "color": "#197c79", "radius": 0.009, "magnitude": -0.5}]},
  {"title": "Magnitude 1", "show": [{"file": "curls.xyz", "color": "#197c79", "radius": 0.009, "magnitude": 0}]}]}
END
filigree panels picture.json -o magnitude.png
