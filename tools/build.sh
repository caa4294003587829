# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by tools/run and tools/test. build PRESET [TARGET...]: configures and builds build/PRESET. On a terminal
# ninja's line shows how far it is; in a log only failures show. `root` is the checkout; `options`, where set, are
# CMake's; `steady`, where set, runs the tools.
#
# Checkouts in different folders share the compiler's cache: paths within them are hashed relative to the build.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
build() {
    local preset=$1 log quiet=()
    shift
    [[ -t 1 ]] || quiet=(--quiet)
    echo "build: $preset (some minutes the first time)"
    log=$(mktemp)
    if ! (cd "$root" && cmake --preset "$preset" "${options[@]}") >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        echo "build: configuring $preset failed, see above" >&2
        return 1
    fi
    rm -f "$log"
    if ! NINJA_STATUS="build: $preset [%f/%t] " "${steady[@]}" ninja -C "$root/build/$preset" "${quiet[@]}" "$@"; then
        echo "build: $preset failed, see above" >&2
        return 1
    fi
}
