#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A cat for a feast.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree mesh refine builtin:figure --levels 5 --scheme loop -o cat.ply
filigree tangle cat.ply "$samples/tangles/cat.json" -o cat.glb
cat > picture.json <<'END'
{"size": [720, 576],
 "panels": [
  {"camera": [28.8, 12.4], "margin": 1.02, "show": [{"file": "cat.glb"}]}]}
END
filigree panels picture.json -o cat.png
