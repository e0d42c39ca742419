#!/usr/bin/env python3
"""Checks that docs/questions.md lists exactly the questions and options of every door.

Also that tests of all questions ask all. A door is an interface of Tamis: C++, Python, C, the command, MPI.
"""
from __future__ import annotations

import ast
import re
import sys

from door_options import ROOT, options, text, unnamed

PAGE = "docs/questions.md"
HINT = " (what is no question stands in NO_QUESTIONS of scripts/check_questions.py)"
DETECTOR = "include/tamis/detector.hpp"
# Sources of tests that must ask every question of a detector.
ASK_ALL = ("tests/support/every_question.cpp", "tests/support/as_new.hpp")
# Functions of doors that are no questions: they make, change or read.
NO_QUESTIONS = {
    *("add", "add_many", "move", "move_many", "motion", "remove", "set_enabled", "set_may_touch", "set_radius"),
    *("mesh", "options", "statistics", "vertex_count", "balance"),
    *("bench", "info", "scene", "view"),
}
NO_QUESTIONS_IN_C = re.compile(
    r"_(create|(?<!_is_)free|message|statistics|copy_\w+|(?<!world_)points_at|add|move|remove|set_\w+)$|^tamis_(mesh_|version|turned_|chain_|nlerp_|pose_(of_|at)|weights_of)"
)


def methods(header: str, owner: str) -> set[str]:
    """Return the names of a C++ class' methods that return something."""
    body = re.search(rf"^class {owner} {{\n(.*?)^(?: private:|}};)", text(header), re.DOTALL | re.MULTILINE)[1]
    return set(re.findall(r"^  (?!explicit|return)[\w:<>&*, ]+ [&*]?(\w+)\([^;]*;", body, re.MULTILINE))


def functions(header: str) -> set[str]:
    return set(re.findall(r"^[\w:<>]+(?: [\w:<>]+)* (\w+)\(", text(header), re.MULTILINE))


def python_methods(owner: str, *places: str) -> set[str]:
    """Return the public methods of a Python class and of its bases."""
    sources = [ast.parse(file.read_text()) for place in places for file in (ROOT / "bindings/python/tamis").glob(place)]
    classes = {node.name: node for source in sources for node in source.body if isinstance(node, ast.ClassDef)}

    def of(node: ast.ClassDef) -> set[str]:
        own = {item.name for item in node.body if isinstance(item, ast.FunctionDef) and item.name[0] != "_"}
        return own.union(*(of(classes[base.id]) for base in node.bases if isinstance(base, ast.Name)))

    return of(classes[owner])


def python_functions(names: set[str]) -> set[str]:
    """Return the names that the Python module exports, out of `names`."""
    listed = re.search(r"^__all__ = (\[.*?\])", text("bindings/python/tamis/__init__.py"), re.DOTALL | re.MULTILINE)[1]
    return names & set(ast.literal_eval(listed))


def c_functions(prefix: str) -> set[str]:
    found: set[str] = set()
    for header in (ROOT / "include/tamis/c").glob("*.h"):
        found |= set(re.findall(r"^TAMIS_API[\w \*]* \*?(tamis_\w+)\(", header.read_text(), re.MULTILINE))
    found = {name for name in found if not NO_QUESTIONS_IN_C.search(name)}
    owners = ("tamis_detector_", "tamis_world_")
    return {name for name in found if name.startswith(prefix or "tamis_") and (prefix or not name.startswith(owners))}


def verbs(folder: str) -> set[str]:
    found: set[str] = set()
    for source in (ROOT / folder).rglob("*.?pp"):
        found |= set(re.findall(r'name\(\) const override \{ return "([\w-]+)"', source.read_text()))
    return found


def doors() -> dict[str, list[set[str]]]:
    """Return the questions of each column of each table of the page, by the table's title."""
    pair_headers = ("include/tamis/pair.hpp", "include/tamis/pair_distance.hpp", "include/tamis/path.hpp")
    of_pairs = set().union(*map(functions, pair_headers))
    distributed = methods("distributed/include/tamis/distributed.hpp", "Detector")
    if distributed - NO_QUESTIONS != python_methods("Detector", "distributed.py", "_ranks/*.py") - NO_QUESTIONS:
        sys.exit("tamis/distributed.hpp and tamis.distributed differ in their questions")
    command = verbs("tools/command/verbs")
    return {
        "One mesh": [
            methods(DETECTOR, "Detector"),
            python_methods("Detector", "_detector/*.py"),
            c_functions("tamis_detector_"),
            command - {"bodies"},
            distributed,
        ],
        "Bodies": [
            methods("include/tamis/world.hpp", "World"),
            python_methods("World", "_world/*.py"),
            c_functions("tamis_world_"),
            command & {"bodies"},
        ],
        "A pair, or a list of pairs": [
            of_pairs,
            python_functions(of_pairs),
            c_functions(""),
        ],
    }


def tables() -> dict[str, list[list[str]]]:
    """Return the rows of each table of the page, the head first, by the table's title."""
    found = {}
    for part in text(PAGE).split("\n## ")[1:]:
        title, _, body = part.partition("\n")
        lines = [line for line in body.splitlines() if line.startswith("|")]
        found[title] = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if "---" not in line]
    return found


def faults() -> list[str]:
    found = []
    pages = tables()
    for title, columns in (doors() | options()).items():
        head, *rows = pages[title]
        hint = "" if title.startswith("Options") else HINT
        for number, offered in enumerate(columns, start=1):
            named = set(re.findall(r"`([\w-]+)`", " ".join(row[number] for row in rows)))
            offered = offered - NO_QUESTIONS
            found += [f"{title}, {head[number]}: no row names {name}{hint}" for name in sorted(offered - named)]
            found += [f"{title}, {head[number]}: there is no {name}" for name in sorted(named - offered)]
        for row in rows:
            if "-" in row and not any(row[len(columns) + 1 :]):
                found.append(f"{title}, {row[0]}: say why some door lacks it")
    return found


def unasked() -> list[str]:
    return [
        f"{place}: nobody asks {name}"
        for place in ASK_ALL
        for name in sorted(methods(DETECTOR, "Detector") - NO_QUESTIONS)
        if not re.search(rf"\.{name}\(", text(place))
    ]


def main() -> int:
    found = [f"{PAGE}: {fault}" for fault in faults()] + unasked() + unnamed()
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
