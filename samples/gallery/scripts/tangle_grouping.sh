#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Dots in each stripe, and on all together.
set -euo pipefail
cat > each.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.11112, "count": 0},
  {"name": "dots", "op": "contour", "on": "bands.background", "from": {"samples": {"radius": 0.065}}, "delta": 0.022, "each": true}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#a24224", "roughness": 0.36},
  {"on": "dots.foreground", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:vase each.json -o each.glb

filigree tangle builtin:vase each.json --first 1 -o stripes.glb

cat > together.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.11112, "count": 0},
  {"name": "dots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.065}}, "delta": 0.022}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#a24224", "roughness": 0.36},
  {"on": {"of": "dots.foreground", "in": "bands.foreground"}, "color": "#cec0a8", "roughness": 0.42},
  {"on": {"of": "dots.foreground", "in": "bands.background"}, "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:vase together.json -o together.glb

cat > picture.json <<'END'
{"size": [1080, 480],
 "all": {"camera": [14.0, 25.9], "margin": 1.07},
 "panels": [
  {"title": "Stripes", "show": [{"file": "stripes.glb"}]},
  {"title": "Dots in each light stripe", "show": [{"file": "each.glb"}]},
  {"title": "Dots on all together", "show": [{"file": "together.glb"}]}]}
END
filigree panels picture.json -o tangle_grouping.png
