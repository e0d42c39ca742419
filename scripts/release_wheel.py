#!/usr/bin/env python3
"""release_wheel.py WORK TARGET...: builds the wheels as they are shipped, and checks them. TARGETS below lists the targets.

Makes WORK/shipped: the source distribution, and a wheel for each target that serves CPython 3.10 and all later ones
(cp310-abi3), on Windows from 3.12 on. oneTBB and all other libraries are linked statically, as wheels of other packages bring a
oneTBB of their own. C++'s runtime is the system's: the module shares it with nanobind's backend. On Windows both are inside. The
same commit gives the same bytes in any folder (SOURCE_DATE_EPOCH). Checked by auditwheel, abi3audit, check-wheel-contents and twine.
"""

import itertools
import json
import os
import pathlib
import re
import shutil
import sys
import sysconfig
import tempfile
import zipfile

import build_wheel as ordinary
import carry_packages as carried
from build_wheel import ROOT, run

# The licences of what is compiled in besides what the source distribution carries, by package of Debian. GCC's libraries need
# no notice (the runtime exception).
LICENCES = {"libtbb-dev": "Apache-2.0"}
OF_MINGW = {"mingw-w64-x86-64-dev": "ZPL-2.1"}  # the C library's part that is linked, and threads
OF_WINDOWS = {"kernel32.dll", "msvcrt.dll", "python3.dll", "shell32.dll"}  # the DLLs that files for Windows may need


def copy_python(folder: pathlib.Path) -> pathlib.Path:
    """Copy Python's headers, with the settings of this processor: the stable ABI has the same ones on all 64-bit systems but Windows."""
    headers = pathlib.Path(sysconfig.get_path("include"))
    if not folder.exists():
        shutil.copytree(headers, folder)
        settings = pathlib.Path("/usr/include") / sysconfig.get_config_var("MULTIARCH") / headers.name / "pyconfig.h"
        shutil.copy(settings if settings.exists() else headers / "pyconfig.h", folder / "pyconfig.h")
    return folder


def add_licences(wheel: pathlib.Path, work: pathlib.Path) -> None:
    """Pack the licences of the compiled-in libraries into a wheel, and name them in its metadata."""
    python, unpacked = work / "tools/bin/python", work / "unpacked"
    shutil.rmtree(unpacked, ignore_errors=True)
    run(python, "-m", "wheel", "unpack", wheel, "--dest", unpacked)
    (root,) = unpacked.iterdir()
    (info,) = root.glob("*.dist-info")
    (nanobind,) = (work / "tools").glob("lib/python*/site-packages/nanobind-*.dist-info/licenses/LICENSE")
    licences = {**LICENCES, **(OF_MINGW if "win_amd64" in wheel.name else {})}
    for name, text in {**carried.licence_texts(licences), "nanobind.txt": nanobind}.items():
        shutil.copy(text.resolve(), info / "licenses" / name)
    files = sorted(path.relative_to(info / "licenses") for path in (info / "licenses").rglob("*") if path.is_file())
    head, _, rest = (info / "METADATA").read_text().partition("\n\n")
    lines = [line for line in head.splitlines() if not line.startswith("License-")]
    lines += [f"License-Expression: {carried.expression({**carried.LICENCES, **licences})}", *(f"License-File: {path}" for path in files)]
    (info / "METADATA").write_text("\n".join(lines) + "\n\n" + rest)
    run(python, "-m", "wheel", "pack", root, "--dest-dir", work / "shipped")


def linux(work: pathlib.Path, target: str) -> "list[str]":
    """Make what Debian's g++ links against; return definitions for CMake."""
    processor = target.partition("-")[2]
    run("scripts/old_glibc.py", work / f"glibc-{target}", processor, cwd=ROOT)
    return [f"CMAKE_TOOLCHAIN_FILE={ROOT}/cmake/manylinux.cmake", f"TAMIS_PROCESSOR={processor}",
            f"TAMIS_PACKAGES={work}/packages-{target}", f"TAMIS_OLD_GLIBC={work}/glibc-{target}"]


def nanobind_in(work: pathlib.Path) -> pathlib.Path:
    """Return the folder of nanobind's files for CMake, which does not look there where it finds packages of another system alone."""
    (folder,) = (work / "tools").glob("lib/python*/site-packages/nanobind/cmake")
    return folder


def macos(work: pathlib.Path, target: str) -> "list[str]":
    """Make zig's compilers; return definitions for CMake."""
    python = run("scripts/pinned.sh", "python", "zig", cwd=ROOT).strip()
    run(python, "scripts/apple_runtime.py", work / "zig", cwd=ROOT)
    return [f"CMAKE_TOOLCHAIN_FILE={ROOT}/cmake/zig.cmake", f"TAMIS_ZIG={work}/zig", "TAMIS_ZIG_SYSTEM=Darwin",
            "TAMIS_ZIG_PROCESSOR=arm64", "CMAKE_C_VISIBILITY_PRESET=hidden", "CMAKE_CXX_VISIBILITY_PRESET=hidden",
            "CMAKE_VISIBILITY_INLINES_HIDDEN=ON", f"TAMIS_ZIG_PACKAGES={work}/packages-{target}", f"CMAKE_STRIP={work}/zig/strip",
            f"nanobind_DIR={nanobind_in(work)}"]


def windows(work: pathlib.Path, target: str) -> "list[str]":
    """Get Python's headers and import library; return definitions for CMake."""
    run("scripts/windows_python.sh", work / "python-windows", cwd=ROOT)
    return [f"CMAKE_TOOLCHAIN_FILE={ROOT}/cmake/windows.cmake", f"TAMIS_WINDOWS_PACKAGES={work}/packages-{target}",
            f"TAMIS_WINDOWS_PYTHON={work}/python-windows", f"CMAKE_MODULE_PATH={ROOT}/cmake/windows_python",
            f"nanobind_DIR={nanobind_in(work)}"]


def prepare(work: pathlib.Path, target: str) -> "list[str]":
    """Make compilers and static libraries for a target; return definitions for CMake."""
    system, _ = TARGETS[target]
    defines = system(work, target)
    run("scripts/static_packages.sh", work / f"packages-{target}", "--tbb", *(f"-D{each}" for each in defines), cwd=ROOT)
    return defines


def build(work: pathlib.Path, source: pathlib.Path, target: str, checks: pathlib.Path) -> None:
    _, tag = TARGETS[target]
    defines = prepare(work, target)
    python = copy_python(work / f"packages-{target}" / "python")
    raw = ordinary.compile_wheel(
        work, source, f"raw-{target}",
        [*defines, f"Python_INCLUDE_DIR={python}", "TAMIS_TBB=ON", "CMAKE_UNITY_BUILD_BATCH_SIZE=0"], objects=f"objects-{target}")
    tags = zip(("--python-tag", "--abi-tag", "--platform-tag"), tag.split("-"))
    run(work / "tools/bin/python", "-m", "wheel", "tags", "--remove", *itertools.chain(*tags), raw)
    (raw,) = raw.parent.glob("*.whl")
    add_licences(raw, work)


TARGETS = {"linux-x86_64": (linux, "cp310-abi3-manylinux_2_28_x86_64"), "linux-aarch64": (linux, "cp310-abi3-manylinux_2_28_aarch64"),
           "macos-arm64": (macos, "cp310-abi3-macosx_11_0_arm64"), "windows-x86_64": (windows, "cp312-abi3-win_amd64")}


def check_dlls(wheel: pathlib.Path) -> str:
    """Return the DLLs that a wheel's files need, or end if Windows and Python 3 do not have one of them."""
    found = set()
    with zipfile.ZipFile(wheel) as files, tempfile.TemporaryDirectory() as folder:
        for name in files.namelist():
            if name.endswith((".pyd", ".dll", ".exe")):
                says = run("x86_64-w64-mingw32-objdump", "-p", files.extract(name, folder))
                found |= {line.split()[-1].lower() for line in says.splitlines() if "DLL Name:" in line}
    if "python3.dll" not in found or not found <= OF_WINDOWS:
        sys.exit(f"release_wheel.py: {wheel.name} needs {', '.join(sorted(found))}, and may need {', '.join(sorted(OF_WINDOWS))} alone")
    return f"{wheel.name} needs {', '.join(sorted(found))}"


def glibc_of(tag: str) -> "tuple[int, ...]":
    """Return the version of glibc that a tag such as manylinux_2_28_aarch64 names; infinity, without one."""
    found = re.search(r"manylinux_(\d+)_(\d+)_", tag)
    return (int(found[1]), int(found[2])) if found else (sys.maxsize,)


def check(work: pathlib.Path, checks: pathlib.Path) -> None:
    for wheel in sorted((work / "shipped").glob("*.whl")):
        if "manylinux" in wheel.name:
            found = json.loads(run(checks / "auditwheel", "show", "--json", wheel))
            print(f"{wheel.name}: auditwheel says {found['overall_tag']}, and needs {found['versioned_symbols']}")
            if glibc_of(found["overall_tag"]) > glibc_of(wheel.name):
                sys.exit(f"release_wheel.py: {wheel.name} does not keep what its name says")
        if "macosx" in wheel.name:
            python = run("scripts/pinned.sh", "python", "zig", cwd=ROOT).strip()
            print(run(python, "scripts/check_macos_wheel.py", wheel, nanobind_in(work) / "darwin-ld-cpython.sym", cwd=ROOT))
        if "win_amd64" in wheel.name:
            print(check_dlls(wheel))
        print(run(checks / "abi3audit", "--strict", "--summary", wheel))
        print(run(checks / "check-wheel-contents", "--ignore", "W008", wheel))  # W008: empty files are no fault
        print(f"{wheel.stat().st_size} bytes: {wheel.name}")
    print(run(checks / "twine", "check", "--strict", *sorted((work / "shipped").iterdir())))


def main() -> int:
    if not sys.argv[2:] or not {*sys.argv[2:]} <= TARGETS.keys():
        sys.exit(f"{__doc__}\nTARGETS: {', '.join(TARGETS)}")
    work = pathlib.Path(sys.argv[1]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("SOURCE_DATE_EPOCH", run("git", "log", "-1", "--format=%ct", cwd=ROOT).strip())
    checks = pathlib.Path(run("scripts/pinned.sh", "python", "wheels", cwd=ROOT).strip()).parent
    ordinary.make_tools(work)
    source = ordinary.make_source(work)
    shutil.rmtree(work / "shipped", ignore_errors=True)
    carried.carry(source)
    run(work / "tools/bin/python", "-m", "build", "--sdist", "--no-isolation", "--outdir", work / "shipped", source)
    for target in sys.argv[2:]:
        build(work, source, target, checks)
    check(work, checks)
    return 0


if __name__ == "__main__":
    ordinary.exit_with(main)
