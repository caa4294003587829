#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Borders redrawn after a stroke.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree tangle builtin:dish "$samples/tangles/waves.json" -o waves.glb
# Without the operation that redraws them:
sed -e '/"stylize"/d' -e 's/coast\.foreground/islands.foreground/' "$samples/tangles/waves.json" > plain.json
filigree tangle builtin:dish plain.json -o plain.glb
cp "$samples/tangles/waves.xyz" .

cat > picture.json <<'END'
{"size": [960, 320],
 "all": {"margin": 1.06},
 "panels": [
  {"title": "Borders as they are cut", "camera": [11.3, 52.6], "show": [{"file": "plain.glb"}]},
  {"title": "a drawn stroke", "camera": [0, 0], "ground": false, "show": [{"file": "waves.xyz", "color": "#273555", "radius": 0.08}]},
  {"title": "borders redrawn in its style", "camera": [11.3, 52.6], "show": [{"file": "waves.glb"}]}]}
END
filigree panels picture.json -o waves.png
