# SPDX-License-Identifier: MIT
"""A DLL exports exactly the functions that the ABI has for it, all flg*, and needs no DLL that Windows does not bring
along: dll_symbols.py ABI.json OBJDUMP FILE LIBRARY."""
import json
import re
import subprocess
import sys
from pathlib import Path

# The system's, and its C library's.
WINDOWS = {"kernel32.dll", "msvcrt.dll"}

description, objdump, file, library = sys.argv[1:]
functions = json.loads(Path(description).read_text(encoding="utf-8"))["functions"]
declared = {function["name"] for function in functions if function["library"] == library}
headers = subprocess.run([objdump, "-p", file], check=True, capture_output=True, text=True).stdout
# "\t[   4] flgContextCreate", with other columns between where objdump is newer; exports alone are numbered so.
table = headers.partition("[Ordinal/Name Pointer] Table")[2].partition("\n\n")[0]
exported = set(re.findall(r"^\s*\[\s*\d+\].*?(\S+)$", table, re.MULTILINE))
needed = {name.lower() for name in re.findall(r"^\s*DLL Name: (\S+)$", headers, re.MULTILINE)}
for names, what in ((declared - exported, "declared, but not exported"),
                    (exported - declared, "exported, but not declared"),
                    (needed - WINDOWS, "needed, but not Windows' own")):
    for name in sorted(names):
        print(f"{library}: {name} is {what}", file=sys.stderr)
if declared != exported or not declared or not needed or needed - WINDOWS:
    sys.exit(1)
print(f"{library}: {len(exported)} symbols, all declared; needs {', '.join(sorted(needed))}")
