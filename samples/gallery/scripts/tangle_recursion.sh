#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Patterns on patterns.
set -euo pipefail
cat > structured.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.11112, "count": 0},
  {"name": "rims", "op": "contour", "on": "bands.foreground", "from": {"borders": "outer"}, "delta": 0.012, "each": true},
  {"name": "dots", "op": "contour", "on": "rims.background", "from": {"samples": {"radius": 0.075}}, "delta": 0.026, "each": true},
  {"op": "displace", "on": "dots.foreground", "amount": 0.012, "bias": 0.75},
  {"name": "rings", "op": "contour", "on": "dots.foreground", "from": {"borders": "outer"}, "delta": 0.008, "count": 0},
  {"name": "halves", "op": "contour", "on": "bands.background", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.5, "each": true},
  {"name": "squares", "op": "stream", "on": "bands.background", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.055, "each": true},
  {"name": "tiles", "op": "contour", "on": "squares.dark", "from": {"borders": "outer"}, "delta": 0.012, "each": true}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "rims.foreground", "color": "#162f6c", "roughness": 0.3},
  {"on": "rims.background", "color": "#657c5d", "roughness": 0.42},
  {"on": "rings.foreground", "color": "#a24224", "roughness": 0.36},
  {"on": "rings.background", "color": "#cec0a8", "roughness": 0.42},
  {"on": "squares.dark", "color": "#162f6c", "roughness": 0.3},
  {"on": "tiles.background", "color": "#cec0a8", "roughness": 0.42}]}
END
filigree tangle builtin:vase structured.json -o structured.glb

cat > crusted.json <<'END'
{"operations": [
  {"name": "two", "op": "contour", "on": "root", "from": {"borders": "outer"}, "delta": 0.085},
  {"name": "small", "op": "voronoi", "on": "two.foreground", "from": {"samples": {"radius": 0.042}}, "each": true},
  {"name": "large", "op": "voronoi", "on": "two.background", "from": {"samples": {"radius": 0.09}}, "each": true},
  {"name": "pebbles", "op": "contour", "on": "small.regions", "from": {"borders": "each"}, "delta": 0.005},
  {"name": "stones", "op": "contour", "on": "large.regions", "from": {"borders": "each"}, "delta": 0.007},
  {"op": "displace", "on": "pebbles.background", "amount": 0.016, "bias": 0.75},
  {"op": "displace", "on": "stones.background", "amount": 0.03, "bias": 0.75}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35},
  {"on": "pebbles.background", "color": "#125259", "roughness": 0.28},
  {"on": "stones.background", "color": "#ce8127", "roughness": 0.32}]}
END
filigree tangle builtin:dish crusted.json -o crusted.glb

filigree mesh repair builtin:ball --weld 1e-6 -o ball.ply
cat > parity.json <<'END'
{"operations": [
  {"name": "cells", "op": "voronoi", "on": "root", "from": {"samples": {"radius": 0.3}}},
  {"name": "rings", "op": "contour", "on": "cells.regions", "from": {"borders": "outer"}, "delta": 0.026, "count": 0, "each": true},
  {"name": "across", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.4}}, "delta": 0.055, "count": 0}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "across.dark", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle ball.ply parity.json -o parity.glb

cat > picture.json <<'END'
{"size": [1260, 480],
 "all": {"margin": 1.07},
 "panels": [
  {"title": "Stripes and a grid carry dots and frames", "camera": [14.0, 25.9], "show": [{"file": "structured.glb"}]},
  {"title": "Cells, raised", "camera": [16.7, 39.2], "show": [{"file": "crusted.glb"}]},
  {"title": "Rings across rings, chequered", "camera": [14.0, 25.9], "show": [{"file": "parity.glb"}]}]}
END
filigree panels picture.json -o tangle_recursion.png
