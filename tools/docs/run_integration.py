#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the commands and the CMake code of sdk/docs/integration.md, as a reader would who follows it.

    run_integration.py PAGE ROOT FOLDER CC

Takes the page's blocks in their order: builds and installs with the first commands, finds the package from a project of
its own, builds the page's C program with pkg-config, and configures a project that has Filigree as a part. What the
page calls /opt/filigree and game is in FOLDER. The commands for Windows need what not every machine has: only the
presets that they name are looked up.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^```(sh|cmake|c complete)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def run(command, folder, **variables):
    text = command if isinstance(command, str) else " ".join(map(str, command))
    done = subprocess.run(["bash", "-euc", text], cwd=folder, check=False, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, env=os.environ | variables)
    if done.returncode != 0:
        raise SystemExit(f"{text}\nreturned {done.returncode}:\n{done.stdout}")
    return done.stdout


def project(folder, code, compiler):
    """A project with the page's CMake code and program, configured; returns its build folder."""
    lines = ["cmake_minimum_required(VERSION 3.25)", "project(game LANGUAGES C CXX)", "add_executable(game game.c)", code,
             "target_link_libraries(game PRIVATE m)"]
    (folder / "CMakeLists.txt").write_text("\n".join(lines), encoding="utf-8")
    run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={folder.parent / 'prefix'}",
         f"-DCMAKE_C_COMPILER={compiler}"], folder)
    return folder / "build"


def main():
    page, root, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    compiler = sys.argv[4]
    shutil.rmtree(folder, ignore_errors=True)
    prefix, found, part, make = (folder / name for name in ("prefix", "found", "part", "make"))
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    kinds = [kind for kind, _ in blocks]
    if kinds != ["sh", "cmake", "cmake", "sh", "c complete", "sh"]:
        raise SystemExit(f"{page}: other blocks than this knows: {kinds}")
    install, find, fetch, pkg_config, program, windows = (text.replace("/opt/filigree", str(prefix)) for _, text in blocks)
    for place in (found, part, make):
        place.mkdir(parents=True)
        (place / "game.c").write_text(program, encoding="utf-8")

    run(install, root)
    build = project(found, find, compiler)
    run(["cmake", "--build", build], found)
    run("build/game", found)
    run(pkg_config + "\n./a.out", make)
    (part / "extern").mkdir()
    (part / "extern/filigree").symlink_to(root)
    project(part, fetch, compiler)

    presets = run("cmake --list-presets", root)
    for name in re.findall(r"--preset (\w+)", install + windows):
        if f'"{name}"' not in presets:
            raise SystemExit(f"{page}: there is no preset {name}")


main()
