#!/usr/bin/env python3
"""build_mpi_wheel.py WORK BUILD: the module for Python with `tamis.distributed` in it, which is not shipped.

In WORK, after build_wheel.py: `ranks`, an environment with that module, mpi4py and the tools of its tests. It takes the
MPI that was found for BUILD from the system, and so is not repaired. Exit code 77 if build_wheel.py had no tools.
"""

import pathlib
import subprocess
import sys

import build_wheel as ordinary


def main() -> int:
    work, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    if not (work / "user").exists():
        print("skipped: build_wheel.py has found no tools")
        return ordinary.SKIPPED
    source = ordinary.make_source(work)
    built = [path.read_bytes() for path in sorted(build.glob("**/libtamis*.a"))]
    stamp = ordinary.Stamp(
        work / "ranks.stamp", ordinary.source_digest(source), ordinary.REQUIREMENTS.read_bytes(), *built
    )
    if stamp.is_fresh() and (work / "ranks").exists():
        return 0
    stamp.path.unlink(missing_ok=True)
    wheel = ordinary.compile_wheel(work, source, "raw_ranks", ordinary.with_libraries_of(build), mpi="ON")
    python = ordinary.environment(work / "ranks")
    ordinary.install(work, python, "-c", ordinary.REQUIREMENTS, wheel, "pytest", "mpi4py")
    stamp.set()
    print("installed into", work / "ranks")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as failure:
        print(failure.stdout or "", file=sys.stderr)
        sys.exit(f"build_mpi_wheel.py: failed: {' '.join(failure.cmd)}")
