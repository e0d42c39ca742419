#!/usr/bin/env python3
"""check_macos.py BUILD HEADERS: checks the files of scripts/build_macos.sh, with LIEF: 64-bit ARM, nothing loaded but the system's
library and Tamis's own, and a C interface that exports the functions of its headers."""
import pathlib
import sys

import lief

import apple_local
from check_c_symbols import declared_in

lief.logging.disable()  # it warns of what it does not read

# zig links its C++ library into each file; C++ asks that programs may replace these functions.
OF_CPP = ("__Zna", "__Znw", "__Zda", "__Zdl", "__mh_dylib_header", "___dso_handle")
SYSTEM = "/usr/lib/libSystem.B.dylib"
C_LIBRARY = "@rpath/libtamis_c.0.1.dylib"


def read(path: pathlib.Path) -> lief.MachO.Binary:
    return lief.MachO.parse(str(path)).at(0)


def faults_of(path: pathlib.Path, kind: str, loads: set[str]) -> list[str]:
    file = read(path)
    loaded = {library.name for library in file.libraries if library.command != lief.MachO.LoadCommand.TYPE.ID_DYLIB}
    found = {
        "processor": (file.header.cpu_type.name, "ARM64"),
        "type": (file.header.file_type.name, kind),
        "loads": (loaded, loads),
        "position independent": (file.is_pie or kind == "DYLIB", True),
        "signature": (file.has_code_signature, True),
        "oldest system": (file.build_version.minos, [11, 0, 0]),
        "pages with another signature": (apple_local.unsigned(path.read_bytes()), []),
        "own weak symbols": (apple_local.is_local(path.read_bytes()), True),
    }
    return [f"{path.name}: {what} {is_} instead of {wanted}" for what, (is_, wanted) in found.items() if is_ != wanted]


def main() -> int:
    build, headers = map(pathlib.Path, sys.argv[1:])
    (library,) = (path for path in build.glob("bindings/c/*.dylib") if not path.is_symlink())
    faults = faults_of(library, "DYLIB", {SYSTEM})
    faults += faults_of(build / "hello_c", "EXECUTE", {SYSTEM, C_LIBRARY})
    faults += faults_of(build / "hello_cpp", "EXECUTE", {SYSTEM})
    file = read(library)  # symbols of a temporary file would be gone
    symbols = {symbol.name for symbol in file.exported_symbols}
    exported = {name for name in symbols if not name.startswith(OF_CPP)}
    wanted = {f"_{name}" for name in declared_in(headers)}
    faults += [f"exported, and not declared: {name}" for name in sorted(exported - wanted)]
    faults += [f"declared, and not exported: {name}" for name in sorted(wanted - exported)]
    print(*faults, f"{len(exported)} functions exported, {len(faults)} faults; built, never run", sep="\n")
    return 1 if faults or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
