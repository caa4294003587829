#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A drawing, a model with bones, ornament, a walk.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree skeleton "$samples/models/cat.json" --motion walk -o model.glb
filigree tangle model.glb "$samples/tangles/medals.json" -o walker.glb
cat > picture.json <<'END'
{"size": [1350, 420],
 "panels": [
  {"camera": [28, 14], "margin": 1.05, "show": [{"file": "model.glb"}]},
  {"camera": [28, 14], "margin": 1.05, "show": [{"file": "walker.glb", "time": 0.25}]},
  {"camera": [28, 14], "margin": 1.05, "show": [{"file": "walker.glb", "time": 0.6}]}]}
END
filigree panels picture.json -o walker.png
