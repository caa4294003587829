#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A style on the Thomas attractor.
set -euo pipefail
filigree stylize --style builtin:twist --target builtin:thomas:2600 --attributes angle:0.01 --angle s1 --displacement 0.030 --columns -o first.xyz
filigree stylize --style builtin:twist --target builtin:thomas --attributes angle:0.01 --angle s1 --displacement 0.012 --columns -o all.xyz
cat > picture.json <<'END'
{"size": [960, 440],
 "all": {"camera": [135.0, 35.3]},
 "panels": [
  {"title": "The first 2,600 points", "show": [{"file": "first.xyz", "color": "#d43527", "radius": 0.026, "color_end": "#eda230", "as": "ribbon"}]},
  {"title": "All of it: 369,400 points", "show": [{"file": "all.xyz", "color": "#d43527", "radius": 0.004, "color_end": "#eda230", "as": "ribbon"}]}]}
END
filigree panels picture.json -o thomas.png
