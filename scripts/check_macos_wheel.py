#!/usr/bin/env python3
"""check_macos_wheel.py WHEEL NAMES: checks the module and the command of a wheel for macOS 11, with LIEF: kind, processor, signature,
what they load, and that the module takes nothing from Python but what NAMES, nanobind's list, has. Nothing is run."""
import pathlib
import sys
import tempfile
import zipfile

from check_macos import faults_of, read

SYSTEM = {"/usr/lib/libSystem.B.dylib", "/usr/lib/libc++abi.dylib"}
FROM_PYTHON = -2  # looked up in all that is loaded


def main() -> int:
    wheel, names = map(pathlib.Path, sys.argv[1:])
    known = {line.split()[1] for line in names.read_text().splitlines()}
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
        module, command = pathlib.Path(folder) / "tamis/_core.abi3.so", pathlib.Path(folder) / "tamis/command/bin/tamis"
        faults = faults_of(module, "DYLIB", SYSTEM) + faults_of(command, "EXECUTE", SYSTEM)
        file = read(module)  # names of a temporary file would be gone
        asked = {binding.symbol.name for binding in file.bindings if binding.library_ordinal == FROM_PYTHON}
        starts = "_PyInit__core" in {symbol.name for symbol in file.exported_symbols}
    faults += [f"asked of Python, which has no such name: {name}" for name in sorted(asked - known)]
    faults += [] if starts and asked else ["the module is none of Python's"]
    print(*faults, f"{wheel.name}: {len(asked)} names of Python, {len(faults)} faults; built, never run", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
