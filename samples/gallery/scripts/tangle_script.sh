#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The script that sdk/tangles/README.md explains, operation by operation.
set -euo pipefail
samples=$(cd "$(dirname "$0")/../.." && pwd)
filigree mesh repair builtin:ball --weld 1e-6 -o ball.ply
for first in 1 2 3; do
    filigree tangle ball.ply "$samples/tangles/dots.json" --first $first -o dots_$first.glb
done

cat > picture.json <<'END'
{"size": [960, 320],
 "all": {"camera": [16.7, 18.5], "margin": 1.02},
 "panels": [
  {"title": "1 contour: bands", "show": [{"file": "dots_1.glb"}]},
  {"title": "2 contour: dots", "show": [{"file": "dots_2.glb"}]},
  {"title": "3 displace: dots", "show": [{"file": "dots_3.glb"}]}]}
END
filigree panels picture.json -o tangle_script.png
