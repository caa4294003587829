#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Strokes before and after.
set -euo pipefail
filigree stylize --style builtin:loops --target builtin:bouquet --displacement 0.020 --columns -o styled.xyz
cat > picture.json <<'END'
{"size": [960, 540],
 "all": {"aim_with": "all", "camera": [24.2, 11.3]},
 "panels": [
  {"title": "Plain strokes", "show": [{"file": "builtin:bouquet"}]},
  {"title": "The same strokes in one style", "show": [{"file": "styled.xyz", "radius_scale": 0.25}]}]}
END
filigree panels picture.json -o strokes.png
