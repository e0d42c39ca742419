"""Fills the tables of docs/questions.md, and the signatures in docs/python.md, from what the doors have (doors.py)."""
from __future__ import annotations

import ast
import re
import sys

import doors

PAGE = "docs/questions.md"
HINT = """\
Write a row '| what it is for | `name` |', or a second name into the cell of its row; '-': this door has none.
Then run scripts/generate.py, which fills empty cells. What is not a question: NOT_QUESTIONS, scripts/doors.py."""
# Sources of tests that must ask every question of a detector.
ASK_ALL = ("tests/support/every_question.cpp", "tests/support/as_new.hpp")


def names(cell: str) -> list[str]:
    return re.findall(r"`([\w-]+)`", cell)


def plain(name: str) -> str:
    """Return the name that a question or option has in every door: `is_free` for `tamis_detector_is_free`."""
    return doors.snake_case(re.sub(r"^(tamis_((detector|world|pair)_)?|--)", "", name)).replace("-", "_")


def fitting(row: list[str], offered: set[str]) -> list[str]:
    """Return what a door offers under the name that the row has in another door."""
    known = {plain(name) for cell in row[1:] for name in names(cell)}
    return sorted(name for name in offered if plain(name) in known)


def filled(title: str, table: list[str], columns: list[set[str]], faults: list[str]) -> list[str]:
    """Return the lines of a table. Cells keep the names that their door has; those without any get them."""
    head, _, *given = [[cell.strip() for cell in line.strip("|").split("|")] for line in table]
    given = [row + [""] * (len(head) - len(row)) for row in given]
    last = len(columns) + 1  # a reason may follow, which names what it likes
    rows, reasons = [row[:last] for row in given], [row[last:] for row in given]
    done = [[row[0]] for row in rows]
    for number, offered in enumerate(columns, start=1):
        kept = [[name for name in names(row[number]) if name in offered] for row in rows]
        cells = [named if row[number] else fitting(row, offered) for row, named in zip(rows, kept)]
        for name in sorted(offered.difference(*cells)):
            if places := [cell for row, cell in zip(rows, cells) if not cell and fitting(row, {name})]:
                places[0].append(name)
            else:
                faults.append(f"{PAGE}, {title}, {head[number]}: no row names {name}")
        for row, cell in zip(done, cells):
            row.append(", ".join(f"`{name}`" for name in cell) or "-")
    for row, reason in zip(done, reasons):
        lacking = [door for door, cell in zip(head, row) if cell == "-"]
        if len(lacking) == len(columns):
            faults.append(f"{PAGE}, {title}, {row[0]}: no door has this. Delete the row, or write the new name")
        elif lacking and not any(reason):
            faults.append(f"{PAGE}, {title}, {row[0]}: say in the last column why these lack it: {'; '.join(lacking)}")
    return [*table[:2], *(f"| {' | '.join(row + why)} |".replace("|  |", "| |") for row, why in zip(done, reasons))]


def unasked() -> list[str]:
    asked = sorted(doors.methods("include/tamis/detector.hpp", "Detector"))
    return [f"{at}: nobody asks {name}" for at in ASK_ALL for name in asked if f".{name}(" not in doors.text(at)]


def undocumented() -> list[str]:
    """Return what docstrings of Python lack: each keyword of their class."""
    found = []
    for owner, place in doors.CLASSES.items():
        parameters = re.findall(r"^([\w, ]+) : ", ast.get_docstring(doors.python_class(place, owner)), re.MULTILINE)
        lacking = set(doors.arguments(place, owner)[1]) - set(re.findall(r"\w+", ",".join(parameters)))
        found += [f"{place}, docstring of {owner}: nothing names {name}" for name in sorted(lacking)]
    return found


def ranks_differ() -> list[str]:
    of_python = doors.python_questions("Detector", "distributed.py", "_ranks/*.py")
    differ = of_python ^ doors.methods("distributed/include/tamis/distributed.hpp", "Detector")
    return [f"tamis/distributed.hpp or tamis.distributed lacks the question {name}" for name in sorted(differ)]


def questions() -> str:
    faults = unasked() + undocumented() + ranks_differ()
    start, *parts = (doors.ROOT / PAGE).read_text().split("\n## ")
    for number, part in enumerate(parts):
        title, lines = part.split("\n", 1)[0], part.split("\n")
        table = [line for line in lines if line.startswith("|")]
        at = lines.index(table[0])
        lines[at : at + len(table)] = filled(title, table, (doors.questions() | doors.options())[title], faults)
        parts[number] = "\n".join(lines)
    if faults:
        sys.exit("\n".join([*faults, HINT]))
    return "\n## ".join([start, *parts])


def signatures() -> str:
    """Return docs/python.md, whose rows of classes begin with their signature."""
    page = (doors.ROOT / "docs/python.md").read_text()
    for owner, place in doors.CLASSES.items():
        given, by_keyword = doors.arguments(place, owner)
        signature = f"| `{owner}({', '.join([*given, '*', *by_keyword])})`"
        page, count = re.subn(rf"^\| `{owner}\(.*?\)`", signature, page, flags=re.MULTILINE)
        if count != 1:
            sys.exit(f"docs/python.md: write one row that begins with '| `{owner}()`'")
    return page
