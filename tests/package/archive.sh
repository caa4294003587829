#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# archive.sh ROOT BUILD OUT: the release archive of the build BUILD is that of another build folder, byte for byte, and
# is whole: it unpacks to what a host needs, without a path of this machine in it.
#
# The other build takes objects from the compiler's cache, for they take minutes; those of picking, the fewest, it
# compiles itself.
set -euo pipefail
root=$1 build=$2 out=$3
export SOURCE_DATE_EPOCH=1700000000
rm -rf "$out"
mkdir -p "$out"

(umask 022; TZ=UTC "$root/tools/package" --build "$build" --out "$out/first")
"$root/tools/package" --out "$out/second"
rm -r "$out/second" "$root"/build/package/sdk/pick/CMakeFiles/*.dir
(umask 077; TZ=Asia/Tokyo CCACHE_DISABLE=1 "$root/tools/package" --out "$out/second")
first=$(echo "$out"/first/*.tar.gz) second=$(echo "$out"/second/*.tar.gz)
tar -C "$out" -xf "$first"
name=$(basename "$first" .tar.gz)
if ! cmp "$first" "$second"; then
    mkdir "$out/other"
    tar -C "$out/other" -xf "$second"
    diff -rq "$out/$name" "$out/other/$name" || true  # names the files; the test fails below, whatever it says
    exit 1
fi

cd "$out/$name"
for wanted in include/filigree/filigree.h include/filigree/filigree.hpp lib*/libfiligree.a lib*/libfiligree.so \
    lib*/libfiligree_io.so lib*/libfiligree_pick.so lib*/cmake/filigree/filigree-config.cmake \
    share/doc/filigree/LICENSE share/doc/filigree/licences/eigen.txt share/doc/filigree/integration.md \
    share/doc/filigree/CHANGELOG.md com.filigree.sdk/package.json com.filigree.sdk/Runtime/Native/FiligreeTypes.cs; do
    # shellcheck disable=SC2086
    [[ -e $(echo $wanted) ]] || { echo "the archive has no $wanted"; exit 1; }
done
if grep -rlF -e "$root" -e "$build" .; then
    echo "these files hold a path of this machine"
    exit 1
fi
python3 "$root/tools/docs/check_links.py" .
