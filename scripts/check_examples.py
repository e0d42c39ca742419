#!/usr/bin/env python3
"""check_examples.py [--fix]: compares the programs in pages, and what pages say they print, with examples/ and its output.

--fix writes the files into the pages. A page names its programs here in their order."""
import pathlib
import re
import sys

PAGES = {
    "README.md": ["hello.cpp", "hello.py"],
    "docs/getting-started.md": ["two_meshes.cpp", "two_meshes.py"],
    "docs/c.md": ["hello.c", "bodies.c", "from_ctypes.py"],
    "docs/cpp.md": ["before_step_one.cpp", "near.cpp", "response.cpp", "line_search.cpp", "simulation_loop.cpp", "objects.cpp",
                    "at_start.cpp"],
    "docs/plane.md": ["plane.cpp"],
    "bindings/npm/README.md": ["hello.mjs", "bodies.mjs", "curve.mjs"],
    "docs/worlds.md": ["world.cpp", "bodies.cpp", "static_bodies.cpp", "edges.py"],
    "docs/planners.md": ["plan.py"],
}
# A program, and behind it what it prints.
QUOTED = re.compile(r"^```(?:cpp|c|python|js)\n(.*?)^```$(.*?)^```text\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    folder, wrong = root / "examples", []
    for page, programs in PAGES.items():
        text = (root / page).read_text()
        quoted = list(QUOTED.finditer(text))
        if len(quoted) != len(programs) or len(re.findall(r"^```(?:cpp|c|python|js)$", text, re.MULTILINE)) != len(programs):
            wrong.append(f"{page}: quotes other programs than {programs}: each is followed by a block of text")
            continue
        for found, name in reversed(list(zip(quoted, programs))):
            for group, source in ((3, folder / "output" / f"{name}.txt"), (1, folder / name)):
                if found[group] != source.read_text():
                    wrong.append(f"{page}: differs from {source.relative_to(root)}: run scripts/check_examples.py --fix")
                    text = text[:found.start(group)] + source.read_text() + text[found.end(group):]
        if "--fix" in sys.argv[1:]:
            (root / page).write_text(text)
    files = {path.name for path in folder.iterdir() if path.suffix in (".cpp", ".c", ".py", ".mjs")}
    wrong += [f"examples/{name}: no page quotes it" for name in sorted(files - {n for names in PAGES.values() for n in names})]
    print("\n".join(wrong) or "pages quote the programs of examples/")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
