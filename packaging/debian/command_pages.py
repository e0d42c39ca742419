#!/usr/bin/env python3
"""command_pages.py COMMAND VERSION DATE FOLDER: writes the man page and the completions of a command, from its own help.

Makes in FOLDER: NAME.1, NAME.bash, _NAME (zsh) and NAME.fish. DATE is that of the man page.
"""
from __future__ import annotations

import dataclasses
import pathlib
import re
import subprocess
import sys

COLUMN = 30  # where CLI11 begins what a row says


@dataclasses.dataclass
class Row:
    head: str
    says: str = ""

    @property
    def names(self) -> list[str]:
        return self.head.split()[0].split(",")

    @property
    def takes(self) -> str:
        return self.head.partition(" ")[2]


@dataclasses.dataclass
class Help:
    summary: str
    usage: str
    sections: dict[str, list[Row]]
    examples: list[str]
    rest: list[str]

    def options(self) -> list[Row]:
        return self.sections.get("Options", [])


def rows_of(lines: list[str]) -> list[Row]:
    rows: list[Row] = []
    for line in lines:
        if line.startswith(" " * COLUMN):
            rows[-1].says = f"{rows[-1].says} {line.strip()}".strip()
        else:
            head, says = (line[2:COLUMN].rstrip(), line[COLUMN:]) if line[COLUMN - 1:COLUMN] == " " else (line[2:], "")
            rows.append(Row(head, says or ""))
    return rows


def help_of(command: str, *words: str) -> Help:
    text = subprocess.run([command, *words, "--help"], capture_output=True, text=True, check=True).stdout
    first, *blocks = [block.split("\n") for block in text.strip("\n").split("\n\n")]
    found = Help(first[0], first[1].removeprefix("Usage: "), {}, [], [])
    for title, *lines in blocks:
        if title == "Examples:":
            found.examples = [line.strip() for line in lines]
        elif title in ("Options:", "Positionals:", "Subcommands:"):
            found.sections[title[:-1]] = rows_of(lines)
        else:
            found.rest += [title, *lines]
    return found


def roff(text: str) -> str:
    escaped = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + escaped if escaped[:1] in (".", "'") else escaped


def listed(rows: list[Row]) -> list[str]:
    return [line for row in rows for line in (".TP", f".B {roff(row.head)}", roff(row.says or "."))]


def section(verb: str, text: Help) -> list[str]:
    lines = [f".SS {roff(verb)}", roff(text.summary), ".PP", f".B {roff(text.usage)}"]
    for title in ("Positionals", "Options"):
        lines += listed([row for row in text.sections.get(title, []) if "--help" not in row.names])
    if text.examples:
        lines += [".PP", "Examples:", ".PP", ".nf", *map(roff, text.examples), ".fi"]
    return lines + ([".PP", *map(roff, text.rest)] if text.rest else [])


def man_page(name: str, version: str, date: str, top: Help, verbs: dict[str, Help]) -> str:
    lines = [f'.TH {name.upper()} 1 {date} "{name} {version}" "User Commands"', ".SH NAME",
             f"{name} \\- {roff(top.summary.split(':')[0].removeprefix('Tamis '))}", ".SH SYNOPSIS",
             f".B {roff(top.usage)}", ".SH DESCRIPTION", roff(top.summary), ".PP", *map(roff, top.rest), ".SH OPTIONS",
             *listed(top.options()), ".SH SUBCOMMANDS"]
    for verb, text in verbs.items():
        lines += section(verb, text)
    return "\n".join(lines) + "\n"


def flags(text: Help) -> list[str]:
    return [name for row in text.options() for name in row.names]


def bash(name: str, top: Help, verbs: dict[str, Help]) -> str:
    cases = "\n".join(f'    {verb}) words="{" ".join(flags(text))}" ;;' for verb, text in verbs.items())
    return f"""\
# Completion of {name} for bash.
_{name}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words
  case ${{COMP_WORDS[1]}} in
{cases}
    *) words="{" ".join(flags(top))}" ;;
  esac
  if ((COMP_CWORD == 1)); then
    words+=" {" ".join(verbs)}"
  elif [[ $word != -* ]]; then
    compopt -o default
    words=
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -F _{name} {name}
"""


def quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


def zsh_option(row: Row) -> list[str]:
    says = re.sub(r"([\[\]:\\])", r"\\\1", row.says)
    value = f":{re.sub(r'[^A-Za-z]+', ' ', row.takes).strip().lower()}:_files" if row.takes else ""
    return [quoted(f"{name}[{says}]{value}") for name in row.names]


def zsh(name: str, top: Help, verbs: dict[str, Help]) -> str:
    says = "\n".join(f"  {quoted(verb + ':' + text.summary.replace(':', chr(92) + ':'))}" for verb, text in verbs.items())
    cases = "\n".join(f"    {verb}) _arguments {' '.join(o for row in text.options() for o in zsh_option(row))} '*:file:_files' ;;"
                      for verb, text in verbs.items())
    return f"""\
#compdef {name}
# Completion of {name} for zsh.
local -a verbs
verbs=(
{says}
)
if ((CURRENT == 2)); then
  _describe verb verbs
  _arguments {' '.join(o for row in top.options() for o in zsh_option(row))}
else
  local verb=$words[2]
  shift words
  ((CURRENT--))
  case $verb in
{cases}
  esac
fi
"""


def fish_option(row: Row) -> str:
    names = " ".join(f"-l {n[2:]}" if n.startswith("--") else f"-s {n[1:]}" for n in row.names)
    return f"{names}{' -r' if row.takes and not row.takes.startswith('[') else ''} -d {quoted(row.says)}"


def fish(name: str, top: Help, verbs: dict[str, Help]) -> str:
    lines = [f"# Completion of {name} for fish."]
    lines += [f"complete -c {name} -n __fish_use_subcommand {fish_option(row)}" for row in top.options()]
    lines += [f"complete -c {name} -n __fish_use_subcommand -f -a {verb} -d {quoted(text.summary)}" for verb, text in verbs.items()]
    lines += [f"complete -c {name} -n '__fish_seen_subcommand_from {verb}' {fish_option(row)}"
              for verb, text in verbs.items() for row in text.options()]
    return "\n".join(lines) + "\n"


def main() -> None:
    command, version, date, folder = sys.argv[1:]
    name = pathlib.Path(command).name
    top = help_of(command)
    verbs = {row.head: help_of(command, row.head) for row in top.sections["Subcommands"]}
    out = pathlib.Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    (out / f"{name}.1").write_text(man_page(name, version, date, top, verbs))
    (out / f"{name}.bash").write_text(bash(name, top, verbs))
    (out / f"_{name}").write_text(zsh(name, top, verbs))
    (out / f"{name}.fish").write_text(fish(name, top, verbs))


if __name__ == "__main__":
    main()
