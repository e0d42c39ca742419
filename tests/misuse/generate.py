#!/usr/bin/env python3
"""generate.py HEADERS OUT: writes tests that try wrong values for every argument and option of the public C++ headers.

Names and types come from the headers; right and wrong values for each type from wrong_values.hpp. A test with a type
that wrong_values.hpp lacks does not compile.
"""
import pathlib
import re
import sys

# Headers whose functions check their arguments, and the others, with the reason. A header in neither list fails.
ASKED = ["detector.hpp", "mesh.hpp", "pair.hpp", "pair_distance.hpp", "path.hpp"]
NOT_ASKED = {
    "components.hpp": "takes what is made", "contact.hpp": "answers", "error.hpp": "exceptions",
    "from_matrix.hpp": "refused by the compiler", "linkage.hpp": "asked by tests/worlds", "proximity.hpp": "answers", "options.hpp": "names; its structs are here",
    "positions.hpp": "views", "rigid_path.hpp": "asked through C",
    "spline_path.hpp": "asked through C", "statistics.hpp": "answers", "step.hpp": "a struct", "step_length.hpp": "answers", "stored_type.hpp": "names", "tamis.h": "asked through C",
    "tamis.hpp": "includes the others", "world.hpp": "asked by tests/worlds",
}
STRUCTS = ("Options", "PairFilter", "QueryOptions", "PathOptions", "PairOptions")
# Functions that return -1 if they find nothing: no argument is wrong for them.
LOOKS_UP = ("find_edge", "find_face")


def without_comments(path: pathlib.Path) -> str:
    return re.sub(r"//.*|/\*.*?\*/|\[\[nodiscard\]\] ", "", path.read_text())


def split(parameters: str) -> "list[str]":
    """Split at commas outside of <>, {} and ()."""
    parts, depth = [""], 0
    for letter in parameters:
        depth += (letter in "<{(") - (letter in ">})")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [" ".join(part.split()) for part in parts if part.strip()]


def type_and_name(parameter: str) -> "tuple[str, str]":
    declared = re.sub(r"^const ", "", parameter.split("=")[0].strip())
    kind, name = (declared, "options") if declared.endswith("&") else re.fullmatch(r"(.*[\s&>])(\w+)", declared).groups()
    return kind.replace("&", "").strip(), name


def is_output(parameter: str) -> bool:
    return "&" in parameter and "const" not in parameter


def functions(text: str) -> "list[tuple[str, list[str]]]":
    """Return name and parameters of the functions and methods that are declared with parameters and without a body."""
    found = re.findall(r"^ *(?!return )(?:explicit |(?:[\w:<>&]+(?: [\w:<>&]+)*? ))?(\w+)\(([^;{}]*(?:\{\}[^;{}]*)*)\)(?: const| &)?;", text,
                       re.MULTILINE)
    return [(name, split(listed)) for name, listed in found if listed.strip() and name not in LOOKS_UP]


def fields(name: str, text: str) -> "list[str]":
    body = re.search(rf"^struct {name} \{{(.*?)^\}};", text, re.DOTALL | re.MULTILINE)[1]
    return re.findall(r"^  [\w:<>()&, ]+?\b(\w+)(?:\{[^;]*\}| =[^;]*)?;", re.sub(r"^  (static |.*\) const).*$", "", body, flags=re.MULTILINE),
                      re.MULTILINE)


def test(header: str, number: int, name: str, parameters: "list[str]") -> str:
    types = [type_and_name(parameter) for parameter in parameters]
    lines = [f"TEST(Misuse, {header.split('.')[0]}_{number}_{name}) {{"]
    for tried, (kind, what) in enumerate(types):
        if is_output(parameters[tried]):
            continue
        given = ", ".join("wrong" if i == tried else f"right.of<{other}>()" for i, (other, _) in enumerate(types))
        if header == "detector.hpp":
            call = f"Detector({given})" if name == "Detector" else f"right.detector.{name}({given})"
        else:
            call = f"{name}({given})"
        lines.append(f'  try_all<{kind}>("{name}, {what}", [](auto& wrong, Right& right) {{ (void){call}; }});')
    return "\n".join([*lines, "}", ""])


def main() -> int:
    folder, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    here = {path.name for path in folder.iterdir() if path.is_file()}
    if here != {*ASKED, *NOT_ASKED}:
        print(f"{sys.argv[0]}: say of {sorted(here ^ {*ASKED, *NOT_ASKED})} whether it is asked")
        return 1
    texts = {name: without_comments(folder / name) for name in [*ASKED, "options.hpp"]}
    written = []
    for name in STRUCTS:
        text = next(text for text in texts.values() if f"struct {name} {{" in text)
        added = "".join(f'  add_field(found, "{field}", &{name}::{field});\n' for field in fields(name, text))
        written.append(f"inline std::vector<Wrong<{name}>> wrong_values(Type<{name}>) {{\n  std::vector<Wrong<{name}>> found;\n"
                       f"{added}  return found;\n}}\n")
    # Options last, as it has a member of another of these structs.
    written.sort(key=lambda code: "Type<Options>" in code)
    for header in ASKED:
        written += [test(header, i, name, listed) for i, (name, listed) in enumerate(functions(texts[header]))
                    if not any(re.search(r"Detector&&|unique_ptr|double time|double from|span<const Index> vertices", part) for part in listed)]
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text("\n".join(written))
    return 0


if __name__ == "__main__":
    sys.exit(main())
