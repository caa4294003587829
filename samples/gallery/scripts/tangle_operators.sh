#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Twelve uses of the four operators.
set -euo pipefail
cat > once.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 1}]}, "delta": 0.12}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:dish once.json -o once.glb

cat > four.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 1}]}, "delta": 0.045, "count": 4}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:dish four.json -o four.glb

cat > between.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 1}]}, "to": {"stretches": [{"loop": 0}]}, "delta": 0.1, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:dish between.json -o between.glb

cat > samples.json <<'END'
{"operations": [
  {"name": "dots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.1}}, "delta": 0.033}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "dots.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "dots.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:dish samples.json -o samples.glb

cat > sides.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0.75, "end": 1}]}, "to": {"stretches": [{"loop": 0, "begin": 0.25, "end": 0.5}]}, "delta": 0.125, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "bands.foreground", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:cloth sides.json -o sides.glb

cat > squares.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0.75, "end": 1}]}, "to": {"stretches": [{"loop": 0, "begin": 0.25, "end": 0.5}]}, "delta": 0.125, "count": 0},
  {"name": "squares", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0, "begin": 0, "end": 0.25}]}, "to": {"stretches": [{"loop": 0, "begin": 0.5, "end": 0.75}]}, "delta": 0.125, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "squares.dark", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:cloth squares.json -o squares.glb

cat > streams.json <<'END'
{"operations": [
  {"name": "strips", "op": "stream", "on": "root", "from": {"stretches": [{"loop": 1}]}, "delta": 0.0346}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "strips.foreground", "color": "#d4cec2", "roughness": 0.35},
  {"on": "strips.background", "color": "#125259", "roughness": 0.28}]}
END
filigree tangle builtin:dish streams.json -o streams.glb

cat > strips.json <<'END'
{"operations": [
  {"name": "strips", "op": "stream", "on": "root", "from": {"stretches": [{"loop": 1}]}, "to": {"stretches": [{"loop": 0}]}, "delta": 0.0346}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "strips.foreground", "color": "#d4cec2", "roughness": 0.35},
  {"on": "strips.background", "color": "#125259", "roughness": 0.28}]}
END
filigree tangle builtin:dish strips.json -o strips.glb

cat > sampled.json <<'END'
{"operations": [
  {"name": "cells", "op": "voronoi", "on": "root", "from": {"samples": {"radius": 0.12}}}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "cells.part:0/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:1/12", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:2/12", "color": "#ce8127", "roughness": 0.32},
  {"on": "cells.part:3/12", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "cells.part:4/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:5/12", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:6/12", "color": "#ce8127", "roughness": 0.32},
  {"on": "cells.part:7/12", "color": "#5d1d3c", "roughness": 0.3},
  {"on": "cells.part:8/12", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:9/12", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:10/12", "color": "#ce8127", "roughness": 0.32},
  {"on": "cells.part:11/12", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle builtin:dish sampled.json -o sampled.glb

cat > picked.json <<'END'
{"operations": [
  {"name": "cells", "op": "voronoi", "on": "root", "from": {"points": [[0.34, 0.22, 0.0], [0.211, 0.22, 0.266], [-0.077, 0.22, 0.331], [-0.307, 0.22, 0.145], [-0.305, 0.22, -0.15], [-0.072, 0.22, -0.332], [0.216, 0.22, -0.263]]}}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "cells.part:0/4", "color": "#d4cec2", "roughness": 0.35},
  {"on": "cells.part:1/4", "color": "#125259", "roughness": 0.28},
  {"on": "cells.part:2/4", "color": "#ce8127", "roughness": 0.32},
  {"on": "cells.part:3/4", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle builtin:dish picked.json -o picked.glb

cat > closed.json <<'END'
{"operations": [
  {"name": "pieces", "op": "polyline", "on": "root", "from": {"points": [[0.4, 0.2, 0.0], [0.178, 0.2, 0.129], [0.124, 0.2, 0.38], [-0.068, 0.2, 0.209], [-0.324, 0.2, 0.235], [-0.22, 0.2, 0.0], [-0.324, 0.2, -0.235], [-0.068, 0.2, -0.209], [0.124, 0.2, -0.38], [0.178, 0.2, -0.129]]}, "closed": true}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "pieces.foreground", "color": "#ce8127", "roughness": 0.32},
  {"on": "pieces.background", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle builtin:dish closed.json -o closed.glb

cat > open.json <<'END'
{"operations": [
  {"name": "pieces", "op": "polyline", "on": "root", "from": {"points": [[-0.5, 0, 0], [-0.2, 0.23, 0.2], [0.25, 0.22, 0.22], [0.46, 0, -0.2]]}, "closed": false}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42, "border": {"width": 1.25, "color": "#272c38"}},
  {"on": "pieces.foreground", "color": "#ce8127", "roughness": 0.32},
  {"on": "pieces.background", "color": "#5d1d3c", "roughness": 0.3}]}
END
filigree tangle builtin:dish open.json -o open.glb

cat > picture.json <<'END'
{"size": [1280, 720], "columns": 4,
 "all": {"camera": [16.7, 39.2], "margin": 1.07},
 "panels": [
  {"title": "Contour: once from the hole", "show": [{"file": "once.glb"}]},
  {"title": "Four times from the hole", "show": [{"file": "four.glb"}]},
  {"title": "From hole to rim", "show": [{"file": "between.glb"}]},
  {"title": "Around samples", "show": [{"file": "samples.glb"}]},
  {"title": "From side to side", "show": [{"file": "sides.glb"}]},
  {"title": "and across", "show": [{"file": "squares.glb"}]},
  {"title": "Stream from the hole", "show": [{"file": "streams.glb"}]},
  {"title": "Stream, hole to rim", "show": [{"file": "strips.glb"}]},
  {"title": "Cells of samples", "show": [{"file": "sampled.glb"}]},
  {"title": "Cells of picked points", "show": [{"file": "picked.glb"}]},
  {"title": "Polyline: closed", "show": [{"file": "closed.glb"}]},
  {"title": "Polyline: rim to rim", "show": [{"file": "open.glb"}]}]}
END
filigree panels picture.json -o tangle_operators.png
