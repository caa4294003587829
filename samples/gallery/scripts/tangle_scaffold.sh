#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A grid places dots and is not seen.
set -euo pipefail
cat > hidden.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.11112, "count": 0, "scaffold": true},
  {"name": "grid", "op": "stream", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.089, "scaffold": true},
  {"name": "dots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.05}, "of": "grid.dark"}, "delta": 0.018}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "grid.dark", "color": "#657c5d", "roughness": 0.42},
  {"on": "dots.foreground", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle builtin:vase hidden.json -o hidden.glb

# With a scaffold that is seen:
sed 's/, "scaffold": true//' hidden.json > seen.json
filigree tangle builtin:vase seen.json --first 2 -o grid.glb
filigree tangle builtin:vase seen.json -o seen.glb

cat > picture.json <<'END'
{"size": [1080, 480],
 "all": {"camera": [14.0, 25.9], "margin": 1.07},
 "panels": [
  {"title": "A grid as a scaffold", "show": [{"file": "grid.glb"}]},
  {"title": "Dots in its dark cells", "show": [{"file": "seen.glb"}]},
  {"title": "The scaffold is not seen", "show": [{"file": "hidden.glb"}]}]}
END
filigree panels picture.json -o tangle_scaffold.png
