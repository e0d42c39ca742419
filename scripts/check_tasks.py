#!/usr/bin/env python3
"""Checks that the body of every loop that oneTBB runs is wrapped by as_task (src/numbers/floating_point_state.hpp):
oneTBB's threads have the floating-point state of their arena, in which error bounds need not hold."""
import pathlib
import re
import sys

FOLDERS = ["src", "distributed", "tools", "paper", "bindings", "integrations", "tests/support/yardstick"]
CALL = re.compile(r"\btbb::parallel_(?!sort)\w+\(|\barena_?\.execute\(")


def call_at(text: str, start: int) -> str:
    """Return the text of the call whose opening bracket is the last character before `start`."""
    depth, end = 1, start
    while depth > 0:
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        end += 1
    return text[start:end]


def main() -> int:
    root = pathlib.Path(__file__).resolve().parent.parent
    wrong, count = [], 0
    for path in sorted(p for folder in FOLDERS for p in (root / folder).rglob("*.[ch]pp")
                       if "tests" not in p.relative_to(root / folder).parts):
        text = path.read_text()
        for call in CALL.finditer(text):
            count += 1
            if "as_task(" not in call_at(text, call.end()):
                wrong.append(f"{path.relative_to(root)}:{text.count(chr(10), 0, call.start()) + 1}: {call[0]}...) runs a "
                             "body that is not wrapped: write as_task(body)")
    print("\n".join(wrong) or f"all {count} parallel loops set the floating-point state")
    return 1 if wrong or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
