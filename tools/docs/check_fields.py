#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that the pages of sdk/docs explain every parameter: each field of each descriptor (sdk/api/abi.json), and of
the structs that descriptors hold, is named in code marks on a page that names its struct so too; and each FlgResult.

    check_fields.py ROOT

Left out are the fields that all descriptors have, and structs that results are viewed by.
"""
import json
import pathlib
import re
import sys

COMMON = re.compile(r"^(struct_size|version|reserved2?|job|user_data)$")
DESCRIPTOR = re.compile(r"(Desc|Functions)$")
# Explained by examples of code, or as results; a host's hooks have no values to choose.
ELSEWHERE = re.compile(
    r"(View|Places|Allocator|JobSystem|Log|Clock|Profiler|Animation|FlgColumn|FlgSurfacePoint|FaceColumn)$")


def base_type(text):
    return text.replace("const", "").replace("*", "").strip()


def wanted(structs):
    """Names of descriptors and of what they hold."""
    names, open_names = set(), [name for name in structs if DESCRIPTOR.search(name)]
    while open_names:
        name = open_names.pop()
        if name in names or ELSEWHERE.search(name):
            continue
        names.add(name)
        types = (base_type(field["type"]) for field in structs[name]["fields"])
        open_names += [type for type in types if type in structs and type != "FlgJobOptions"]
    return names


def main():
    root = pathlib.Path(sys.argv[1])
    abi = json.loads((root / "sdk/api/abi.json").read_text(encoding="utf-8"))
    structs = {struct["name"]: struct for struct in abi["structs"]}
    pages = [set(re.findall(r"\w+", " ".join(re.findall(r"`([^`\n]+)`", page.read_text(encoding="utf-8")))))
             for page in sorted((root / "sdk/docs").glob("*.md"))]
    faults = fields = 0
    for name in sorted(wanted(structs)):
        for field in structs[name]["fields"]:
            if COMMON.match(field["name"]):
                continue
            fields += 1
            if not any(name in words and field["name"] in words for words in pages):
                faults += 1
                print(f"{name}::{field['name']} is explained on no page that names {name}")
    results = next(enum for enum in abi["enums"] if enum["name"] == "FlgResult")["values"]
    for result in results:
        if not result["name"].endswith("_FORCE_32BIT") and not any(result["name"] in words for words in pages):
            faults += 1
            print(f"{result['name']} is explained on no page")
    print(f"{fields} fields, {len(results) - 1} results, {faults} of them not explained")
    sys.exit(1 if faults or not fields else 0)


main()
