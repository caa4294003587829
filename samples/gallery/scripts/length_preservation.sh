#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# With and without length preservation.
set -euo pipefail
filigree stylize --style builtin:curls --target builtin:s_curve --displacement 0.045 -o bent.xyz
awk 'BEGIN {for (i = -50; i <= 50; ++i) {x = 0.016 * i; print x, -0.4 * x * x, 0}}' > arch.xyz
filigree stylize --style bent.xyz --target arch.xyz --scale 1 --save-guide kept_guide.xyz -o kept.xyz
filigree stylize --style bent.xyz --alpha 0 --target arch.xyz --scale 1 --save-guide cut_guide.xyz -o cut.xyz
cat > picture.json <<'END'
{"size": [960, 540], "columns": 2,
 "all": {"camera": [11.3, 6.7]},
 "panels": [
  {"title": "Length preserved: the guide keeps the bends", "show": [{"file": "bent.xyz", "color": "#959597", "radius": 0.004}, {"file": "kept_guide.xyz", "color": "#197c79", "radius": 0.01}]},
  {"title": "Not preserved: it cuts them short", "show": [{"file": "bent.xyz", "color": "#959597", "radius": 0.004}, {"file": "cut_guide.xyz", "color": "#d43527", "radius": 0.01}]},
  {"title": "The result on an arch", "show": [{"file": "kept.xyz", "color": "#197c79", "radius": 0.007}]},
  {"title": "The result on an arch: bends come back", "show": [{"file": "cut.xyz", "color": "#d43527", "radius": 0.007}]}]}
END
filigree panels picture.json -o length_preservation.png
