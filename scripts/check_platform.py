#!/usr/bin/env python3
"""Checks that only numbers/platform.hpp knows compilers: no other source of the library has a builtin, an attribute or a macro of one.

include/tamis/c/status.h says for C how functions are exported."""
import pathlib
import re
import sys

KNOWS = {"src/numbers/platform.hpp", "include/tamis/c/status.h"}
# What stands for a compiler or a processor. Lanes are chosen by xsimd's own macros, XSIMD_WITH_AVX and the like.
FOREIGN = re.compile(r"__builtin_\w+|\[\[(?:gnu|clang|msvc)::\w+|__extension__|\b__int128\b|__attribute__|__declspec|__forceinline|\basm\b"
                     r"|\b__(?:GNUC|clang|SIZEOF_INT128|x86_64|aarch64|wasm|MINGW\w*|APPLE)__\b|\b_MSC_VER\b|\b_M_\w+|\b_WIN32\b"
                     r"|\(__m\d+[id]?\)|make_unique_for_overwrite")


def foreign_words(text: str):
    """Return line number and word of each, outside of comments."""
    for number, line in enumerate(text.splitlines(), 1):
        for word in FOREIGN.findall(line.split("//")[0]):
            yield number, word


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    sources = [p for folder in ("src", "include", "distributed/src", "distributed/include", "bindings/c", "integrations")
               for p in sorted((root / folder).rglob("*")) if p.suffix in (".hpp", ".cpp", ".h") and "tests" not in p.parts]
    found = [f"{path.relative_to(root)}:{number}: {word}: put it into src/numbers/platform.hpp" for path in sources
             if path.relative_to(root).as_posix() not in KNOWS for number, word in foreign_words(path.read_text())]
    if not any(foreign_words((root / "src/numbers/platform.hpp").read_text())):
        found.append("src/numbers/platform.hpp: no word of a compiler was found: this check reads nothing")
    print("\n".join(found) or f"{len(sources)} sources, of which {len(KNOWS)} know compilers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
