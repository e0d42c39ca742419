#!/usr/bin/env python3
"""Tests scripts/check_prose.py: each limit can be exceeded, and code, tables and headings do not count."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from check_prose import Limits, faults, messages, prose, sentences

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
PARAMETERS = '"""Does one thing.\n\nParameters\n----------\nsize : int\n    Its size in rows.\n\n>>> what is it\n"""\n'
assert sentences(prose("a.py", PARAMETERS)) == ["Does one thing.", "Its size in rows."], sentences(prose("a.py", PARAMETERS))
THROWN = 'throw Error("a row is in vain: " +\n    row + "give one "\n    "row for each");  // in vain\n#include "in vain in vain in vain.hpp"\n'
assert sentences(messages("a.cpp", THROWN)) == ["a row is in vain:", "give one row for each"]
assert len(faults({"a.cpp": THROWN}, Limits(None, 14, 5, 0), messages)) == 1
print("check_prose.py finds what is planted")
