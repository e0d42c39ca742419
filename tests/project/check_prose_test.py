#!/usr/bin/env python3
"""Tests scripts/check_prose.py: each limit can be exceeded, and code, tables and headings do not count."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from check_prose import Limits, faults, prose, sentences

PLAIN = "# What is a heading\n\nThis page is plain. It has two sentences.\n\n| what is the cell |\n\n```\nwhat is the code\n```\n"
WORDY = "This sentence goes on and on, " + "and on, " * 20 + "and names what is the thing of which it speaks.\n"
LIMITS = Limits(30, 14, 5, 2)

assert sentences(prose("a.md", PLAIN)) == ["This page is plain.", "It has two sentences."], sentences(prose("a.md", PLAIN))
assert faults({"a.md": PLAIN}, LIMITS) == []
assert len(faults({"a.md": WORDY}, LIMITS)) == 4, faults({"a.md": WORDY}, LIMITS)
assert sentences(prose("a.hpp", "int a;  // no doc comment\n/// Says one thing. Says\n/// another thing.\nint b = 1;\n")) == [
    "Says one thing.", "Says another thing."]
assert sentences(prose("a.py", '"""It documents one thing."""\nx = 1\n# It comments another thing.\n')) == [
    "It documents one thing.", "It comments another thing."]
print("check_prose.py finds what is planted")
