#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""csharp_layout.py ABI.json OUT.cs: C# that lists the binding's sizes and offsets as c_proof.py's program does C's."""
import json
import sys
from pathlib import Path

from csharp import identifier


def listing(abi: dict) -> str:
    lines = ["// Written by tools/abi/csharp_layout.py.", "namespace Filigree.Tests", "{",
             "    static unsafe class AbiLayout", "    {", "        internal static void List(System.IO.TextWriter to)",
             "        {"]
    for struct in abi["structs"]:
        name = struct["name"]
        lines += ["            {", f"                {name} s;", "                byte* p = (byte*)&s;",
                  f'                to.WriteLine("{name} " + sizeof({name}));']
        for f in struct["fields"]:
            place = f"s.{identifier(f['name'])}" if f["count"] != 1 else f"&s.{identifier(f['name'])}"
            lines.append(f'                to.WriteLine("{name}.{f["name"]} " + ((byte*){place} - p));')
        lines.append("            }")
    return "\n".join(lines + ["        }", "    }", "}", ""])


if __name__ == "__main__":
    source, out = map(Path, sys.argv[1:])
    out.write_text(listing(json.loads(source.read_text(encoding="utf-8"))), encoding="utf-8")
