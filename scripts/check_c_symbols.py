#!/usr/bin/env python3
"""check_c_symbols.py LIBRARY HEADERS: checks that the library exports exactly the functions of the folder's headers.

All symbols must have the library's version; a DLL has it in its name alone. An additional symbol may replace another
library's in a program that loads this one; a missing symbol is a function that cannot be called.
"""
import pathlib
import re
import subprocess
import sys


def lines_of(*command: str) -> list[str]:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def exported_by(library: str) -> set[str]:
    if library.endswith(".dll"):
        # Binutils before 2.41 write "[ 0] name", later ones "[ 0] +base[ 1] 0000 name".
        line = re.compile(r"\s*\[\s*\d+\](?: \+base\[\s*\d+\]\s+[0-9a-f]+)? (\w+)")
        return {match[1] for match in map(line.fullmatch, lines_of("objdump", "--private-headers", library)) if match}
    names = lines_of("nm", "--dynamic", "--defined-only", "--with-symbol-versions", library)
    return {line.split(" ", 2)[2] for line in names if " A " not in line}


def declared_in(folder: pathlib.Path) -> set[str]:
    """Return the functions that the headers of a folder declare."""
    headers = "".join(path.read_text() for path in sorted(folder.glob("*.h")))
    text = re.sub(r"/\*.*?\*/", "", headers, flags=re.DOTALL)
    return set(re.findall(r"^TAMIS_API [^(]*\b(tamis_\w+)\(", text, re.MULTILINE))


def main() -> int:
    library, folder = sys.argv[1:]
    declared = declared_in(pathlib.Path(folder))
    version = re.search(r"tamis_c(?:\.so\.|-)(\d+\.\d+)", pathlib.Path(library).resolve().name)
    if not version or not declared:
        print(f"{library} has no version in its name, or {folder} declares nothing")
        return 1
    exported = exported_by(library)
    wanted = {name if library.endswith(".dll") else f"{name}@@TAMIS_{version[1]}" for name in declared}
    for name in sorted(exported - wanted):
        print(f"exported, and not declared: {name}")
    for name in sorted(wanted - exported):
        print(f"declared, and not exported: {name}")
    print(f"{len(exported)} symbols exported")
    return 0 if exported == wanted else 1


if __name__ == "__main__":
    sys.exit(main())
