# SPDX-License-Identifier: MIT
"""A shared library exports exactly the functions that the ABI has for it, all flg*: exported_symbols.py ABI.json NM FILE
LIBRARY."""
import json
import subprocess
import sys
from pathlib import Path

description, nm, file, library = sys.argv[1:]
functions = json.loads(Path(description).read_text(encoding="utf-8"))["functions"]
declared = {function["name"] for function in functions if function["library"] == library}
table = subprocess.run([nm, "-D", "--defined-only", "--format=posix", file], check=True, capture_output=True, text=True)
exported = {line.split()[0] for line in table.stdout.splitlines()}
for names, what in ((declared - exported, "declared, but not exported"), (exported - declared, "exported, but not declared")):
    for name in sorted(names):
        print(f"{library}: {name} is {what}", file=sys.stderr)
if declared != exported or not declared:
    sys.exit(1)
print(f"{library}: {len(exported)} symbols, all declared")
