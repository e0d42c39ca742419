#!/usr/bin/env python3
"""doc_examples.py DOCUMENT LIBRARY INCLUDE COMPILER WORK: the document's C and Python blocks print what it says they do.

The Python one has nothing but ctypes and the library.
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
    blocks = dict((language, (code, output)) for language, code, output in re.findall(
        r"^```(c|python)\n(.*?)^```$.*?^```text\n(.*?)^```$", document.read_text(), re.DOTALL | re.MULTILINE))
    (work / "example.c").write_text(blocks["c"][0])
    (work / "example.py").write_text(blocks["python"][0])
    subprocess.run([compiler, "-std=c99", "-pedantic-errors", "-Wall", "-Werror", f"-I{include}", work / "example.c", "-o",
                    work / "example", f"-L{library.parent}", "-ltamis_c", f"-Wl,-rpath-link,{library.parent}"], check=True)
    commands = {"c": [work / "example"], "python": [sys.executable, work / "example.py"]}
    wrong = 0
    for language, command in commands.items():
        printed = printed_by(command, library)
        if printed != blocks[language][1]:
            print(f"{document}: the {language} block printed\n{printed}the document says\n{blocks[language][1]}")
            wrong += 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
