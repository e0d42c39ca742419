#!/usr/bin/env python3
"""Runs scripts/demo.sh and puts what it prints in the README, so that the figures there are those of today."""
import pathlib
import re
import subprocess

root = pathlib.Path(__file__).resolve().parent.parent
printed = subprocess.run([root / "scripts/demo.sh"], check=True, capture_output=True, text=True).stdout
commands = printed[printed.index("$ build/release/bin/tamis"):].strip().replace("build/release/bin/tamis", "tamis").replace(str(root), "…")
# What the shell would do to a pattern without quotes.
commands = re.sub(r"^(\$ .* )(\S*\?\S*)", r"\1'\2'", commands, flags=re.MULTILINE)
readme = root / "README.md"
old = re.compile(r"(?<=```\n)\$ tamis scene.*?(?=\n```)", re.DOTALL)
readme.write_text(old.sub(lambda _: commands, readme.read_text()))
