#!/usr/bin/env python3
"""Checks that includes point one way: down the layers of src/, and from everything else to the public headers only.

The order of the layers is defined here; that src/CMakeLists.txt and docs/architecture.md list the same is checked."""
import pathlib
import re
import sys

# A layer may include itself and layers with a smaller number. The lists elsewhere are in ascending order.
LAYER = {"numbers": 0, "pair/motion": 1, "search/bounds": 2, "search/topology": 3, "search/bvh": 3, "pair/filters": 3, "pair/distance": 4, "curves/motions": 4,
         "pair/exact": 5, "pair/narrow": 6, "search/kernels": 7, "search/query": 8, "search/coherence": 9, "search/engine": 10,
         "curves/paths": 11, "api": 12, "worlds": 13}
# Folders outside the library, and what each may include besides itself and the public headers.
OUTSIDE = {"include/tamis": [], "bindings/c": ["numbers"], "bindings/python/src": ["python", "audit", "files", "scenes", "numbers"],
           # Ranks find a frame together, and give it to their detectors.
           "distributed/include": [], "distributed/src": ["distributed", "search/bounds", "api", "numbers"],
           "tools/audit": [],
           # Files set the floating-point state as the library does.
           "tools/files": ["audit", "numbers", "curves/paths"], "tools/scenes": ["files"], "tools/command": ["audit", "files", "scenes"], "integrations": ["c", "files"],
           "benchmarks/contenders": ["files", "scenes", "oracle", "benchmarks", "paper"], "benchmarks/distributed": ["benchmarks"],
           "benchmarks/stages": ["scenes", "files", "benchmarks", "paper", *LAYER],
           "benchmarks/exact": ["scenes", "files", "benchmarks", "oracle", "support", *LAYER],
           "benchmarks/matrix": ["scenes", "files", "benchmarks", "matrix"],
           "benchmarks/paths": ["scenes", "benchmarks"], "benchmarks/questions": ["scenes", "files", "benchmarks", "questions"],
           "benchmarks/subspace": ["scenes", "benchmarks", "paper"], "benchmarks/worlds": ["scenes", "benchmarks", "worlds"],
           # The laboratory: its methods may include all layers; its queries and its command may not.
           "paper": ["scenes", "support/yardstick", *LAYER], "paper/queries": ["files", "paper"], "paper/command": ["files", "scenes", "command", "paper"]}
# The only files that may include oneTBB. The benchmarks say how many threads it may have, and so do tests.
KNOWS_TBB = ("src/numbers/parallel.cpp", "benchmarks/contenders/main.cpp")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def room_of(include: str) -> str:
    """Return the layer, or the folder, of an included file."""
    return next((layer for layer in (*LAYER, "support/yardstick") if include.startswith(layer + "/")), include.split("/")[0])


def may_include(user: str, used: str) -> bool:
    if used in ("tamis", user, *user.split("/")):  # a folder may include itself
        return True
    if user in LAYER:
        return LAYER.get(used, 99) < LAYER[user]
    return used in OUTSIDE[user]


def wrong_lists(root: pathlib.Path) -> list[str]:
    """Return what is wrong with the lists of layers elsewhere: each must name all of them, in ascending order."""
    build = (root / "src/CMakeLists.txt").read_text()
    document = (root / "docs/architecture.md").read_text()
    lists = {"src/CMakeLists.txt": re.search(r"foreach\(layer ([^)]*)\)", build)[1].split(),
             "docs/architecture.md": re.findall(r"^\| `([\w/]*\w)` \|", document.split("\n## Layers\n")[1], re.MULTILINE)}
    wrong = []
    for place, names in lists.items():
        if sorted(names) != sorted(LAYER):
            wrong.append(f"{place}: lists other layers: {sorted(set(names) ^ set(LAYER))}")
        elif any(LAYER[a] > LAYER[b] for a, b in zip(names, names[1:])):
            wrong.append(f"{place}: lists the layers in another order than scripts/check_layers.py")
    return wrong


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    folders = [(layer, root / "src" / layer) for layer in LAYER] + [(name, root / name) for name in OUTSIDE]
    wrong = []
    for name, folder in folders:
        for path in sorted(p for p in folder.rglob("*") if p.suffix in (".hpp", ".cpp")):
            place = path.relative_to(root).as_posix()
            # Tests may include anything; paper/command and paper/queries have lines of their own in OUTSIDE.
            if "/tests/" in place or (name == "paper" and place.startswith(("paper/command/", "paper/queries/"))):
                continue
            if re.search(r"^\s*#\s*include\s+[<\"](tbb|oneapi)/", path.read_text(), re.MULTILINE) and place not in KNOWS_TBB:
                wrong.append(f"{place}: may not include oneTBB: use numbers/parallel.hpp")
            for used in INCLUDE.findall(path.read_text()):
                if not may_include(name, room_of(used)):
                    wrong.append(f"{place}: may not include {used}")
    deviations = [p for p in (root / "src").rglob("*.?pp")
                  if not any(p.is_relative_to(root / "src" / layer) for layer in LAYER)]
    wrong += [f"{path.relative_to(root)}: belongs to no layer" for path in sorted(deviations)]
    wrong += wrong_lists(root)
    print("\n".join(wrong) or "every include points down")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
