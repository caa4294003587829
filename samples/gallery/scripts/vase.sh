#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A vase in the glazes of a potter.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree tangle builtin:vase:960 "$samples/tangles/vase.json" -o vase.glb
cat > picture.json <<'END'
{"size": [560, 760],
 "panels": [
  {"camera": [14.0, 12.0], "margin": 1.02, "show": [{"file": "vase.glb"}]}]}
END
filigree panels picture.json -o vase.png
