#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A style drawn in a plane, in three planes, and all at once.
set -euo pipefail
filigree stylize --style builtin:knit --target builtin:s_curve --displacement 0.065 --basis 1,0,0,0,1,0,0,0,1 -o knit_0.xyz
filigree stylize --style builtin:knit --target builtin:s_curve --displacement 0.065 --basis 1,0,0,0,-0.5,-0.8660254,0,0.8660254,-0.5 -o knit_1.xyz
filigree stylize --style builtin:knit --target builtin:s_curve --displacement 0.065 --basis 1,0,0,0,-0.5,0.8660254,0,-0.8660254,-0.5 -o knit_2.xyz
cat > picture.json <<'END'
{"size": [960, 360],
 "all": {"camera": [11.3, 6.7], "aim_with": "all"},
 "panels": [
  {"title": "A style in a plane", "show": [{"file": "knit_0.xyz", "color": "#d43527", "radius": 0.01}]},
  {"title": "turned by a third", "show": [{"file": "knit_1.xyz", "color": "#eda230", "radius": 0.01}]},
  {"title": "by two thirds", "show": [{"file": "knit_2.xyz", "color": "#197c79", "radius": 0.01}]},
  {"title": "all three", "show": [{"file": "knit_0.xyz", "color": "#d43527", "radius": 0.01}, {"file": "knit_1.xyz", "color": "#eda230", "radius": 0.01}, {"file": "knit_2.xyz", "color": "#197c79", "radius": 0.01}]}]}
END
filigree panels picture.json -o planes.png
