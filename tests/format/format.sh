#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# format.sh CLANG_FORMAT: all C and C++ of the checkout is as .clang-format has it, but for the C headers, whose tables
# of fields with their comments are laid out by hand. No line of code, comments included, is longer than 120 columns.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
sources() {
    find sdk renderer samples tools tests \
        \( -name '*.cpp' -o -name '*.h' -o -name '*.hpp' -o -name '*.c' -o -name '*.inl' \) \
        -not -path 'sdk/include/filigree/*.h' -print0 | sort -z
}
sources | xargs -0 -P "$(nproc)" -n 100 "$1" --dry-run --Werror
{
    sources
    find sdk/include shaders \
        \( -name '*.h' -o -name '*.vert' -o -name '*.frag' -o -name '*.comp' -o -name '*.glsl' \) -print0
} | xargs -0 awk 'length > 120 { print FILENAME ":" FNR ": longer than 120 columns"; found = 1 } END { exit found }'
