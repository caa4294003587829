#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that a package holds the licence of everything that its libraries link or have compiled in, and no other.

    licences.py NINJA BUILD PREFIX

What is compiled in are the headers that ninja noted for each installed library's objects; what is linked, the shared
libraries that it needs. Debian knows which source package each of these comes from.
"""
import pathlib
import re
import subprocess
import sys

# Source packages with the texts they need, each with words that must be in it.
TEXTS = {
    "eigen3": ("eigen.txt", ["Mozilla Public License Version 2.0", "gitlab.com/libeigen/eigen", "Exhibit A"]),
    "embree": ("embree.txt", ["Apache License", "Version 2.0, January 2004", "END OF TERMS AND CONDITIONS"]),
    "zlib": ("zlib.txt", ["Jean-loup Gailly", "This software is provided 'as-is'"]),
}
# The compiler's and the system's own: no notice is asked for.
TOOLCHAIN = re.compile(r"glibc|gcc-\d+|linux|llvm-toolchain-\d+")
# Installed libraries and the folders of their objects.
OBJECTS = {"libfiligree.so": ["filigree_core", "filigree_api"], "libfiligree_io.so": ["filigree_io_objects"],
           "libfiligree_pick.so": ["filigree_pick_objects"]}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def compiled_in(ninja, build, target):
    """The headers from outside the project and its build that the target's objects were made of."""
    known = {line.rsplit(":", 1)[0] for line in output(ninja, "-C", build, "-t", "targets", "all").splitlines()}
    objects = [str(path.relative_to(build)) for path in build.glob(f"sdk/**/{target}.dir/**/*.o")]
    objects = [path for path in objects if path in known]  # a build folder may hold objects of sources that have left
    if not objects:
        raise SystemExit(f"{build}: no objects of {target}")
    headers = set()
    for line in output(ninja, "-C", build, "-t", "deps", *objects).splitlines():
        if line.startswith("    /usr/"):
            headers.add(line.strip())
        elif "deps not found" in line:
            raise SystemExit(f"{build}: {line}")
    return headers


def linked(library):
    return re.findall(r"\(NEEDED\).*\[(.+)\]", output("readelf", "-d", library))


def source_packages(files):
    """The Debian source packages that files, or the names of shared libraries, are from."""
    found = output("dpkg-query", "-S", *[name if name[0] == "/" else f"*/{name}" for name in sorted(files)])
    packages = {word.strip() for line in found.splitlines() for word in line.split(": ")[0].split(",")}
    return set(output("dpkg-query", "-W", "-f", "${source:Package}\n", *packages).split())


def main():
    ninja, build, prefix = sys.argv[1], *(pathlib.Path(argument) for argument in sys.argv[2:])
    needed = set()
    for library, targets in OBJECTS.items():
        installed = list(prefix.glob(f"lib*/**/{library}"))
        if not installed:
            continue
        files = set(linked(installed[0]))
        for target in targets:
            files |= compiled_in(ninja, build, target)
        parts = {name for name in source_packages(files) if not TOOLCHAIN.fullmatch(name)}
        print(f"{library}: {' '.join(sorted(parts))}")
        needed |= parts
    if "eigen3" not in needed:
        raise SystemExit("no library needs Eigen? This looks at nothing.")
    unknown = needed - set(TEXTS)
    if unknown:
        raise SystemExit(f"what is the licence of {' '.join(unknown)}?")
    folder = prefix / "share/doc/filigree/licences"
    found = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*")}
    for name in needed:
        text, words = TEXTS[name]
        missing = [word for word in words if word not in found.get(text, "")]
        if missing:
            raise SystemExit(f"{folder / text}: is not there, or lacks {missing}")
    superfluous = set(found) - {TEXTS[name][0] for name in needed}
    if superfluous:
        raise SystemExit(f"{folder}: nothing installed needs {' '.join(superfluous)}")


main()
