#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A pattern made in a plane, and on the surface.
set -euo pipefail
cat > own.json <<'END'
{"operations": [
  {"name": "rim", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "delta": 0.03, "count": 3},
  {"name": "dots", "op": "contour", "on": "rim.part:3", "from": {"samples": {"radius": 0.085}}, "delta": 0.03},
  {"name": "rings", "op": "contour", "on": "dots.foreground", "from": {"borders": "outer"}, "delta": 0.01, "each": true}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "rim.foreground", "color": "#a24224", "roughness": 0.36},
  {"on": "dots.foreground", "color": "#162f6c", "roughness": 0.3},
  {"on": "rings.background", "color": "#657c5d", "roughness": 0.42}]}
END
filigree tangle builtin:dish own.json -o own.glb

# The dish pressed (nearly) flat, tangled, and raised again.
filigree mesh repair builtin:dish -o dish.obj
awk '$1 == "v" {$3 *= 1e-4} {print}' dish.obj > flat.obj
filigree tangle flat.obj own.json -o pressed.obj
awk '$1 == "v" {$3 *= 1e4} {print}' pressed.obj > plane.obj

cat > picture.json <<'END'
{"size": [960, 330],
 "all": {"camera": [11.3, 20.4], "margin": 1.05},
 "panels": [
  {"title": "Made in a plane, laid on: stretched", "show": [{"file": "plane.obj", "regions": [{"color": "#a24224", "roughness": 0.36}, {"color": "#cec0a8", "roughness": 0.42}, {"color": "#162f6c", "roughness": 0.3}, {"color": "#657c5d", "roughness": 0.42}], "border": 1.25, "border_color": "#272c38"}]},
  {"title": "Made on the surface: even", "show": [{"file": "own.glb"}]}]}
END
filigree panels picture.json -o tangle_plane.png
