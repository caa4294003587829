#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# 2,000 hairs at three magnitudes.
set -euo pipefail
for sigma in 0 0.5 1; do
    filigree stylize --style builtin:curls --points 200 --target builtin:hair --displacement 0.006 --sigma $sigma --columns -o hair_$sigma.xyz
done
cat > picture.json <<'END'
{"size": [960, 400],
 "all": {"camera": [28.8, 7.5], "margin": 1.03, "aim_with": "all"},
 "panels": [
  {"title": "Magnitude 0: combed", "show": [{"file": "builtin:head", "sides": 32, "gloss": 0.1, "round_ends": false}, {"file": "hair_0.xyz", "sides": 5}]},
  {"title": "Magnitude 0.5", "show": [{"file": "builtin:head", "sides": 32, "gloss": 0.1, "round_ends": false}, {"file": "hair_0.5.xyz", "sides": 5}]},
  {"title": "Magnitude 1", "show": [{"file": "builtin:head", "sides": 32, "gloss": 0.1, "round_ends": false}, {"file": "hair_1.xyz", "sides": 5}]}]}
END
filigree panels picture.json -o hair.png
