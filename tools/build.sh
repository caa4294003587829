# SPDX-License-Identifier: MIT
# Sourced by tools/run and tools/test. build PRESET [TARGET...]: configures and builds build/PRESET; quiet unless it fails,
# but for ninja's own progress line on a terminal.
build() {
    local preset=$1
    shift
    local folder="$root/build/$preset" log
    log=$(mktemp)
    echo "build: $preset"
    if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        echo "build: configuring $preset failed, see above" >&2
        return 1
    fi
    rm -f "$log"
    NINJA_STATUS="build: $preset [%f/%t] " ninja -C "$folder" --quiet "$@" || {
        echo "build: $preset failed, see above" >&2
        return 1
    }
}
