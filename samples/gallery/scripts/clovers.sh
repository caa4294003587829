#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A drawing in every cell.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree tangle builtin:dish "$samples/tangles/clovers.json" -o clovers.glb
cat > picture.json <<'END'
{"size": [640, 448],
 "panels": [
  {"camera": [11.3, 31.3], "margin": 1.02, "show": [{"file": "clovers.glb"}]}]}
END
filigree panels picture.json -o clovers.png
