#!/usr/bin/env python3
"""hosts_environment.py WORK ARGUMENTS...: runs the Python of an environment with the programs that Tamis is put into.

After build_wheel.py, in WORK: `hosts`, an environment with that wheel, what python/requirements-hosts.txt pins, and the
tools of the tests. PyPI is asked when the requirements have changed, and not again. TAMIS_WHEEL tells the tests which
wheel it was. Exit code 77 if PyPI cannot be reached, or build_wheel.py had no tools.
"""

import os
import pathlib
import subprocess
import sys

import build_wheel as ordinary

HOSTS = ordinary.ROOT / "python" / "requirements-hosts.txt"


def make(work: pathlib.Path, wheel: pathlib.Path) -> pathlib.Path:
    python = work / "hosts" / "bin" / "python"
    packages = ordinary.Stamp(work / "hosts.stamp", HOSTS.read_bytes(), ordinary.REQUIREMENTS.read_bytes())
    if not packages.is_fresh() or not python.exists():
        python = ordinary.environment(work / "hosts")
        tools = ("pytest", "hypothesis", "pandas")
        ordinary.pip(work, "--python", python, "install", "--no-compile", "--only-binary", ":all:", "-r", HOSTS)
        ordinary.pip(work, "--python", python, "install", "--no-compile", "--find-links", work / "wheels", *tools)
        packages.set()
    ordinary.pip(work, "--python", python, "install", "--no-compile", "--no-index", "--no-deps", "--force-reinstall", wheel)
    return python


def main() -> None:
    work = pathlib.Path(sys.argv[1]).resolve()
    wheels = list((work / "dist").glob("*.whl"))
    if not (work / "user").exists() or len(wheels) != 1:
        print("skipped: build_wheel.py has found no tools")
        sys.exit(ordinary.SKIPPED)
    try:
        python = make(work, wheels[0])
    except subprocess.CalledProcessError:
        print("skipped: what python/requirements-hosts.txt names is not here, and PyPI cannot be reached")
        sys.exit(ordinary.SKIPPED)
    os.environ["TAMIS_WHEEL"] = str(wheels[0])
    os.execv(python, [str(python), *sys.argv[2:]])


if __name__ == "__main__":
    main()
