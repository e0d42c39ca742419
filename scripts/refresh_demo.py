#!/usr/bin/env python3
"""Writes the demo's output into docs/demo.md, or checks that the page shows it, except for times and memory.

    scripts/refresh_demo.py                               runs scripts/demo.sh, writes docs/demo.md
    scripts/refresh_demo.py --check build/dev/bin/tamis   runs the demo's commands, compares docs/demo.md
"""
import argparse
import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/demo.md"
SHOWN = re.compile(r"(?<=```\n)\$ tamis scene.*?(?=\n```)", re.DOTALL)


def printed_by(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, cwd=ROOT).stdout


def as_shown(printed, tamis, frames):
    """Return the commands as a reader would type them in the clone, with their output."""
    text = printed[printed.index("\n$ ") + 1:].strip()
    page = f"browser: {(ROOT / frames).resolve()}"
    for found, shown in ((str(tamis), "tamis"), (page, "browser: …/out/demo"), (str(frames), "out/demo")):
        text = text.replace(found, shown)
    # Quote patterns, which the shell would expand.
    return re.sub(r"^(\$ .* )(\S*\?\S*)", r"\1'\2'", text, flags=re.MULTILINE)


def without_measurements(text):
    text = re.sub(r"^with .*$", "with …", text, flags=re.MULTILINE)
    return re.sub(r" +[0-9.]+ (us|ms|s)\b", " …", text)


def refresh():
    printed = as_shown(printed_by("scripts/demo.sh"), "build/release/bin/tamis", "out/demo")
    PAGE.write_text(SHOWN.sub(lambda _: printed, PAGE.read_text()))


def check(tamis):
    with tempfile.TemporaryDirectory() as folder:
        frames = pathlib.Path(folder, "demo").resolve()
        printed = as_shown(printed_by("scripts/demo_commands.sh", tamis, frames), tamis, frames)
    shown = SHOWN.search(PAGE.read_text())[0]
    lines = (without_measurements(text).splitlines() for text in (shown, printed))
    differences = list(difflib.unified_diff(*lines, "docs/demo.md", "what the demo prints", lineterm=""))
    if differences:
        sys.exit("\n".join([*differences, "docs/demo.md is out of date: run scripts/refresh_demo.py"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", metavar="TAMIS", type=lambda path: pathlib.Path(path).resolve(), help="the command")
    given = parser.parse_args()
    check(given.check) if given.check else refresh()


if __name__ == "__main__":
    main()
