#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An L-system draws a tree, with knots on each branch.
set -euo pipefail
filigree stylize --style builtin:knots --target builtin:tree --displacement 0.012 --network --columns -o knots.xyz
cat > picture.json <<'END'
{"size": [960, 500],
 "all": {"camera": [31.0, 5.9], "margin": 1.06, "aim_with": "all"},
 "panels": [
  {"title": "Straight branches", "show": [{"file": "builtin:tree"}]},
  {"title": "Knots along each; forks stay where they were", "show": [{"file": "knots.xyz"}]}]}
END
filigree panels picture.json -o tree.png
