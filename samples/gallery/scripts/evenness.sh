#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Matching by closeness, as usual, and by evenness alone.
set -euo pipefail
# A line with spikes, and an arc.
awk '
    function to(u, v) {
        steps = int(sqrt((u - x) ^ 2 + (v - y) ^ 2) / 0.002) + 1
        for (k = 0; k < steps; ++k) print x + (u - x) * k / steps, y + (v - y) * k / steps, 0
        x = u; y = v
    }
    BEGIN {
        n = split("0.10 0.13 0.09 0.14 0.11 0.12 0.09 0.13", height, " ")
        for (i = 1; i <= n; ++i) {middle = 0.1 * (i - 0.5); to(middle - 0.014, 0); to(middle, height[i]); to(middle + 0.014, 0)}
        to(0.1 * n, 0)
    }' > spikes.xyz
awk 'BEGIN {for (i = 0; i <= 200; ++i) {a = 0.028 * i; print 0.12 * cos(a), 0.12 * sin(a), 0}}' > arc.xyz
filigree stylize --style spikes.xyz --beta 0.9 --target arc.xyz --scale 1 -o close.xyz
filigree stylize --style spikes.xyz --target arc.xyz --scale 1 -o usual.xyz
filigree stylize --style spikes.xyz --beta 0.0001 --target arc.xyz --scale 1 -o even.xyz
cat > picture.json <<'END'
{"size": [960, 330], "columns": 3,
 "all": {"camera": [0.0, 5.7], "ground": false, "aim_with": "all"},
 "panels": [
  {"title": "Closeness: spikes are kept", "show": [{"file": "close.xyz", "color": "#197c79", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]},
  {"title": "Default: kept as well", "show": [{"file": "usual.xyz", "color": "#197c79", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]},
  {"title": "Evenness alone: spikes bulge", "show": [{"file": "even.xyz", "color": "#d43527", "radius": 0.0035}, {"file": "arc.xyz", "color": "#959597", "radius": 0.0015}]}]}
END
filigree panels picture.json -o evenness.png
