#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Matching by closeness, as usual, and by evenness alone, of a style with all of its length in the middle.
set -euo pipefail
# A line with spikes in its middle, the line without them as its guide, and an arc.
awk '
    function to(u, v) {
        steps = int(sqrt((u - x) ^ 2 + (v - y) ^ 2) / 0.002) + 1
        for (k = 0; k < steps; ++k) print x + (u - x) * k / steps, y + (v - y) * k / steps, 0
        x = u; y = v
    }
    BEGIN {
        n = split("0 0 0.079 0.068 0.081 0.064 0 0", height, " ")
        for (i = 1; i <= n; ++i) if (height[i] > 0) {middle = 0.1 * (i - 0.5); to(middle - 0.02, 0); to(middle, height[i]); to(middle + 0.02, 0)}
        to(0.1 * n, 0)
    }' > spikes.xyz
awk 'BEGIN {for (i = 0; i <= 200; ++i) print 0.004 * i, 0, 0}' > line.xyz
awk 'BEGIN {for (i = 0; i <= 200; ++i) {a = 0.0308 * i; print 0.13 * cos(a), 0.13 * sin(a), 0}}' > arc.xyz
filigree stylize --style spikes.xyz --guide line.xyz --beta 0.9 --target arc.xyz --scale 1 -o close.xyz
filigree stylize --style spikes.xyz --guide line.xyz --target arc.xyz --scale 1 -o usual.xyz
filigree stylize --style spikes.xyz --guide line.xyz --beta 0.0001 --target arc.xyz --scale 1 -o even.xyz
cat > picture.json <<'END'
{"size": [960, 330], "columns": 3,
 "all": {"camera": [0.0, 5.7], "ground": false, "aim_with": "all"},
 "panels": [
  {"title": "Closeness: plain parts stay on the line", "show": [{"file": "close.xyz", "color": "#197c79", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]},
  {"title": "Default", "show": [{"file": "usual.xyz", "color": "#197c79", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]},
  {"title": "Evenness alone: they leave it, spikes lean", "show": [{"file": "even.xyz", "color": "#d43527", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]}]}
END
filigree panels picture.json -o evenness.png
