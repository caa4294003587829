#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Forms as they are made, and decorated.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree mesh refine builtin:figure --levels 5 --scheme loop -o figure.ply
filigree tangle figure.ply "$samples/tangles/cat.json" -o cat.glb
filigree tangle builtin:vase:960 "$samples/tangles/vase.json" -o vase.glb

cat > picture.json <<'END'
{"size": [1200, 380],
 "all": {"margin": 1.05},
 "panels": [
  {"title": "919,680 triangles", "camera": [14.0, 12.0], "show": [{"file": "builtin:vase:960", "color": "#c4c4c4", "roughness": 0.6}]},
  {"title": "decorated by vase.json", "camera": [14.0, 12.0], "show": [{"file": "vase.glb"}]},
  {"title": "352,256 triangles", "camera": [28.8, 12.4], "show": [{"file": "figure.ply", "color": "#c4c4c4", "roughness": 0.6}]},
  {"title": "decorated by cat.json", "camera": [28.8, 12.4], "show": [{"file": "cat.glb"}]}]}
END
filigree panels picture.json -o tangle_models.png
