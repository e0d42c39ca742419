#!/usr/bin/env python3
"""doc_examples.py DOCUMENT LIBRARY INCLUDE COMPILER WORK: checks that C and Python blocks print the text behind them.

Python blocks need only ctypes and the library.
"""
import os
import pathlib
import re
import subprocess
import sys


def printed_by(command: list, library: pathlib.Path) -> str:
    environment = {**os.environ, "LD_LIBRARY_PATH": str(library.parent)}
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


def main() -> int:
    document, library, include, compiler, work = (pathlib.Path(a) for a in sys.argv[1:])
    work.mkdir(parents=True, exist_ok=True)
    wrong = 0
    for number, (language, code, said) in enumerate(re.findall(
            r"^```(c|python)\n(.*?)^```$.*?^```text\n(.*?)^```$", document.read_text(), re.DOTALL | re.MULTILINE)):
        source = work / f"example_{number}.{language}"
        source.write_text(code)
        command = [sys.executable, source]
        if language == "c":
            command = [source.with_suffix("")]
            subprocess.run([compiler, "-std=c99", "-pedantic-errors", "-Wall", "-Werror", f"-I{include}", source, "-o", *command,
                            f"-L{library.parent}", "-ltamis_c", f"-Wl,-rpath-link,{library.parent}"], check=True)
        printed = printed_by(command, library)
        if printed != said:
            print(f"{document}: {language} block {number} printed\n{printed}the document says\n{said}")
            wrong += 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
