#!/usr/bin/env python3
"""carry_packages.py SOURCE: puts into SOURCE, Python's unpacked source distribution, the packages it needs besides a compiler.

That are the headers and sources of other packages, in SOURCE/third_party, where cmake/carried.cmake finds them, and their
licences, which the metadata then name. Headers are this machine's, sources come from Debian.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SYSTEM = pathlib.Path("/usr/include")
# By package of Debian: its licence, and its headers.
HEADERS = {"libcli11-dev": ("BSD-3-Clause", ["CLI"]), "libfast-float-dev": ("MIT", ["fast_float"]), "libfmt-dev": ("MIT", ["fmt"]),
           "nlohmann-json3-dev": ("MIT", ["nlohmann"]), "libboost-dev": ("BSL-1.0", []), "libxsimd-dev": ("BSD-3-Clause", []),
           "libeigen3-dev": ("MPL-2.0", ["Eigen/src/misc", "Eigen/src/plugins", *(f"Eigen/{folder}{module}" for folder in ("", "src/")
                                         for module in ("Cholesky", "Core", "Geometry", "Householder", "Jacobi", "LU", "QR", "SVD"))])}
SOURCES = {"zlib1g-dev": ("Zlib", "zlib", r"(adler32|compress|crc32|deflate|trees|zutil)\.c|(crc32|deflate|gzguts|trees|zconf|zlib|zutil)\.h"),
           "libmeshoptimizer-dev": ("MIT", "meshoptimizer", r"src/(allocator|simplifier)\.cpp|src/meshoptimizer\.h")}
LICENCES = {package: licence for package, (licence, *_) in {**HEADERS, **SOURCES}.items()}
FULL_TEXTS = {"Apache-2.0", "MPL-2.0"}  # Debian's copyright files only name these


def licence_texts(licences: "dict[str, str]") -> "dict[str, pathlib.Path]":
    """Return the licences of packages, by the names of the files to write."""
    texts = {f"{package}.txt": pathlib.Path("/usr/share/doc") / package / "copyright" for package in licences}
    if "libboost-dev" in licences:
        texts["libboost-dev.txt"] = ROOT / "packaging/debian/copyright"  # Debian's own for all of Boost has two megabytes
    return texts | {f"{name}.txt": pathlib.Path("/usr/share/common-licenses") / name for name in FULL_TEXTS & {*licences.values()}}


def expression(licences: "dict[str, str]") -> str:
    return " AND ".join(["MIT", *sorted({*licences.values()} - {"MIT"})])


def copy_headers(folder: pathlib.Path) -> None:
    subprocess.run([sys.executable, ROOT / "scripts/carry_headers.py", folder], check=True, stdout=subprocess.PIPE)
    for name in (name for _, names in HEADERS.values() for name in names):
        path = SYSTEM / ("eigen3" if name.startswith("Eigen") else "") / name
        if path.is_dir():
            shutil.copytree(path, folder / name)
        else:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, folder / name)


def copy_sources(folder: pathlib.Path) -> None:
    for _, package, files in SOURCES.values():
        (folder / package).mkdir()
        with tempfile.TemporaryDirectory() as unpacked:
            subprocess.run([ROOT / "scripts/debian_source.sh", package, unpacked], check=True, stdout=subprocess.PIPE)
            for path in sorted(pathlib.Path(unpacked).rglob("*")):
                if re.fullmatch(files, str(path.relative_to(unpacked))):
                    shutil.copyfile(path, folder / package / path.name)


def name_licences(source: pathlib.Path) -> None:
    licences = source / "third_party/licences"
    licences.mkdir()
    for name, text in licence_texts(LICENCES).items():
        shutil.copyfile(text.resolve(), licences / name)
    project = source / "pyproject.toml"
    named = f'license = "{expression(LICENCES)}"\nlicense-files = ["LICENSE", "third_party/licences/*"]'
    text, found = re.subn(r'^license = "MIT".*\nlicense-files = .*$', named, project.read_text(), flags=re.M)
    if not found:
        sys.exit("carry_packages.py: pyproject.toml names its licence otherwise than this script expects")
    project.write_text(text)


def carry(source: pathlib.Path) -> None:
    folder = source / "third_party"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    copy_headers(folder)
    copy_sources(folder)
    name_licences(source)


if __name__ == "__main__":
    carry(pathlib.Path(sys.argv[1]))
