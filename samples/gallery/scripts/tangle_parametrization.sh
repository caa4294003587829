#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Dots and stripes by textures, and by distances on the surface.
set -euo pipefail
filigree mesh repair builtin:vase:960 -o vase.obj
# A texture on the vase, by the middles of its triangles: u around, 0 to 1 from a seam in front; v up, in the same unit.
textured() {  # NAME AROUND dots|stripes
    awk -v around="$2" -v kind="$3" '
        function floor(t) {return t < 0 ? int(t) - (t != int(t)) : int(t)}
        function in_dots(u, v) {
            row = floor(v * around); p = u * around + (row % 2 == 0 ? 0 : 0.5); p -= floor(p) + 0.5
            q = v * around - row - 0.5; return sqrt(p * p + q * q) < 0.33
        }
        function in_stripes(u, v) {p = (u + 0.8 * v) * around; return p - floor(p) < 0.5}
        $1 == "v" {x[++n] = $2; y[n] = $3; z[n] = $4; line[n] = $2 " " $3 " " $4}
        $1 == "f" {
            ++faces
            a = (x[$2] + x[$3] + x[$4]) / 3; b = (y[$2] + y[$3] + y[$4]) / 3; c = (z[$2] + z[$3] + z[$4]) / 3
            u = atan2(a - 0.25 * c, c + 0.25 * a) / 6.2831853; if (u < 0) u += 1
            v = b / (6.2831853 * 0.25)
            face[faces] = "3 " $2 - 1 " " $3 - 1 " " $4 - 1 " " (kind == "dots" ? in_dots(u, v) : in_stripes(u, v))
        }
        END {
            print "ply\nformat ascii 1.0\nelement vertex " n "\nproperty float x\nproperty float y\nproperty float z"
            print "element face " faces "\nproperty list uchar int vertex_indices\nproperty int region\nend_header"
            for (i = 1; i <= n; ++i) print line[i]
            for (i = 1; i <= faces; ++i) print face[i]
        }' vase.obj > "$1.ply"
}
# As many around as their size asks for, and as many as join.
textured cut_dots 11.37 dots
textured closed_dots 11 dots
textured cut_stripes 11.37 stripes
textured closed_stripes 11 stripes

cat > dots.json <<'END'
{"operations": [
  {"name": "dots", "op": "contour", "on": "root", "from": {"samples": {"radius": 0.13}}, "delta": 0.048}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42},
  {"on": "dots.foreground", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:vase dots.json -o dots.glb

cat > stripes.json <<'END'
{"operations": [
  {"name": "bands", "op": "contour", "on": "root", "from": {"points": [[0.35, 0.3, 0.2]]}, "delta": 0.085, "count": 0}],
 "materials": [
  {"on": "default", "color": "#cec0a8", "roughness": 0.42},
  {"on": "bands.background", "color": "#162f6c", "roughness": 0.3}]}
END
filigree tangle builtin:vase stripes.json -o stripes.glb

cat > picture.json <<'END'
{"size": [960, 860], "columns": 3,
 "all": {"camera": [14.0, 21.2], "margin": 1.05},
 "panels": [
  {"title": "A texture: cut at a seam", "show": [{"file": "cut_dots.ply", "regions": [{"color": "#cec0a8", "roughness": 0.42}, {"color": "#162f6c", "roughness": 0.3}], "border": 0}]},
  {"title": "A closed one: stretched", "show": [{"file": "closed_dots.ply", "regions": [{"color": "#cec0a8", "roughness": 0.42}, {"color": "#162f6c", "roughness": 0.3}], "border": 0}]},
  {"title": "By distance: round everywhere", "show": [{"file": "dots.glb"}]},
  {"title": "Stripes break at the seam", "show": [{"file": "cut_stripes.ply", "regions": [{"color": "#cec0a8", "roughness": 0.42}, {"color": "#162f6c", "roughness": 0.3}], "border": 0}]},
  {"title": "Stripes widen with the vase", "show": [{"file": "closed_stripes.ply", "regions": [{"color": "#cec0a8", "roughness": 0.42}, {"color": "#162f6c", "roughness": 0.3}], "border": 0}]},
  {"title": "By distance: one width", "show": [{"file": "stripes.glb"}]}]}
END
filigree panels picture.json -o tangle_parametrization.png
