#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The patch graph of a style, laid out by springs: points that may follow one another come to lie near each other.
set -euo pipefail
# Displacements in the guide's frame: what the style puts on its own guide, point by point.
filigree stylize --style builtin:loops --points 260 --target builtin:loops --sigma 0 --scale 1 -o any.xyz --save-guide guide.xyz
filigree stylize --style builtin:loops --points 260 --target guide.xyz --scale 1 --start style --columns -o style.xyz
awk '
    function cost(i, c,   k, sum, a, b, d) {
        sum = 0
        for (k = -p; k <= p; ++k) {a = t[i + k] - t[c + k]; b = n[i + k] - n[c + k]; d = s[i + k] - s[c + k]; sum += a * a + b * b + d * d}
        return sqrt(sum)
    }
    # From blue over green and yellow to red along the style.
    function hue(u, at) {return 0.03 + 0.8 * exp(-((u - at) / 0.24) ^ 2)}
    function color(i) {return sprintf("%.3f %.3f %.3f 1", hue(i / N, 1), hue(i / N, 0.55), hue(i / N, 0.1))}
    function edge(i, j, width, paint, file) {
        printf "%.6f %.6f %.6f %.6f %s\n%.6f %.6f %.6f %.6f %s\n\n", x[i], y[i], z[i], width, paint ? "0.32 0.33 0.36 1" : color(i), x[j], y[j], z[j], width, paint ? "0.32 0.33 0.36 1" : color(j) > file
    }
    /^# columns/ {for (i = 3; i <= NF; ++i) at[$i] = i - 2; next}
    /^#/ || NF == 0 {next}
    {
        dx = $at["displacement_0"]; dy = $at["displacement_1"]; dz = $at["displacement_2"]
        tx = $at["tangent_0"]; ty = $at["tangent_1"]; tz = $at["tangent_2"]
        nx = $at["nx"]; ny = $at["ny"]; nz = $at["nz"]
        t[N] = dx * tx + dy * ty + dz * tz; n[N] = dx * nx + dy * ny + dz * nz
        s[N] = dx * (ty * nz - tz * ny) + dy * (tz * nx - tx * nz) + dz * (tx * ny - ty * nx)
        x[N] = $1; y[N] = $2; z[N] = 0; ++N
    }
    END {
        p = 10
        # Of each point the jumps that are local minima of its row, the three cheapest.
        for (i = p; i < N - p; ++i) {
            for (c = p; c < N - p; ++c) r[c] = cost(i, c)
            kept = 0
            for (c = p + 1; c < N - p - 1; ++c) {
                if (c > i - p && c < i + p || r[c] > r[c - 1] || r[c] > r[c + 1]) continue
                for (k = kept < 3 ? kept++ : 3; k > 0 && best[k - 1] > r[c]; --k) if (k < 3) {best[k] = best[k - 1]; to[k] = to[k - 1]}
                if (k < 3) {best[k] = r[c]; to[k] = c + 1}
            }
            for (k = 0; k < kept; ++k) {from[E] = i; into[E] = to[k]; rho[E] = best[k]; mean += best[k]; ++E}
        }
        mean /= E
        for (e = 0; e < E; ++e) weight[e] = exp(-2.5 * rho[e] / mean)
        # Springs draw the ends of an edge together, the stronger the cheaper it is; points push each other away.
        srand(1)
        for (i = 0; i < N; ++i) {x[i] = 4 * i / N - 2; y[i] = rand() - 0.5; z[i] = rand() - 0.5}
        rest = 0.05
        for (round = 0; round < 160; ++round) {
            step = 0.10 * (1 - round / 160) + 0.003
            for (i = 0; i < N; ++i) fx[i] = fy[i] = fz[i] = 0
            for (i = 0; i < N; ++i) for (j = 0; j < i; ++j) {
                a = x[i] - x[j]; b = y[i] - y[j]; d = z[i] - z[j]
                f = 0.0012 / (a * a + b * b + d * d + 0.0004)
                fx[i] += f * a; fy[i] += f * b; fz[i] += f * d; fx[j] -= f * a; fy[j] -= f * b; fz[j] -= f * d
            }
            for (e = -N + 1; e < E; ++e) {
                i = e < 0 ? -e - 1 : from[e]; j = e < 0 ? -e : into[e]; f = e < 0 ? 3 : 0.5 * weight[e]
                a = f * (x[i] - x[j]); b = f * (y[i] - y[j]); d = f * (z[i] - z[j])
                fx[i] -= a; fy[i] -= b; fz[i] -= d; fx[j] += a; fy[j] += b; fz[j] += d
            }
            for (i = 0; i < N; ++i) {
                l = sqrt(fx[i] ^ 2 + fy[i] ^ 2 + fz[i] ^ 2) + 1e-9; m = l > step ? step / l : 1
                x[i] += m * fx[i]; y[i] += m * fy[i]; z[i] += m * fz[i]
            }
        }
        for (i = p; i < N - p; ++i) {cx += x[i] / (N - 2 * p); cy += y[i] / (N - 2 * p); cz += z[i] / (N - 2 * p)}
        for (i = p; i < N - p; ++i) size += sqrt((x[i] - cx) ^ 2 + (y[i] - cy) ^ 2 + (z[i] - cz) ^ 2) / (N - 2 * p)
        for (i = 0; i < N; ++i) {x[i] = (x[i] - cx) / size; y[i] = (y[i] - cy) / size; z[i] = (z[i] - cz) / size}
        print "# columns x y z radius red green blue alpha" > "chain.xyz"
        print "# columns x y z radius red green blue alpha" > "jumps.xyz"
        for (i = p; i + p < N; ++i) edge(i, i + 1, 0.022, 0, "chain.xyz")
        for (e = 0; e < E; ++e) if (weight[e] > 0.02 && from[e] != into[e]) edge(from[e], into[e], 0.002 + 0.02 * weight[e], 1, "jumps.xyz")
    }' style.xyz
# The style in the same colours.
awk '
    function hue(u, at) {return 0.03 + 0.8 * exp(-((u - at) / 0.24) ^ 2)}
    /^# columns/ {print "# columns x y z red green blue alpha"; next}
    /^#/ || NF == 0 {next}
    {u = i / 260; ++i; print $1, $2, $3, hue(u, 1), hue(u, 0.55), hue(u, 0.1), 1}' style.xyz > painted.xyz
cat > picture.json <<'END'
{"size": [960, 420],
 "all": {"ground": false},
 "panels": [
  {"title": "A style", "camera": [5.0, 8.0], "show": [{"file": "painted.xyz", "radius": 0.006}]},
  {"title": "Its patch graph", "keys": [{"color": "#5b88c0", "text": "the style's next point, in the style's colours"}, {"color": "#9c9da1", "text": "jumps, the thicker the cheaper"}], "camera": [40.0, 20.0], "show": [{"file": "chain.xyz", "shadow": false}, {"file": "jumps.xyz", "shadow": false, "gloss": 0.0}]}]}
END
filigree panels picture.json -o graph.png
