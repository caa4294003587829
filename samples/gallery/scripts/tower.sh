#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An architect's wireframe, less and less steady.
set -euo pipefail
filigree stylize --style builtin:tremor --target builtin:tower --displacement 0.012 --network --columns -o tremor.xyz
# The magnitude, 1 in the result, grows with the place: from 0 at x = 1.2 m to 1.5 at x = -0.1 m.
awk '
    /^# columns/ {for (i = 3; i <= NF; ++i) column[$i] = i - 2}
    /^#/ || NF == 0 {print; next}
    {
        d = column["displacement_0"]; x = $1 - $d; u = (x - 1.2) / -1.3; u = u < 0 ? 0 : u > 1 ? 1 : u
        more = 1.5 * u * u * (3 - 2 * u) - 1
        for (k = 0; k < 3; ++k) $(k + 1) += more * $(d + k)
        print
    }' tremor.xyz > unsteady.xyz

cat > picture.json <<'END'
{"size": [720, 720],
 "panels": [
  {"camera": [-31.8, 10.6], "show": [{"file": "unsteady.xyz"}]}]}
END
filigree panels picture.json -o tower.png
