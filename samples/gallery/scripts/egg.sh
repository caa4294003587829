#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An egg of gold, enamel and pearls.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree mesh repair builtin:egg --weld 1e-6 -o egg.ply
filigree tangle egg.ply "$samples/tangles/egg.json" -o egg.glb
cat > picture.json <<'END'
{"size": [480, 592],
 "panels": [
  {"camera": [16.7, 14.0], "margin": 1.02, "show": [{"file": "egg.glb"}]}]}
END
filigree panels picture.json -o egg.png
