#!/usr/bin/env python3
"""apple_runtime.py FOLDER: what zig links against, so that programs for macOS on ARM64 share the system's C++ exceptions.

Runs by the Python of `scripts/pinned.sh python zig`. Makes in FOLDER: libapple_abi.tbd, a stub of /usr/lib/libc++abi.dylib, and
libcxx_rest.a, the rest of zig's C++ library. nanobind's backend uses the system's libc++abi, and throws exceptions that the module
catches. Link by `zig cc`, as `zig c++` adds a copy of libc++abi.
"""

import pathlib
import re
import subprocess
import sys

TARGET = "aarch64-macos.11.0"
PARTS = ("___cxa", "___dynamic_cast", "___gxx", "__Z")
NEWER = {"___cxa_init_primary_exception"}  # not in macOS 11
EXTERNAL = (0x0F, 0x1F)  # a symbol of a section, external; zig hides it


def main() -> int:
    import lief

    folder = pathlib.Path(sys.argv[1]).resolve()
    (folder / "objects").mkdir(parents=True, exist_ok=True)
    zig = [sys.executable, "-m", "ziglang"]
    (folder / "empty.cpp").write_text("#include <stdexcept>\nvoid f() { throw std::runtime_error({}); }\n")
    command = [*zig, "c++", "-v", "-target", TARGET, "-shared", folder / "empty.cpp", "-o", folder / "empty.dylib"]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    (abi,) = set(re.findall(r"/\S+/libc\+\+abi\.a", done.stdout))
    (rest,) = set(re.findall(r"/\S+/libc\+\+\.a", done.stdout))
    (folder / "libcxx_rest.a").write_bytes(pathlib.Path(rest).read_bytes())
    subprocess.run([*zig, "ar", "x", abi], check=True, cwd=folder / "objects")
    names = set()
    for path in sorted((folder / "objects").glob("*.o")):
        parsed = lief.MachO.parse(str(path))
        names |= {symbol.name for symbol in parsed.at(0).symbols if symbol.raw_type in EXTERNAL}
    kept = ", ".join(f"'{name}'" for name in sorted(names - NEWER) if name.startswith(PARTS))
    (folder / "libapple_abi.tbd").write_text(
        "--- !tapi-tbd\ntbd-version: 4\ntargets: [ arm64-macos ]\ninstall-name: '/usr/lib/libc++abi.dylib'\n"
        f"exports:\n  - targets: [ arm64-macos ]\n    symbols: [ {kept} ]\n...\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
