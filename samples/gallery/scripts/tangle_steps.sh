#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The first eleven operations of samples/tangles/cat.json.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree mesh refine builtin:figure --levels 4 --scheme loop -o cat.ply
for first in $(seq 0 11); do
    filigree tangle cat.ply "$samples/tangles/cat.json" --first $first -o cat_$first.glb
done

cat > picture.json <<'END'
{"size": [1200, 900], "columns": 4,
 "all": {"camera": [28.8, 12.4], "margin": 1.02, "aim": [[0.132, 0.22999999999999998, 0.068], [0.132, 0.22999999999999998, 0.328], [0.132, 0.49, 0.068], [0.132, 0.49, 0.328], [0.392, 0.22999999999999998, 0.068], [0.392, 0.22999999999999998, 0.328], [0.392, 0.49, 0.068], [0.392, 0.49, 0.328]]},
 "panels": [
  {"title": "The form", "show": [{"file": "cat_0.glb"}]},
  {"title": "1 contour: spots", "show": [{"file": "cat_1.glb"}]},
  {"title": "2 displace: spots", "show": [{"file": "cat_2.glb"}]},
  {"title": "3 contour: rims", "show": [{"file": "cat_3.glb"}]},
  {"title": "4 contour: wreaths", "show": [{"file": "cat_4.glb"}]},
  {"title": "5 contour: discs", "show": [{"file": "cat_5.glb"}]},
  {"title": "6 contour: hearts", "show": [{"file": "cat_6.glb"}]},
  {"title": "7 stream: rays", "show": [{"file": "cat_7.glb"}]},
  {"title": "8 displace: hearts", "show": [{"file": "cat_8.glb"}]},
  {"title": "9 contour: pips", "show": [{"file": "cat_9.glb"}]},
  {"title": "10 contour: irises", "show": [{"file": "cat_10.glb"}]},
  {"title": "11 contour: pupils", "show": [{"file": "cat_11.glb"}]}]}
END
filigree panels picture.json -o tangle_steps.png
