#!/usr/bin/env python3
"""release_wheel.py WORK TARGET...: builds the wheels as they are shipped, and checks them. TARGETS below lists the targets.

Makes WORK/shipped: the source distribution, and a wheel for each target that serves CPython 3.10 and all later ones
(cp310-abi3). oneTBB and all other libraries are linked statically, as wheels of other packages bring a oneTBB of their own. C++'s
runtime is the system's: the module shares it with nanobind's backend. The same commit gives the same bytes in any folder
(SOURCE_DATE_EPOCH). Checked by auditwheel, abi3audit, check-wheel-contents and twine.
"""

import os
import pathlib
import shutil
import sys
import sysconfig

import build_wheel as ordinary
from build_wheel import ROOT, run

# The licences of what is compiled in, by package of Debian. Boost's asks for no notice in compiled code, nor do those of GCC's
# libraries (the runtime exception).
LICENCES = {"libcli11-dev": "BSD-3-Clause", "libeigen3-dev": "MPL-2.0", "libfmt-dev": "MIT", "libmeshoptimizer-dev": "MIT",
            "libtbb-dev": "Apache-2.0", "libxsimd-dev": "BSD-3-Clause", "nlohmann-json3-dev": "MIT", "zlib1g-dev": "Zlib"}
FULL_TEXTS = {"Apache-2.0", "MPL-2.0"}  # Debian's copyright files only name these


def copy_python(folder: pathlib.Path) -> pathlib.Path:
    """Copy Python's headers, with the settings of this processor: the stable ABI has the same ones on all 64-bit systems but Windows."""
    headers = pathlib.Path(sysconfig.get_path("include"))
    if not folder.exists():
        shutil.copytree(headers, folder)
        settings = pathlib.Path("/usr/include") / sysconfig.get_config_var("MULTIARCH") / headers.name / "pyconfig.h"
        shutil.copy(settings if settings.exists() else headers / "pyconfig.h", folder / "pyconfig.h")
    return folder


def licence_texts(packages: "list[str]") -> "dict[str, pathlib.Path]":
    """Return the licences of packages, by the names of the files to write."""
    texts = {f"{package}.txt": pathlib.Path("/usr/share/doc") / package / "copyright" for package in packages}
    return texts | {f"{name}.txt": pathlib.Path("/usr/share/common-licenses") / name for name in FULL_TEXTS & {LICENCES[p] for p in packages}}


def add_licences(wheel: pathlib.Path, work: pathlib.Path) -> None:
    """Pack the licences of what is compiled in into a wheel, and name them in its metadata."""
    python, unpacked = work / "tools/bin/python", work / "unpacked"
    shutil.rmtree(unpacked, ignore_errors=True)
    run(python, "-m", "wheel", "unpack", wheel, "--dest", unpacked)
    (root,) = unpacked.iterdir()
    (info,) = root.glob("*.dist-info")
    (nanobind,) = (work / "tools").glob("lib/python*/site-packages/nanobind-*.dist-info/licenses/LICENSE")
    for name, text in {**licence_texts([*LICENCES]), "nanobind.txt": nanobind}.items():
        shutil.copy(text.resolve(), info / "licenses" / name)
    expression = " AND ".join(["MIT", *sorted({*LICENCES.values()} - {"MIT"})])
    head, _, rest = (info / "METADATA").read_text().partition("\n\n")
    lines = [line for line in head.splitlines() if not line.startswith("License-")]
    lines += [f"License-Expression: {expression}", *(f"License-File: {p.name}" for p in sorted((info / "licenses").iterdir()))]
    (info / "METADATA").write_text("\n".join(lines) + "\n\n" + rest)
    run(python, "-m", "wheel", "pack", root, "--dest-dir", work / "shipped")


def linux(work: pathlib.Path, target: str) -> "list[str]":
    """Make what Debian's g++ links against; return definitions for CMake."""
    processor = target.partition("-")[2]
    run("scripts/old_glibc.py", work / f"glibc-{target}", processor, cwd=ROOT)
    return [f"CMAKE_TOOLCHAIN_FILE={ROOT}/cmake/manylinux.cmake", f"TAMIS_PROCESSOR={processor}",
            f"TAMIS_PACKAGES={work}/packages-{target}", f"TAMIS_OLD_GLIBC={work}/glibc-{target}"]


def macos(work: pathlib.Path, target: str) -> "list[str]":
    """Make zig's compilers; return definitions for CMake."""
    python = run("scripts/pinned.sh", "python", "zig", cwd=ROOT).strip()
    run(python, "scripts/apple_runtime.py", work / "zig", cwd=ROOT)
    (nanobind,) = (work / "tools").glob("lib/python*/site-packages/nanobind/cmake")
    return [f"CMAKE_TOOLCHAIN_FILE={ROOT}/cmake/zig.cmake", f"TAMIS_ZIG={work}/zig", "TAMIS_ZIG_SYSTEM=Darwin",
            "TAMIS_ZIG_PROCESSOR=arm64", f"TAMIS_ZIG_PACKAGES={work}/packages-{target}", f"CMAKE_STRIP={work}/zig/strip",
            f"nanobind_DIR={nanobind}"]


def prepare(work: pathlib.Path, target: str) -> "list[str]":
    """Make compilers and static libraries for a target; return definitions for CMake."""
    system, _ = TARGETS[target]
    defines = system(work, target)
    run("scripts/static_packages.sh", work / f"packages-{target}", "--tbb", "--zlib", *(f"-D{each}" for each in defines), cwd=ROOT)
    return defines


def build(work: pathlib.Path, source: pathlib.Path, target: str, checks: pathlib.Path) -> None:
    _, tag = TARGETS[target]
    defines = prepare(work, target)
    python = copy_python(work / f"packages-{target}" / "python")
    raw = ordinary.compile_wheel(
        work, source, f"raw-{target}",
        [*defines, f"Python_INCLUDE_DIR={python}", "TAMIS_TBB=ON", "CMAKE_UNITY_BUILD_BATCH_SIZE=0"], objects=f"objects-{target}")
    plain = tag.replace("manylinux_2_28", "linux")
    run(work / "tools/bin/python", "-m", "wheel", "tags", "--remove", "--platform-tag", plain, raw)
    (raw,) = raw.parent.glob("*.whl")
    if plain != tag:  # checks, too, that the wheel keeps what its name says
        run(checks / "auditwheel", "repair", "--plat", tag, "--only-plat", "--wheel-dir", raw.parent, raw,
            env={**os.environ, "PATH": f"{checks}:{os.environ['PATH']}"})
        raw.unlink()
        (raw,) = raw.parent.glob("*.whl")
    add_licences(raw, work)


TARGETS = {"linux-x86_64": (linux, "manylinux_2_28_x86_64"), "linux-aarch64": (linux, "manylinux_2_28_aarch64"),
           "macos-arm64": (macos, "macosx_11_0_arm64")}


def check(work: pathlib.Path, checks: pathlib.Path) -> None:
    for wheel in sorted((work / "shipped").glob("*.whl")):
        if "manylinux" in wheel.name:
            print(run(checks / "auditwheel", "show", wheel))
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
    shutil.copytree(work / "sdist", work / "shipped")
    for target in sys.argv[2:]:
        build(work, source, target, checks)
    check(work, checks)
    return 0


if __name__ == "__main__":
    ordinary.exit_with(main)
