#!/usr/bin/env python3
"""check_command_page.py COMMAND...: checks that docs/files-and-command.md names each verb, option and JSON key.

Verbs and options are those of the command's own help; keys are those of the answers to the command lines of
tools/command/tests/hostile/inputs.py.
"""
from __future__ import annotations

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools/command/tests/hostile"))
sys.dont_write_bytecode = True

import discovery  # noqa: E402
import inputs  # noqa: E402

PAGE = "docs/files-and-command.md"
TEXT = (ROOT / PAGE).read_text()


def section(title: str) -> str:
    return TEXT.split(f"## {title}\n", 1)[1].split("\n## ", 1)[0]


def groups() -> dict[str, list[str]]:
    """Return the verbs that the page calls by one word, as it says above its tables."""
    sentence = re.search(r'In the tables below (.*)', TEXT)[1]
    return {word: re.findall(r"`([\w-]+)`", verbs) for word, verbs in re.findall(r'"(\w+)" are ([^;.]*)', sentence)}


def named(title: str, name: str) -> dict[str, set[str]]:
    """Return what the tables of a section name in their first column, for each verb of their second column."""
    found: dict[str, set[str]] = {}
    for first, second in re.findall(r"^\| (`.*?) \| (.*?) \|", section(title).split("\n### Stages")[0], re.MULTILINE):
        for word in re.findall(r"[\w-]+", second):
            for verb in groups().get(word, [word]):
                found.setdefault(verb, set()).update(re.findall(name, first))
    return found


def answer_of(command: str, verb: discovery.Verb) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as folder:
        inputs.write_inputs(pathlib.Path(folder))
        words = [str(pathlib.Path(command).resolve()), *(inputs.baseline(verb) or [verb.name]), "--json"]
        answer = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    if answer.returncode == 2:
        sys.exit(f"{answer.stderr}{PAGE}: say in tools/command/tests/hostile/inputs.py how '{verb.name}' is asked")
    return json.loads(answer.stdout)


def faults(command: str, verb: discovery.Verb) -> list[str]:
    name = f"{pathlib.Path(command).name} {verb.name}"
    row = re.search(rf"^\| `{name}\b.*$", TEXT, re.MULTILINE)
    if not row:
        return [f"no row of the verbs begins with `{name}`"]
    options = named("Verbs", r"(--[\w-]+)").get(verb.name, set()) | set(re.findall(r"--[\w-]+", row[0])) | {"--json"}
    found = [f"{name}: no row names its option {option.name}" for option in verb.options if option.name not in options]
    if verb.has("--json"):
        keys = set(answer_of(command, verb)) - named("JSON keys", r"`(\w+)`").get(verb.name, set())
        found += [f"{name}: no row of the JSON keys names its key {key}" for key in sorted(keys)]
    return found


def main() -> int:
    asked = [(command, verb) for command in sys.argv[1:] for verb in discovery.verbs_of(command)]
    found = [fault for command, verb in asked for fault in faults(command, verb)]
    for fault in found:
        print(f"{PAGE}: {fault}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
