#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Noise on the metric.
set -euo pipefail
cat > noise.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "to": {"stretches": [{"loop": 1}]}, "delta": 0.14286, "count": 0, "perturbation": 0.03, "frequency": 9},
  {"name": "dots", "op": "contour", "on": "bands.background", "from": {"samples": {"radius": 0.09}}, "delta": 0.034, "each": true, "perturbation": 0.03, "frequency": 9}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#162f6c", "roughness": 0.3},
  {"on": "dots.foreground", "color": "#a24224", "roughness": 0.36}]}
END
filigree tangle builtin:vase noise.json -o noise.glb

for amount in 0 0.08; do
    sed "s/\"perturbation\": 0.03/\"perturbation\": $amount/" noise.json > noise_$amount.json
    filigree tangle builtin:vase noise_$amount.json -o noise_$amount.glb
done

cat > picture.json <<'END'
{"size": [1080, 480],
 "all": {"camera": [14.0, 25.9], "margin": 1.07},
 "panels": [
  {"title": "No noise", "show": [{"file": "noise_0.glb"}]},
  {"title": "Noise of 3 cm", "show": [{"file": "noise.glb"}]},
  {"title": "Noise of 8 cm", "show": [{"file": "noise_0.08.glb"}]}]}
END
filigree panels picture.json -o tangle_perturbation.png
