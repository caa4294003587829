#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# format.sh CLANG_FORMAT: all C and C++ of the checkout is as .clang-format has it; but for the C headers, whose tables of
# fields with their comments are laid out by hand.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
find sdk renderer samples tools tests \( -name '*.cpp' -o -name '*.h' -o -name '*.hpp' -o -name '*.c' -o -name '*.inl' \) \
    -not -path 'sdk/include/filigree/*.h' -print0 | sort -z | xargs -0 -P "$(nproc)" -n 100 "$1" --dry-run --Werror
