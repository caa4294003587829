#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tells the fuzzer where the fields of descriptors lie: sdk/api/abi.json on the command line, C++ on stdout.

A field is of one of these kinds: real (float, double), whole (integers and enumerations), count (of what a pointer
beside it points to: must not grow), handle, pointer (may be taken away, never changed)."""
import json
import sys


def kind_of(field, abi):
    kind = field["type"]
    if "*" in kind or kind in abi["callbacks"] or field.get("callback"):
        return "pointer"
    if kind in abi["handles"]:
        return "handle"
    if kind in ("float", "double"):
        return "real"
    if field["name"] == "struct_size":
        return "whole"
    if field["name"].endswith(("count", "counts", "capacity", "stride", "components", "dimension", "ambient", "memory_size")):
        return "count"
    return "whole"


def flatten(struct, structs, abi, base=0):
    for field in struct["fields"]:
        inner = structs.get(field["type"])
        each = field["size"] // field["count"]
        for i in range(field["count"]):
            offset = base + field["offset"] + i * each
            if field["name"] == "user_data":
                continue  # whatever it is, it is for the host's functions, here the fuzzer's own
            if inner is None:
                yield offset, each, kind_of(field, abi)
            else:
                yield from flatten(inner, structs, abi, offset)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        abi = json.load(file)
    abi["handles"] = {handle["name"] for handle in abi["handles"]}
    abi["callbacks"] = {callback["name"] for callback in abi["callbacks"]}
    structs = {struct["name"]: struct for struct in abi["structs"]}
    print("// Made by descriptor_fields.py.")
    for struct in abi["structs"]:
        if struct["fields"][0]["name"] != "struct_size" or struct["header"] in ("filigree_io.h", "filigree_pick.h"):
            continue
        fields = ", ".join(f"{{{o}, {s}, Kind::{k}}}" for o, s, k in flatten(struct, structs, abi))
        print(f"{{typeid({struct['name']}), {{{fields}}}}},")


main()
