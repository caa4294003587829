#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An example, its guide, and the Lorenz attractor in its style.
set -euo pipefail
filigree stylize --style builtin:twist --target builtin:lorenz:2800 --attributes angle:0.01 --angle s1 --displacement 0.026 --columns --save-guide guide.xyz -o ribbon.xyz
cat > picture.json <<'END'
{"size": [960, 760], "columns": 2,
 "panels": [
  {"title": "The example", "camera": [11.3, 6.7], "keys": [{"color": "#197c79", "text": "as drawn"}, {"color": "#959597", "text": "the guide found in it"}], "show": [{"file": "builtin:twist", "color": "#197c79", "radius": 0.01}, {"file": "guide.xyz", "color": "#959597", "radius": 0.007}]},
  {"title": "The Lorenz attractor", "camera": [19.3, 6.5], "aim_with": "all", "show": [{"file": "builtin:lorenz:2800", "color": "#273555", "radius": 0.006}]},
  {"title": "in the example's shape", "camera": [19.3, 6.5], "aim_with": "all", "show": [{"file": "ribbon.xyz", "color": "#273555", "radius": 0.006}]},
  {"title": "and turning as the example does", "camera": [19.3, 6.5], "aim_with": "all", "show": [{"file": "ribbon.xyz", "color": "#d43527", "radius": 0.018, "color_end": "#eda230", "as": "ribbon"}]}]}
END
filigree panels picture.json -o lorenz.png
