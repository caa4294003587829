#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Laminar to turbulent: magnitude grows in the wake of a ball.
set -euo pipefail
filigree stylize --style builtin:curls --target builtin:flow:48 --displacement 0.022 --tau 0.5 --columns -o curls.xyz
# The magnitude, 1 in the result, grows behind the ball, the nearer to its axis.
awk '
    function smooth(u) {u = u < 0 ? 0 : u > 1 ? 1 : u; return u * u * (3 - 2 * u)}
    /^# columns/ {for (i = 3; i <= NF; ++i) column[$i] = i - 2}
    /^#/ || NF == 0 {print; next}
    {
        d = column["displacement_0"]; x = $1 - $d; y = $2 - $(d + 1); z = $3 - $(d + 2)
        wake = 0.10 + 0.28 * (x > 0 ? x : 0)
        more = smooth((1.6 * wake - sqrt(y * y + z * z)) / wake) * smooth((x + 0.02) / 0.9) * (0.5 + 0.5 * x) - 1
        for (k = 0; k < 3; ++k) $(k + 1) += more * $(d + k)
        print
    }' curls.xyz > wake.xyz

cat > picture.json <<'END'
{"size": [960, 600], "columns": 1,
 "all": {"camera": [8.5, 12.3], "aim": [[-0.5, -0.36, 0], [1.35, -0.36, 0], [-0.5, 0.36, 0], [1.35, 0.36, 0]], "margin": 1.04, "ground": false},
 "panels": [
  {"title": "Flow lines around a ball, red near its axis", "show": [{"file": "builtin:flow_ball", "sides": 32, "gloss": 0.1, "round_ends": false}, {"file": "builtin:flow:48", "radius_scale": 1.8}]},
  {"title": "Stylized: magnitude grows in the ball's wake", "show": [{"file": "builtin:flow_ball", "sides": 32, "gloss": 0.1, "round_ends": false}, {"file": "wake.xyz", "radius_scale": 1.8}]}]}
END
filigree panels picture.json -o flow.png
