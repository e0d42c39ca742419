#!/usr/bin/env python3
"""use_wheel.py WORK ENVIRONMENT ARGUMENTS...: runs the Python of an environment in WORK, such as `user` or `tools`.

build_wheel.py, build_mpi_wheel.py and build_host.py make the environments. Exit code 77 if it does not exist; the script
that should have made it has then said why.
"""
import os
import pathlib
import sys

python = pathlib.Path(sys.argv[1]) / sys.argv[2] / "bin" / "python"
if not python.exists():
    print(f"skipped: there is no {python}")
    sys.exit(77)
os.execv(python, [str(python), *sys.argv[3:]])
