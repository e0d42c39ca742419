"""The command `tamis` of the wheel: the entry point that Python installs."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys


def main() -> None:
    """Replace this process by the command, with the same arguments."""
    command = pathlib.Path(__file__).resolve().parent / "command/bin" / ("tamis.exe" if os.name == "nt" else "tamis")
    if not command.exists():
        sys.exit(
            f"tamis: {command} is not there: this module was built without the command; "
            "build it again without -Ccmake.define.TAMIS_PYTHON_COMMAND=OFF"
        )
    if os.name == "nt":  # Windows cannot replace a process: the shell would go on before the command ends
        sys.exit(subprocess.call([command, *sys.argv[1:]]))
    os.execv(command, ["tamis", *sys.argv[1:]])
