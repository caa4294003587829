#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Each style of the library on one wave.
set -euo pipefail
awk 'BEGIN {for (i = 0; i <= 200; ++i) {x = 0.006 * i; print x, 0.09 * sin(6.5 * x), 0.04 * cos(3 * x)}}' > target.xyz
colors=(273555 197c79 8c3b2a 5b3f7a 2f6b35 8a6414)
panels= number=0
for style in $(filigree styles | awk '{print $1}'); do
    filigree stylize --style "builtin:$style" --attributes radius --target target.xyz --scale 1 -o "$style.xyz"
    look="\"color\": \"#${colors[$((number++ % 6))]}\""
    # What it is about besides the shape.
    case $style in
        beads) look='"radius_scale": 1.3, "color": "#8c1f17"' ;;
        twist) filigree stylize --style builtin:twist --attributes angle,radius,color --target target.xyz --scale 1 --columns -o twist.xyz
               look='"as": "ribbon"' ;;
    esac
    panels+="${panels:+, }{\"title\": \"$style\", \"show\": [{\"file\": \"$style.xyz\", $look}]}"
done
echo "{\"size\": [1200, 1000], \"columns\": 4,
 \"all\": {\"camera\": [0.0, 8.0], \"margin\": 1.05, \"ground\": false, \"aim_with\": \"all\"},
 \"panels\": [$panels]}" > picture.json
filigree panels picture.json -o library.png
