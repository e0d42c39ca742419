#!/usr/bin/env python3
"""release_archive.py WORK FOLDER PROCESSOR: installs the contents of a release's archive for Linux into FOLDER, and tries it.

That is the shared library, the C interface, headers, licences, and files for CMake and pkg-config. PROCESSOR is x86_64 or
aarch64. Compilers and oneTBB are the wheels' (scripts/release_wheel.py): the files work with glibc 2.28 and GCC 8's libstdc++.
WORK may be the same folder. The README's example runs with the files, for another processor by qemu.
"""

import pathlib
import platform
import re
import shutil
import sys

from build_wheel import ROOT, exit_with, make_tools, run
from carry_packages import licence_texts
from release_wheel import prepare

NEWEST = (2, 28)
INSIDE = {"libtbb-dev": "Apache-2.0", "libxsimd-dev": "BSD-3-Clause"}
OWN = re.compile(r"\w* *\w (typeinfo (name )?for |vtable for |VTT for |non-virtual thunk to )?(tamis(::|_)|TAMIS_)")
SETTINGS = ["CMAKE_BUILD_TYPE=Release", "BUILD_SHARED_LIBS=ON", "TAMIS_TBB=ON", "TAMIS_BUILD_TOOLS=OFF", "TAMIS_BUILD_LAB=OFF",
            "TAMIS_BUILD_TESTS=OFF", "CMAKE_UNITY_BUILD_BATCH_SIZE=0", "CMAKE_INSTALL_LIBDIR=lib",
            "CMAKE_BUILD_RPATH_USE_ORIGIN=ON"]  # a build's identity has no name of its folder


def install(work: pathlib.Path, folder: pathlib.Path, processor: str) -> None:
    build = work / f"archive-{processor}"
    defines = [f"-D{each}" for each in (*prepare(work, f"linux-{processor}"), *SETTINGS)]
    run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *defines)
    run("cmake", "--build", build)
    shutil.rmtree(folder, ignore_errors=True)
    for component in ("library", "development", "licence"):
        run("cmake", "--install", build, "--component", component, "--prefix", folder, "--strip")
    licences = folder / "share/doc/tamis/licences"
    licences.mkdir(parents=True)
    for name, text in licence_texts(INSIDE).items():
        shutil.copy(text.resolve(), licences / name)


def check_symbols(folder: pathlib.Path) -> None:
    """Check that the libraries show Tamis's functions alone, and need no newer glibc."""
    libraries = sorted(folder.glob("lib/*.so.*.*.*"))
    if [library.name.partition(".")[0] for library in libraries] != ["libtamis", "libtamis_c"]:
        sys.exit(f"release_archive.py: {folder}/lib has not the two libraries, but {[library.name for library in libraries]}")
    for library in libraries:
        shown = run("nm", "-DC", "--defined-only", library).splitlines()
        foreign = [line for line in shown if not OWN.match(line)]
        if foreign or not shown:
            sys.exit(f"release_archive.py: {library.name} shows {len(shown)} symbols, of which not its own: {foreign[:3]}")
        needed = {tuple(map(int, v.split("."))) for v in re.findall(r"GLIBC_([\d.]+)", run("objdump", "-T", library))}
        if not needed or max(needed) > NEWEST:
            sys.exit(f"release_archive.py: {library.name} needs glibc {needed}, and {NEWEST} is the newest that it may need")


def try_examples(work: pathlib.Path, folder: pathlib.Path, processor: str) -> None:
    here = processor == platform.machine()
    start = [] if here else [f"qemu-{processor}", "-L", f"/usr/{processor}-linux-gnu"]
    for suffix, compiler, library in (("cpp", "g++", "tamis"), ("c", "gcc", "tamis_c")):
        program, standard = work / f"hello-{suffix}-{processor}", ["-std=c++20"] if suffix == "cpp" else []
        run(f"{processor}-linux-gnu-{compiler}", *standard, ROOT / f"examples/hello.{suffix}", f"-I{folder}/include",
            f"-L{folder}/lib", f"-l{library}", f"-Wl,-rpath,{folder}/lib", "-o", program)
        if run(*start, program) != (ROOT / f"examples/output/hello.{suffix}.txt").read_text():
            sys.exit(f"release_archive.py: examples/hello.{suffix} prints something else with {folder}")


def main() -> int:
    if len(sys.argv) != 4 or sys.argv[3] not in ("x86_64", "aarch64"):
        sys.exit(__doc__)
    work, folder, processor = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
    work.mkdir(parents=True, exist_ok=True)
    make_tools(work)
    install(work, folder, processor)
    check_symbols(folder)
    try_examples(work, folder, processor)
    return 0


if __name__ == "__main__":
    exit_with(main)
