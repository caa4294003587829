#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Eight combinations of operators, one after the other.
set -euo pipefail
cat > flower.json <<'END'
{"operations": [
  {"name": "wedges", "op": "stream", "on": "root", "from": {"stretches": [{"loop": 1}]}, "to": {"stretches": [{"loop": 0}]}, "delta": 0.0576},
  {"name": "dots", "op": "contour", "on": "wedges.background", "from": {"samples": {"radius": 0.034}}, "delta": 0.011, "each": true},
  {"name": "frames", "op": "contour", "on": "wedges.foreground", "from": {"borders": "outer"}, "delta": 0.012, "each": true},
  {"name": "inner", "op": "contour", "on": "frames.background", "from": {"borders": "outer"}, "delta": 0.012, "each": true},
  {"name": "petals", "op": "contour", "on": "inner.background", "from": {"borders": "outer"}, "to": {"samples": {"radius": 0.085}}, "delta": 0.33, "count": 2, "each": true}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "wedges.background", "color": "#162f6c", "roughness": 0.3},
  {"on": "dots.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "inner.foreground", "color": "#a24224", "roughness": 0.36},
  {"on": "petals.part:1", "color": "#657c5d", "roughness": 0.42},
  {"on": "petals.part:2", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:dish flower.json -o flower.glb

cat > cells.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 1}]}, "to": {"stretches": [{"loop": 0}]}, "delta": 0.25, "count": 0},
  {"name": "grid", "op": "stream", "on": "root", "from": {"stretches": [{"loop": 1}]}, "to": {"stretches": [{"loop": 0}]}, "delta": 0.0576},
  {"name": "light", "op": "contour", "on": "grid.light", "from": {"borders": "outer"}, "delta": 0.009, "each": true},
  {"name": "dark", "op": "contour", "on": "grid.dark", "from": {"borders": "outer"}, "delta": 0.009, "each": true},
  {"name": "lace", "op": "contour", "on": "light.background", "from": {"spacing": 0.03}, "delta": 0.013, "count": 2, "each": true},
  {"name": "cells", "op": "voronoi", "on": "dark.background", "from": {"samples": {"radius": 0.035}}, "each": true}],
 "materials": [
  {"on": "default", "color": "#d4cec2", "roughness": 0.35, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "grid.dark", "color": "#125259", "roughness": 0.28},
  {"on": "light.foreground", "color": "#ce8127", "roughness": 0.32},
  {"on": "dark.foreground", "color": "#ce8127", "roughness": 0.32},
  {"on": "lace.part:0", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "lace.part:1", "color": "#ce8127", "roughness": 0.32},
  {"on": "cells.part:1/3", "color": "#277376", "roughness": 0.3},
  {"on": "cells.part:2/3", "color": "#4b9390", "roughness": 0.3}]}
END
filigree tangle builtin:dish cells.json -o cells.glb

for first in 1 2 4; do
    filigree tangle builtin:dish flower.json --first $first -o flower_$first.glb
done
for first in 2 4 5; do
    filigree tangle builtin:dish cells.json --first $first -o cells_$first.glb
done

cat > picture.json <<'END'
{"size": [1600, 760], "columns": 4,
 "all": {"camera": [16.7, 39.2], "margin": 1.07},
 "panels": [
  {"title": "Sunburst", "show": [{"file": "flower_1.glb"}]},
  {"title": "Polka dots", "show": [{"file": "flower_2.glb"}]},
  {"title": "Frames", "show": [{"file": "flower_4.glb"}]},
  {"title": "Flower", "show": [{"file": "flower.glb"}]},
  {"title": "Grid", "show": [{"file": "cells_2.glb"}]},
  {"title": "Outline", "show": [{"file": "cells_4.glb"}]},
  {"title": "Lace", "show": [{"file": "cells_5.glb"}]},
  {"title": "Cells", "show": [{"file": "cells.glb"}]}]}
END
filigree panels picture.json -o tangle_macros.png
