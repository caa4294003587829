#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Frames that the host supplies: the normals of a ball.
set -euo pipefail
# A spiral on a ball, with the normals of the ball.
awk 'BEGIN {
    print "# columns x y z nx ny nz"
    for (i = 0; i < 600; ++i) {
        u = (i + 0.5) / 600; b = 2.6 * (u - 0.5); a = 38 * u; x = cos(b) * cos(a); y = -sin(b); z = cos(b) * sin(a)
        print 0.129 * x, 0.129 * y, 0.129 * z, x, y, z
    }
}' > spiral.xyz
filigree stylize --style builtin:loops --target spiral.xyz --displacement 0.012 -o lean.xyz
filigree stylize --style builtin:loops --target spiral.xyz --displacement 0.012 --frame supplied -o stand.xyz
cat > picture.json <<'END'
{"size": [960, 480],
 "all": {"camera": [11.3, 41.4], "aim_with": "all"},
 "panels": [
  {"title": "Rotation-minimizing frames: loops lean", "show": [{"file": "lean.xyz", "color": "#d43527", "radius": 0.0016}, {"file": "builtin:flow_ball", "sides": 32, "gloss": 0.1, "round_ends": false}]},
  {"title": "The normals of the ball: loops stand", "show": [{"file": "stand.xyz", "color": "#197c79", "radius": 0.0016}, {"file": "builtin:flow_ball", "sides": 32, "gloss": 0.1, "round_ends": false}]}]}
END
filigree panels picture.json -o supplied.png
