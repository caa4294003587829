#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What bias and gain make of displaced dots.
set -euo pipefail
filigree mesh repair builtin:ball --weld 1e-6 -o ball.ply

cat > straight.json <<'END'
{"operations": [
  {"name": "spots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.26}}, "delta": 0.115},
  {"op": "displace", "on": "spots.foreground", "amount": 0.12, "bias": 0.5},
  {"name": "rings", "op": "contour", "on": "spots.foreground", "from": {"borders": "outer"}, "delta": 0.03, "count": 0}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35},
  {"on": "rings.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "rings.background", "color": "#ce8127", "roughness": 0.32}]}
END
filigree tangle ball.ply straight.json -o straight.glb

cat > bias_85.json <<'END'
{"operations": [
  {"name": "spots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.26}}, "delta": 0.115},
  {"op": "displace", "on": "spots.foreground", "amount": 0.09, "bias": 0.85},
  {"name": "rings", "op": "contour", "on": "spots.foreground", "from": {"borders": "outer"}, "delta": 0.03, "count": 0}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35},
  {"on": "rings.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "rings.background", "color": "#ce8127", "roughness": 0.32}]}
END
filigree tangle ball.ply bias_85.json -o bias_85.glb

cat > bias_22.json <<'END'
{"operations": [
  {"name": "spots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.26}}, "delta": 0.115},
  {"op": "displace", "on": "spots.foreground", "amount": 0.24, "bias": 0.22},
  {"name": "rings", "op": "contour", "on": "spots.foreground", "from": {"borders": "outer"}, "delta": 0.03, "count": 0}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35},
  {"on": "rings.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "rings.background", "color": "#ce8127", "roughness": 0.32}]}
END
filigree tangle ball.ply bias_22.json -o bias_22.glb

cat > gain_12.json <<'END'
{"operations": [
  {"name": "spots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.26}}, "delta": 0.115},
  {"op": "displace", "on": "spots.foreground", "amount": 0.12, "bias": 0.5, "gain": 0.12},
  {"name": "rings", "op": "contour", "on": "spots.foreground", "from": {"borders": "outer"}, "delta": 0.03, "count": 0}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35},
  {"on": "rings.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "rings.background", "color": "#ce8127", "roughness": 0.32}]}
END
filigree tangle ball.ply gain_12.json -o gain_12.glb

cat > picture.json <<'END'
{"size": [1280, 340],
 "all": {"camera": [14.0, 25.9], "margin": 1.07},
 "panels": [
  {"title": "Straight", "show": [{"file": "straight.glb"}]},
  {"title": "Bias 0.85", "show": [{"file": "bias_85.glb"}]},
  {"title": "Bias 0.22", "show": [{"file": "bias_22.glb"}]},
  {"title": "Gain 0.12", "show": [{"file": "gain_12.glb"}]}]}
END
filigree panels picture.json -o tangle_displacement.png
