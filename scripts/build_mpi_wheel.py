#!/usr/bin/env python3
"""build_mpi_wheel.py WORK BUILD: an environment with the module for Python and `tamis.distributed`, which is not shipped.

Makes WORK/ranks, after build_wheel.py: an environment with that module, mpi4py and pytest. The wheel uses the system's
MPI, which was found for BUILD. Exit code 77 if build_wheel.py found no tools.
"""

import pathlib
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
    ordinary.exit_with(main)
