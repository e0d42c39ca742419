#!/usr/bin/env python3
"""Writes the demo's output into the README, or checks that the README shows it, except for times and memory.

    scripts/refresh_readme.py                               runs scripts/demo.sh, writes README.md
    scripts/refresh_readme.py --check build/dev/bin/tamis   runs the demo's commands, compares README.md
"""
import argparse
import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
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
    readme = ROOT / "README.md"
    printed = as_shown(printed_by("scripts/demo.sh"), "build/release/bin/tamis", "out/demo")
    readme.write_text(SHOWN.sub(lambda _: printed, readme.read_text()))


def check(tamis):
    with tempfile.TemporaryDirectory() as folder:
        frames = pathlib.Path(folder, "demo").resolve()
        printed = as_shown(printed_by("scripts/demo_commands.sh", tamis, frames), tamis, frames)
    shown = SHOWN.search((ROOT / "README.md").read_text())[0]
    lines = (without_measurements(text).splitlines() for text in (shown, printed))
    differences = list(difflib.unified_diff(*lines, "README.md", "what the demo prints", lineterm=""))
    if differences:
        sys.exit("\n".join([*differences, "README.md is not of today: scripts/refresh_readme.py writes it anew"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", metavar="TAMIS", type=lambda path: pathlib.Path(path).resolve(), help="the command")
    asked = parser.parse_args()
    check(asked.check) if asked.check else refresh()


if __name__ == "__main__":
    main()
