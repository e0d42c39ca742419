#!/usr/bin/env python3
"""check_version.py [VERSION]: checks that all files that must spell the version out have that of CMakeLists.txt (and VERSION).

pyproject.toml and packaging/conan read CMakeLists.txt themselves."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
VERSION = r"(\d+\.\d+\.\d+)"
# Files, as patterns, and what stands before the version there. Files of the last ones are there once these packages are made.
SPELLED = {
    "bindings/rust/Cargo.toml": rf'^version = "{VERSION}"',
    "bindings/rust/Cargo.lock": rf'^name = "tamis"\nversion = "{VERSION}"',
    "integrations/rapier/Cargo.toml": rf'^version = "{VERSION}"',
    "integrations/blender/tamis_check/blender_manifest.toml": rf'^version = "{VERSION}"',
    "packaging/vcpkg/tamis/vcpkg.json": rf'^  "version": "{VERSION}"',
    "packaging/conda/recipe.yaml": rf'^  version: "{VERSION}"',
    "CITATION.cff": rf"^version: {VERSION}$",
}
MAYBE = {"packaging/npm/package.json": rf'^  "version": "{VERSION}"', "bindings/*/package.json": rf'^  "version": "{VERSION}"',
         "packaging/*/Cargo.toml": rf'^version = "{VERSION}"'}


def spelled(path: pathlib.Path, pattern: str) -> list[str]:
    return re.findall(pattern, path.read_text(), re.MULTILINE)


def main() -> int:
    (version,) = spelled(ROOT / "CMakeLists.txt", rf"^project\(tamis VERSION {VERSION} ")
    if len(sys.argv) > 1 and sys.argv[1] != version:
        print(f"CMakeLists.txt has version {version}, not {sys.argv[1]}: change project(tamis VERSION ...), then run this check")
        return 1
    places = [(ROOT / name, pattern) for name, pattern in SPELLED.items()]
    places += [(path, pattern) for name, pattern in MAYBE.items() for path in sorted(ROOT.glob(name))]
    faults = []
    for path, pattern in places:
        found = spelled(path, pattern) if path.exists() else []
        if found and set(found) == {version}:
            continue
        faults.append(f"{path.relative_to(ROOT)}: has version {', '.join(found) or 'none'}: write {version}, as in CMakeLists.txt")
    print("\n".join(faults) or f"{len(places)} files have version {version}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
