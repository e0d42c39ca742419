"""The questions and options of every door, read from its sources: C++, Python, C, the command, many machines."""
from __future__ import annotations

import ast
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
PYTHON = "bindings/python/tamis"
CLASSES = {"Detector": f"{PYTHON}/_detector/_detector.py", "World": f"{PYTHON}/_world/_world.py"}
# Functions of doors that are not questions: they make, change or read.
NOT_QUESTIONS = {
    *("add", "add_many", "move", "move_many", "motion", "remove", "set_enabled", "set_may_touch", "set_radius"),
    *("mesh", "options", "statistics", "vertex_count", "balance"),
    *("bench", "info", "scene", "view"),
}
NOT_QUESTIONS_IN_C = re.compile(
    r"_(create|(?<!_is_)(?<!_are_)free|dimension|message|statistics|copy_\w+|(?<!world_)points_at|add|move|remove|set_\w+)$|^tamis_(mesh_|version|has_threads|turned_|chain_|nlerp_|pose_(of_|at)|weights_of)"
)
POSITIONS_IN_C = {"start", "end", "start_stride", "end_stride", "vertex_count"}


def text(place: str) -> str:
    return (ROOT / place).read_text().replace("[[nodiscard]] ", "")


def methods(header: str, owner: str) -> set[str]:
    """Return the questions among the methods of a C++ class that return something."""
    body = re.search(rf"^class {owner} {{\n(.*?)^(?: private:|}};)", text(header), re.DOTALL | re.MULTILINE)[1]
    return set(re.findall(r"^  (?!explicit|return)[\w:<>&*, ]+ [&*]?(\w+)\([^;]*;", body, re.MULTILINE)) - NOT_QUESTIONS


def members(header: str, struct: str) -> set[str]:
    """Return the names of a struct's data members; in C without `size`."""
    body = re.search(rf"^(?:typedef )?struct {struct} {{\n(.*?)^}}", text(header), re.DOTALL | re.MULTILINE)[1]
    body = re.sub(r"//[^\n]*|/\*.*?\*/", "", body, flags=re.DOTALL)
    plain = set(re.findall(r"^  (?!static )[^;=]*\b(\w+)(?: = [^;]*)?;", body, re.MULTILINE))
    return (plain | set(re.findall(r"\(\*(\w+)\)\(", body))) - {"size"}


def python_class(place: str, owner: str) -> ast.ClassDef:
    return next(node for node in ast.parse(text(place)).body if getattr(node, "name", "") == owner)


def python_questions(owner: str, *places: str) -> set[str]:
    """Return the questions of a Python class and of its bases."""
    sources = [ast.parse(file.read_text()) for place in places for file in (ROOT / PYTHON).glob(place)]
    classes = {node.name: node for source in sources for node in source.body if isinstance(node, ast.ClassDef)}

    def of(node: ast.ClassDef) -> set[str]:
        own = {item.name for item in node.body if isinstance(item, ast.FunctionDef) and item.name[0] != "_"}
        return own.union(*(of(classes[base.id]) for base in node.bases if isinstance(base, ast.Name)))

    return of(classes[owner]) - NOT_QUESTIONS


def arguments(place: str, owner: str, function: str = "__init__") -> tuple[list[str], list[str]]:
    """Return the arguments of a method of a Python class: those without `self`, and those given by keyword alone."""
    found = [item for item in python_class(place, owner).body if isinstance(item, ast.FunctionDef)]
    given = [item.args for item in found if item.name == function][-1]
    return [each.arg for each in given.args[1:]], [each.arg for each in given.kwonlyargs]


def c_questions(owner: str) -> set[str]:
    headers = "".join(header.read_text() for header in sorted((ROOT / "include/tamis/c").glob("*.h")))
    found = set(re.findall(r"^TAMIS_API[\w \*]* \*?(tamis_\w+)\(", headers, re.MULTILINE))
    owned = {name: (re.match("tamis_(detector|world)_", name) or ["", ""])[1] for name in found}
    return {name for name in found if owned[name] == owner and not NOT_QUESTIONS_IN_C.search(name)}


def js_questions(*classes: str) -> set[str]:
    """Return the questions of classes of the package of npm, each given as file:Class."""
    found: set[str] = set()
    for place, owner in (each.split(":") for each in classes):
        source = text(f"bindings/npm/src/{place}.ts")
        body = re.search(rf"^export (?:abstract )?class {owner} .*?^}}", source, re.DOTALL | re.MULTILINE)[0]
        found |= set(re.findall(r"^  (?!constructor)(\w+)\(", body, re.MULTILINE))
    return {name for name in found if snake_case(name) not in NOT_QUESTIONS}


def snake_case(name: str) -> str:
    return re.sub(r"([A-Z])", lambda found: f"_{found[0].lower()}", name)


def verbs() -> set[str]:
    sources = "".join(source.read_text() for source in (ROOT / "tools/command/verbs").rglob("*.?pp"))
    return set(re.findall(r'name\(\) const override \{ return "([\w-]+)"', sources)) - NOT_QUESTIONS


def command_options(owner: str) -> set[str]:
    """Return what the classes of options that verbs share declare."""
    source = text("tools/command/command_line/arguments.cpp")
    found: set[str] = set()
    for body in re.findall(rf"^void {owner}::declare.*?^}}", source, re.DOTALL | re.MULTILINE):
        for called in re.findall(r"(declare_\w+)\(options, \w+_\)", body):
            body += re.search(rf"^void {called}\(.*?^}}", source, re.DOTALL | re.MULTILINE)[0]
        found |= set(re.findall(r'"(--[\w-]+)"', body))
    return found


def questions() -> dict[str, list[set[str]]]:
    """Return the questions of each door, by the title of the table in docs/questions.md that has these columns."""
    pair_headers = ("include/tamis/pair.hpp", "include/tamis/pair_distance.hpp", "include/tamis/path.hpp")
    of_pairs = set(re.findall(r"^[\w:<>]+(?: [\w:<>]+)* (\w+)\(", "".join(map(text, pair_headers)), re.MULTILINE))
    exported = re.search(r"^__all__ = (\[.*?\])", text(f"{PYTHON}/__init__.py"), re.DOTALL | re.MULTILINE)[1]
    command = verbs()
    return {
        "One mesh": [
            methods("include/tamis/detector.hpp", "Detector"),
            python_questions("Detector", "_detector/*.py"),
            c_questions("detector"),
            js_questions("detector:Detector"),
            command - {"bodies"},
            methods("distributed/include/tamis/distributed.hpp", "Detector"),
        ],
        "Bodies": [
            methods("include/tamis/world.hpp", "World"),
            python_questions("World", "_world/*.py"),
            c_questions("world"),
            js_questions("bodies:Bodies", "world:World"),
            command & {"bodies"},
        ],
        "A pair, or a list of pairs": [of_pairs, of_pairs & set(ast.literal_eval(exported)), c_questions(""), js_questions("pairs:Pairs", "path:Path") - {"pointsAt"}],
    }


def options() -> dict[str, list[set[str]]]:
    """Return the options of each door, by the title of the table in docs/questions.md that has these columns."""
    header, ranks = "include/tamis/options.hpp", f"{PYTHON}/distributed.py"
    return {
        "Options of a detector or a world": [
            (members(header, "Options") | members(header, "PairFilter")) - {"filter"},
            set(arguments(CLASSES["Detector"], "Detector")[1]),
            members("include/tamis/c/detector.h", "tamis_options"),
            set(arguments(CLASSES["World"], "World")[1]),
            members("include/tamis/c/world.h", "tamis_world_options"),
            command_options("DetectorArguments"),
            set(arguments(ranks, "Detector")[1]) - {"edges", "points"},
        ],
        "Options of a question": [
            members(header, "QueryOptions"),
            members(header, "PathOptions"),
            set(arguments(f"{PYTHON}/_detector/_in_motion.py", "InMotion", "contacts")[1]),
            members("include/tamis/c/answers.h", "tamis_step") - POSITIONS_IN_C,
            members("include/tamis/c/path.h", "tamis_path_options"),
            command_options("AtStartArgument"),
        ],
    }
