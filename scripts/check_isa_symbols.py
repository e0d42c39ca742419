#!/usr/bin/env python3
"""check_isa_symbols.py NM ISA OBJECT...: checks that objects for one instruction set define no function that others share.

The linker keeps one copy of an inline function or template. If std::vector<int>::push_back is also compiled with
AVX-512 and the linker keeps that copy, it crashes on every machine without AVX-512. So the name of each function that
such an object defines must contain its instruction set: a namespace tamis::ISA, or an xsimd architecture as parameter.
NM is the nm of the compiler that made the objects. Functions that the linker may share are T, W or i in ELF, T in COFF.
"""
import re
import subprocess
import sys

OWN_NAME = {
    "avx2": re.compile(r"\btamis::avx2::|\bxsimd::(avx2|fma3<xsimd::avx2>)"),
    "avx512": re.compile(r"\btamis::avx512::|\bxsimd::avx512"),
}


def shared_functions(nm: str, isa: str, path: str):
    listing = subprocess.run([nm, "--demangle", "--defined-only", "--extern-only", path],
                             check=True, capture_output=True, text=True).stdout
    for line in filter(None, listing.splitlines()):
        _, kind, name = line.split(" ", 2)
        if kind in "TWi" and not OWN_NAME[isa].search(name):
            yield name


def main() -> int:
    nm, isa, *objects = sys.argv[1:]
    if isa not in OWN_NAME:
        sys.exit(f"{isa}: say in OWN_NAME which names its objects may define")
    leaks = [(path, name) for path in objects for name in shared_functions(nm, isa, path)]
    for path, name in leaks:
        print(f"{path}: {name}")
    print(f"{len(objects)} objects, {len(leaks)} functions under a name that others share")
    return 1 if leaks or not objects else 0


if __name__ == "__main__":
    sys.exit(main())
