#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Six patterns on a cloth.
set -euo pipefail
cat > outline.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"borders": "outer"}, "delta": 0.05, "count": 9}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#162f6c", "roughness": 0.3},
  {"on": "bands.background", "color": "#cec0a8", "roughness": 0.42}]}
END
filigree tangle builtin:cloth outline.json -o outline.glb

cat > hatch.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0.75, "end": 1}]}, "delta": 0.0625, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#a24224", "roughness": 0.36}]}
END
filigree tangle builtin:cloth hatch.json -o hatch.glb

cat > grid.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0.75, "end": 1}]}, "delta": 0.125, "count": 0},
  {"name": "squares", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0, "end": 0.25}]}, "delta": 0.125, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "squares.dark", "color": "#657c5d", "roughness": 0.42}]}
END
filigree tangle builtin:cloth grid.json -o grid.glb

cat > dots.json <<'END'
{"operations": [
  {"name": "dots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.115}}, "delta": 0.042}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "dots.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "dots.background", "color": "#cec0a8", "roughness": 0.42}]}
END
filigree tangle builtin:cloth dots.json -o dots.glb

cat > cells.json <<'END'
{"operations": [
  {"name": "cells", "op": "voronoi", "on": "root", "from": {"samples": {"radius": 0.15}}}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "cells.part:0/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:1/12", "color": "#cec0a8", "roughness": 0.42},
  {"on": "cells.part:2/12", "color": "#657c5d", "roughness": 0.42},
  {"on": "cells.part:3/12", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:4/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:5/12", "color": "#cec0a8", "roughness": 0.42},
  {"on": "cells.part:6/12", "color": "#657c5d", "roughness": 0.42},
  {"on": "cells.part:7/12", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:8/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:9/12", "color": "#cec0a8", "roughness": 0.42},
  {"on": "cells.part:10/12", "color": "#657c5d", "roughness": 0.42},
  {"on": "cells.part:11/12", "color": "#125259", "roughness": 0.28}]}
END
filigree tangle builtin:cloth cells.json -o cells.glb

cat > rays.json <<'END'
{"operations": [
  {"name": "disc", "op": "contour", "on": "root", "from": {"points": [[0.5, 0, 0.5]]}, "delta": 0.09},
  {"name": "rays", "op": "stream", "on": "disc.background", "from": {"stretches": [{"loop": 1}]}, "delta": 0.0236}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "disc.foreground", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "rays.foreground", "color": "#ce8127", "roughness": 0.32},
  {"on": "rays.background", "color": "#cec0a8", "roughness": 0.42}]}
END
filigree tangle builtin:cloth rays.json -o rays.glb

cat > picture.json <<'END'
{"size": [1440, 250],
 "all": {"camera": [8.1, 70.5], "margin": 1.07},
 "panels": [
  {"title": "Outline", "show": [{"file": "outline.glb"}]},
  {"title": "Hatch", "show": [{"file": "hatch.glb"}]},
  {"title": "Grid", "show": [{"file": "grid.glb"}]},
  {"title": "Polka dots", "show": [{"file": "dots.glb"}]},
  {"title": "Voronoi", "show": [{"file": "cells.glb"}]},
  {"title": "Radial", "show": [{"file": "rays.glb"}]}]}
END
filigree panels picture.json -o tangle_patterns.png
