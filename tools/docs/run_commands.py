#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the commands of a page as a reader would who pastes them, and checks that each returns 0.

    run_commands.py PAGE ROOT PROGRAMS

Runs all lines of the fenced blocks that begin with ```sh, in order, in one shell and in an empty folder that shows, as links, what
they need of the checkout ROOT: samples/, and the built programs in build/release/bin. Prints how long each took; ends with
status 1 if one fails, or leaves one of the files it names behind -o out.
"""
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time


def commands(page):
    fenced, found = False, []
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("```"):
            fenced = line == "```sh"
        elif fenced and line.strip() and not line.startswith("#"):
            found.append((number, line))
    return found


def outputs(line):
    words = shlex.split(line, comments=True)
    return [word for before, word in zip(words, words[1:]) if before == "-o"]


def main():
    page, root, programs = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    found = commands(page)
    if not any(line.startswith("filigree ") for _, line in found):
        raise SystemExit(f"{page}: holds no commands of filigree")
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        (here / "build/release").mkdir(parents=True)
        (here / "build/release/bin").symlink_to(programs)
        (here / "samples").symlink_to(root / "samples")
        script = "".join(f"{line}\necho $? $EPOCHREALTIME >>.statuses\n" for _, line in found)
        start = time.time()
        subprocess.run(["bash", "-c", script], cwd=here, check=False)
        statuses = [line.split() for line in (here / ".statuses").read_text(encoding="ascii").splitlines()]
        for (number, line), (status, end) in zip(found, statuses, strict=True):
            missing = [name for name in outputs(line) if not (here / name).is_file()]
            print(f"{float(end) - start:6.2f} s  {line}", flush=True)
            start = float(end)
            if status != "0" or missing:
                failed = True
                print(f"{page.name}:{number}: returned {status}; not written: {' '.join(missing) or 'none'}")
    raise SystemExit(1 if failed else 0)


main()
