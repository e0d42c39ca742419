"""Reads verbs and options from the command's own help, so that new ones are attacked without being listed."""
import dataclasses
import re
import subprocess

ROW = re.compile(r"^  (?:-\w,)?(--[\w-]+|[A-Z_]+)(?: (\S.*?))?(?:  +.*)?$")
# How the help shows numbers: by tools/command/number_option.hpp ("N from 1 to 9", "S >= 0,..."), or by CLI11 itself.
NUMBER = re.compile(r"^([A-Z]\b|INT|UINT|FLOAT)")


@dataclasses.dataclass
class Option:
    name: str
    takes: str  # its value as the help shows it: "N >= 0", "FILE.csv"; empty for a flag

    @property
    def is_flag(self):
        return not self.takes

    @property
    def is_number(self):
        return bool(NUMBER.match(self.takes))

    @property
    def is_output_file(self):
        return self.name.startswith("--out") and "FOLDER" not in self.takes

    @property
    def is_output_folder(self):
        return self.name.startswith("--out") and "FOLDER" in self.takes


@dataclasses.dataclass
class Verb:
    name: str
    positionals: list
    options: list

    def has(self, name):
        return any(option.name == name for option in self.options)


def help_of(command, *words):
    return subprocess.run([command, *words, "--help"], capture_output=True, text=True, check=True).stdout


def rows_of(text, title):
    """Return name and value of each row below `title:`, up to the next empty line."""
    lines = text.split("\n")
    if f"{title}:" not in lines:
        return []
    rows = []
    for line in lines[lines.index(f"{title}:") + 1:]:
        if not line:
            break
        row = ROW.match(line)
        if row:
            rows.append((row[1], (row[2] or "").replace(" REQUIRED", "").strip()))
    return rows


def verb_of(command, name):
    text = help_of(command, name)
    positionals = [row[0] for row in rows_of(text, "Positionals")]
    options = [Option(*row) for row in rows_of(text, "Options") if row[0] != "--help"]
    return Verb(name, positionals, options)


def verbs_of(command):
    text = help_of(command)
    names = re.findall(r"^  ([a-z][\w-]*) ", text[text.index("Subcommands:"):], re.MULTILINE)
    if not names:
        raise SystemExit("hostile: tamis --help lists no verb: has its form changed?")
    return [verb_of(command, name) for name in names]
