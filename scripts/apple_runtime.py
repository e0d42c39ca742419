#!/usr/bin/env python3
"""apple_runtime.py FOLDER: compilers for macOS 11 on ARM64, for cmake/zig.cmake, whose programs share the system's C++ exceptions.

Runs by the Python of `scripts/pinned.sh python zig`. nanobind's backend uses the system's libc++abi, and throws exceptions that the
module catches. zig has no stub of it, and links a copy into each program. So `c++` here links as `zig cc` does, with a stub that has
the names of that copy (libapple_abi.tbd), and with the rest of zig's C++ library (libcxx_rest.a).
"""

import pathlib
import re
import shlex
import subprocess
import sys

import lief

lief.logging.disable()  # it warns of what it does not read

TARGET = "aarch64-macos.11.0"
PARTS = ("___cxa", "___dynamic_cast", "___gxx", "__Z")
NEWER = {"___cxa_init_primary_exception"}  # not in macOS 11
EXTERNAL = (0x0F, 0x1F)  # a symbol of a section, external; zig hides it


def write_tool(path: pathlib.Path, text: str) -> None:
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


def main() -> int:
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
    linked = f"-s -L{folder} -lcxx_rest -lapple_abi"
    for tool, command in {"cc": f"cc -target {TARGET}", "ar": "ar", "ranlib": "ranlib"}.items():
        write_tool(folder / tool, f'exec {shlex.join(zig)} {command} "$@"')
    write_tool(folder / "strip", "exit 0")  # the linker does it
    # For a module of Python nanobind gives a list of the names that Python has, and links a bundle: zig knows neither.
    write_tool(folder / "c++", f'''case " $* " in
*" -c "*) exec {shlex.join(zig)} c++ -target {TARGET} "$@" ;;
esac
for word; do
  shift
  case $word in
  -Wl,@*/darwin-ld-cpython.sym) word=-Wl,-undefined,dynamic_lookup ;;
  -bundle) word=-dynamiclib ;;
  esac
  set -- "$@" "$word"
done
{folder}/cc "$@" {linked} || exit
while [ $# -gt 0 ] && [ "$1" != -o ]; do shift; done
[ $# -eq 0 ] || exec {sys.executable} {pathlib.Path(__file__).with_name("apple_local.py")} "$2"''')
    (folder / "libapple_abi.tbd").write_text(
        "--- !tapi-tbd\ntbd-version: 4\ntargets: [ arm64-macos ]\ninstall-name: '/usr/lib/libc++abi.dylib'\n"
        f"exports:\n  - targets: [ arm64-macos ]\n    symbols: [ {kept} ]\n...\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
