#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A network, without and with its ends pinned.
set -euo pipefail
filigree stylize --style builtin:braid --target builtin:icosahedron --displacement 0.026 --network -o pinned.xyz
filigree stylize --style builtin:braid --target builtin:icosahedron --displacement 0.026 -o loose.xyz
filigree stylize --style builtin:braid --target builtin:icosahedron --scale 1 --sigma 0 -o network.xyz
# A ball, a tube without length, at each joint; and the joint nearest to the eye, which looks along (-0.2, -0.35, -1).
awk '
    function ends() {
        if (n == 0) return
        for (k = 0; k < 2; ++k) {
            split(k ? last : first, p, " "); print p[1], p[2], p[3] "\n" p[1] + 1e-5, p[2], p[3] "\n"
            depth = -0.2 * p[1] - 0.35 * p[2] - p[3]
            if (nearest == "" || depth < least) {least = depth; nearest = k ? last : first}
        }
        n = 0
    }
    /^#/ {next}
    NF == 0 {ends(); next}
    {if (n++ == 0) first = $1 " " $2 " " $3; last = $1 " " $2 " " $3}
    END {ends(); split(nearest, p, " "); print p[1], p[2], p[3] "\n" p[1] + 1e-5, p[2], p[3] > "joint.xyz"}' network.xyz > joints.xyz
read -r x y z < joint.xyz
# The curves of the network that meet in it.
number=$(awk -v x="$x" -v y="$y" -v z="$z" '
    function near(p) {split(p, q, " "); return (q[1] - x) ^ 2 + (q[2] - y) ^ 2 + (q[3] - z) ^ 2 < 1e-8}
    function ends() {if (n > 0) {if (near(first) || near(last)) printf "%d ", curve; ++curve; n = 0}}
    /^#/ {next}
    NF == 0 {ends(); next}
    {if (n++ == 0) first = $1 " " $2 " " $3; last = $1 " " $2 " " $3}
    END {ends()}' network.xyz)
for name in network loose pinned; do
    awk -v numbers="$number" '
        BEGIN {split(numbers, list, " "); for (i in list) wanted[list[i]]}
        /^#/ {next}
        NF == 0 {if (n > 0) {++curve; print ""} n = 0; next}
        {++n; if (curve + 0 in wanted) print $1, $2, $3}' $name.xyz > near_$name.xyz
done
aim=$(awk -v x="$x" -v y="$y" -v z="$z" 'BEGIN {
    for (i = 0; i < 8; ++i) {
        printf "%s[%.4f, %.4f, %.4f]", i ? ", " : "[", x + (i % 2 ? 0.075 : -0.075), y + (i % 4 < 2 ? 0.075 : -0.075), \
            z + (i < 4 ? 0.075 : -0.075)
    }
    print "]"
}')
cat > picture.json <<END
{"size": [960, 600], "columns": 3,
 "all": {"camera": [11.3, 18.9]},
 "panels": [
  {"title": "A network", "aim_with": "above", "show": [{"file": "network.xyz", "color": "#197c79", "radius": 0.0045}, {"file": "joints.xyz", "color": "#eda230", "radius": 0.011}]},
  {"title": "Loose ends miss the joints", "aim_with": "above", "show": [{"file": "loose.xyz", "color": "#d43527", "radius": 0.0045}, {"file": "joints.xyz", "color": "#eda230", "radius": 0.011}]},
  {"title": "Pinned ends meet in them", "aim_with": "above", "show": [{"file": "pinned.xyz", "color": "#197c79", "radius": 0.0045}, {"file": "joints.xyz", "color": "#eda230", "radius": 0.011}]},
  {"ground": false, "aim": $aim, "show": [{"file": "joint.xyz", "color": "#eda230", "radius": 0.008}, {"file": "near_network.xyz", "color": "#197c79", "radius": 0.003}]},
  {"ground": false, "aim": $aim, "show": [{"file": "joint.xyz", "color": "#eda230", "radius": 0.008}, {"file": "near_loose.xyz", "color": "#d43527", "radius": 0.003}]},
  {"ground": false, "aim": $aim, "show": [{"file": "joint.xyz", "color": "#eda230", "radius": 0.008}, {"file": "near_pinned.xyz", "color": "#197c79", "radius": 0.003}]}]}
END
filigree panels picture.json -o icosahedron.png
