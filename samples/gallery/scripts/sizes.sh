#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A sketch in a style: as large as that was drawn, and in the size that fits each stroke.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree stylize --style builtin:curls --target "$samples/data/snail.tilt" --scale 0.3 -o one.glb --as tube
filigree stylize --style builtin:curls --target "$samples/data/snail.tilt" -o fitting.glb
cat > picture.json <<END
{"size": [1080, 400], "columns": 3,
 "all": {"camera": [20.0, 12.0], "margin": 1.06, "aim_with": "all"},
 "panels": [
  {"title": "A sketch", "show": [{"file": "$samples/data/snail.tilt"}]},
  {"title": "One size for all strokes", "show": [{"file": "one.glb"}]},
  {"title": "By itself: each stroke's own size", "show": [{"file": "fitting.glb"}]}]}
END
filigree panels picture.json -o sizes.png
