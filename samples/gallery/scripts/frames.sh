#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Frenet frames flip at inflections, rotation-minimizing ones do not.
set -euo pipefail
awk 'BEGIN {for (i = 0; i < 200; ++i) {u = i / 199 - 0.5; print 1.6 * u, 0.25 * sin(9 * u), 0}}' > wave.xyz
filigree stylize --style builtin:loops --target wave.xyz --displacement 0.055 --frame frenet -o frenet.xyz
filigree stylize --style builtin:loops --target wave.xyz --displacement 0.055 -o rmf.xyz
cat > picture.json <<'END'
{"size": [960, 360],
 "all": {"camera": [8.5, 40.1]},
 "panels": [
  {"title": "Frenet frames flip", "notes": [{"at": [-0.5585, 0, 0], "text": "flip", "by": [34, -20]}, {"at": [0, 0, 0], "text": "flip", "by": [-34, -18]}, {"at": [0.5585, 0, 0], "text": "flip", "by": [38, -18]}], "show": [{"file": "frenet.xyz", "color": "#d43527", "radius": 0.008}, {"file": "wave.xyz", "color": "#959597", "radius": 0.003}]},
  {"title": "Rotation-minimizing frames do not", "show": [{"file": "rmf.xyz", "color": "#197c79", "radius": 0.008}, {"file": "wave.xyz", "color": "#959597", "radius": 0.003}]}]}
END
filigree panels picture.json -o frames.png
