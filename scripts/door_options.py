"""The options of every door, read from its sources, for check_questions.py."""
from __future__ import annotations

import ast
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
POSITIONS_IN_C = {"start", "end", "start_stride", "end_stride", "vertex_count"}


def text(place: str) -> str:
    return (ROOT / place).read_text().replace("[[nodiscard]] ", "")


def members(header: str, struct: str) -> set[str]:
    """Return the names of a struct's data members; in C without `size`."""
    body = re.search(rf"^(?:typedef )?struct {struct} {{\n(.*?)^}}", text(header), re.DOTALL | re.MULTILINE)[1]
    body = re.sub(r"//[^\n]*|/\*.*?\*/", "", body, flags=re.DOTALL)
    plain = set(re.findall(r"^  (?!static )[^;=]*\b(\w+)(?: = [^;]*)?;", body, re.MULTILINE))
    return (plain | set(re.findall(r"\(\*(\w+)\)\(", body))) - {"size"}


def keywords(owner: str, function: str, place: str) -> set[str]:
    """Return the keyword-only arguments of a method of a Python class."""
    classes = (node for node in ast.parse(text(place)).body if isinstance(node, ast.ClassDef) and node.name == owner)
    items = (item for node in classes for item in node.body if isinstance(item, ast.FunctionDef))
    methods = [item for item in items if item.name == function]
    return {argument.arg for argument in methods[-1].args.kwonlyargs}


def command_options(owner: str) -> set[str]:
    """Return what the classes of options that verbs share declare."""
    source = text("tools/command/command_line/arguments.cpp")
    found: set[str] = set()
    for body in re.findall(rf"^void {owner}::declare.*?^}}", source, re.DOTALL | re.MULTILINE):
        for called in re.findall(r"(declare_\w+)\(options, \w+_\)", body):
            body += re.search(rf"^void {called}\(.*?^}}", source, re.DOTALL | re.MULTILINE)[0]
        found |= set(re.findall(r'"(--[\w-]+)"', body))
    return found


def options() -> dict[str, list[set[str]]]:
    """Return the options of each column of each table of options, by the table's title."""
    header, detectors, worlds = "include/tamis/options.hpp", "bindings/python/tamis/_detector", "bindings/python/tamis/_world"
    return {
        "Options of a detector or a world": [
            (members(header, "Options") | members(header, "PairFilter")) - {"filter"},
            keywords("Detector", "__init__", f"{detectors}/_detector.py"),
            members("include/tamis/c/detector.h", "tamis_options"),
            keywords("World", "__init__", f"{worlds}/_world.py"),
            members("include/tamis/c/world.h", "tamis_world_options"),
            command_options("DetectorArguments"),
            keywords("Detector", "__init__", "bindings/python/tamis/distributed.py") - {"edges", "points"},
        ],
        "Options of a question": [
            members(header, "QueryOptions"),
            members(header, "PathOptions"),
            keywords("InMotion", "contacts", f"{detectors}/_in_motion.py"),
            members("include/tamis/c/answers.h", "tamis_step") - POSITIONS_IN_C,
            members("include/tamis/c/path.h", "tamis_path_options"),
            command_options("AtStartArgument"),
        ],
    }


def unnamed() -> list[str]:
    """Return where a page or a docstring of Python lacks a keyword of what it describes."""
    found = []
    for owner, source in (("Detector", "_detector/_detector.py"), ("World", "_world/_world.py")):
        place = f"bindings/python/tamis/{source}"
        row = re.search(rf"^\| `{owner}\((.*?)\)`", text("docs/python.md"), re.MULTILINE)[1]
        nodes = {node.name: node for node in ast.parse(text(place)).body if isinstance(node, ast.ClassDef)}
        parameters = re.findall(r"^([\w, ]+) : ", ast.get_docstring(nodes[owner]), re.MULTILINE)
        pages = {f"docs/python.md, {owner}": row, f"{place}, docstring": ",".join(parameters)}
        for page, named in pages.items():
            missing = keywords(owner, "__init__", place) - set(re.findall(r"\w+", named))
            found += [f"{page}: nothing names {name}" for name in sorted(missing)]
    return found
