#!/usr/bin/env python3
"""use_wheel.py WORK ENVIRONMENT ARGUMENTS...: runs a Python that build_wheel.py made in WORK: `user` or `tools`.

Exit code 77 if it is not there, which build_wheel.py has then explained.
"""
import os
import pathlib
import sys

python = pathlib.Path(sys.argv[1]) / sys.argv[2] / "bin" / "python"
if not python.exists():
    print(f"skipped: there is no {python}")
    sys.exit(77)
os.execv(python, [str(python), *sys.argv[3:]])
