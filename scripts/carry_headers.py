#!/usr/bin/env python3
"""carry_headers.py FOLDER: copies the headers of Boost and xsimd that the library needs into FOLDER, and a package file of xsimd for
CMake. Prints both versions. The headers are this machine's: CARRIED_HEADERS, or /usr/include.

Boost's headers are those that includes name, for every compiler and system, and those that this machine's compiler reads: some
includes are computed."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SYSTEM = pathlib.Path(os.environ.get("CARRIED_HEADERS", "/usr/include"))
# An include, or a macro that an include names.
NAMED = re.compile(r'^[ \t]*#[ \t]*(?:include|define[ \t]+\w+)[ \t]*[<"](boost/[^>"]+)[>"]', re.MULTILINE)
# Folders whose files' names includes put together.
COMPUTED = ("boost/mpl/aux_/preprocessed/gcc", "boost/mpl/aux_/preprocessed/plain")


def named_from(*first: str) -> set[str]:
    found, queue = set(), [*first]
    while queue:
        name = queue.pop()
        if name not in found and (SYSTEM / name).is_file():
            found.add(name)
            queue += NAMED.findall((SYSTEM / name).read_text(errors="replace"))
    return found


def read_by_compiler(first: str) -> set[str]:
    command = [*shlex.split(os.environ.get("CXX", "c++")), "-std=c++20", "-M", "-x", "c++", "-I", SYSTEM, "-"]
    listed = subprocess.run(command, input=f"#include <{first}>\n", text=True, capture_output=True, check=True).stdout
    return set(re.findall(rf"{re.escape(str(SYSTEM))}/(boost/\S+)", listed))


def copy_boost(folder: pathlib.Path) -> str:
    first = re.search(r"find_path\(Boost_INCLUDE_DIR (\S+)\)", (ROOT / "cmake/FindBoostHeaders.cmake").read_text())[1]
    if not (SYSTEM / first).is_file():
        sys.exit(f"carry_headers.py: {SYSTEM} has no {first}: install Boost's headers (Debian: libboost-dev), or set CARRIED_HEADERS")
    names = named_from(first, "boost/version.hpp") | read_by_compiler(first)
    names |= {str(path.relative_to(SYSTEM)) for each in COMPUTED for path in (SYSTEM / each).glob("*.hpp")}
    for name in sorted(names):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(SYSTEM / name, folder / name)
    return re.search(r'BOOST_LIB_VERSION "([\d_]+)"', (folder / "boost/version.hpp").read_text())[1].replace("_", ".")


def copy_xsimd(folder: pathlib.Path) -> str:
    if not (SYSTEM / "xsimd").is_dir():
        sys.exit(f"carry_headers.py: {SYSTEM} has no xsimd: install it (Debian: libxsimd-dev), or set CARRIED_HEADERS")
    shutil.copytree(SYSTEM / "xsimd", folder / "xsimd")
    text = (folder / "xsimd/config/xsimd_config.hpp").read_text()
    version = ".".join(re.search(rf"XSIMD_VERSION_{part} (\d+)", text)[1] for part in ("MAJOR", "MINOR", "PATCH"))
    (folder / "xsimdConfig.cmake").write_text(
        f"set(xsimd_VERSION {version})\n"
        "if(NOT TARGET xsimd)\n"
        "  add_library(xsimd INTERFACE IMPORTED)\n"
        '  set_target_properties(xsimd PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}")\n'
        "endif()\n")
    return version


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    print(f"Boost {copy_boost(folder)}, xsimd {copy_xsimd(folder)}")


if __name__ == "__main__":
    main()
