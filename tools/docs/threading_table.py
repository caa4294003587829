#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the table of sdk/docs/threading.md: each function of the public headers, who may call it, what it costs.

    tools/docs/threading_table.py            writes it
    tools/docs/threading_table.py --check    changes nothing; fails where the page is not what it would write

All of it comes from sdk/api/abi.json. A cost is what a function's comment says behind "Cost:", or what follows from its
kind. A function of which neither tells is a mistake: its comment is to be completed.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "sdk/docs/threading.md"
BEGIN, END = "<!-- table: begin -->\n", "<!-- table: end -->\n"

THREADS = {"any": "any", "FlgContext": "context", "FlgPickScene": "scene", "FlgLiveStroke": "stroke"}  # others are files
GETTERS = re.compile(r"^flg\w*(Get\w*|Init)$")
SPECIAL = {
    "flgContextTick": "its budget and a chunk (100 us) at most",
    "flgContextWait": "sleeps, up to its timeout",
    "flgContextRun": "ticks and sleeps, up to its seconds",
    "flgContextDestroy": "a chunk (100 us) at most, and freeing all it holds",
}


def cost(function):
    match = re.search(r"\bCost\b[^:.]*:\s(.*?)(?:\.(?=\s|$)|$)", " ".join(function["doc"].split()))
    if function["name"] in SPECIAL:
        return SPECIAL[function["name"]]
    if match:
        return match.group(1)
    if GETTERS.match(function["name"]):
        return "tens of nanoseconds"
    if function["name"].endswith(("Release", "Destroy", "Remove")):
        return "freeing what nothing else needs"
    raise SystemExit(f"{function['name']}: its comment says no cost (`Cost: ...`)")


def starts_job(function):
    return any(parameter["type"] == "FlgJob*" for parameter in function["parameters"])


def table(functions):
    lines = ["| function | thread | job | cost |", "|---|---|---|---|"]
    for function in functions:
        thread = THREADS.get(function["thread"], "file")
        text = cost(function).replace("|", "/").replace("<", "&lt;")
        lines.append(f"| `{function['name']}` | {thread} | {'job' if starts_job(function) else ''} | {text} |")
    return "\n".join(lines) + "\n"


def page():
    abi = json.loads((ROOT / "sdk/api/abi.json").read_text(encoding="utf-8"))
    parts = []
    for header in abi["headers"]:
        functions = [f for f in abi["functions"] if f["header"] == header["name"]]
        if functions:
            parts.append(f"### {header['name']}\n\n{table(functions)}")
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    return before + BEGIN + "\n" + "\n".join(parts) + "\n" + END + rest.split(END)[1]


def main():
    text = page()
    if sys.argv[1:] != ["--check"]:
        PAGE.write_text(text, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != text:
        raise SystemExit("sdk/docs/threading.md is not what the headers say: run tools/docs/threading_table.py")


main()
