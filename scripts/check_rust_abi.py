#!/usr/bin/env python3
"""Checks that the crates' declarations of the C interface are the same as its headers': structs, calls, numbers.

They are written by hand, and neither compiler sees both sides: a field that one side lacks would be read from memory of
something else.
"""

from __future__ import annotations

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = [*sorted((ROOT / "include/tamis/c").glob("*.h")), ROOT / "integrations/rapier/clamp/clamp.h"]
CRATE = ROOT / "bindings/rust/src"
IN_RUST = {
    **{"int": "c_int", "tamis_status": "c_int", "int32_t": "i32", "double": "f64", "size_t": "usize"},
    **{"char": "c_char", "void": "c_void"},
    **{"tamis_pose": "Pose", "tamis_link": "Link", "tamis_contact": "Contact"},
    **{"tamis_near_pair": "NearPair", "tamis_intersection": "Intersection"},
    **{"tamis_body_end": "End", "tamis_velocity": "Velocity", "tamis_inertia": "Inertia"},
}

# Numbers that are written in C or C++ and again in Rust.
ANSWERS, STATUS, CLAMP = "include/tamis/c/answers.h", "include/tamis/c/status.h", "integrations/clamp.hpp"
OF_WORLD, OF_CLAMP, OF_MESH = "bindings/rust/src/world.rs", "bindings/rust/src/clamp.rs", "integrations/rapier/tamis-rapier/src/mesh.rs"
NUMBERS = [
    (ANSWERS, "TAMIS_REPORT = ", OF_WORLD, "Report = "),
    (ANSWERS, "TAMIS_IGNORE = ", OF_WORLD, "Ignore = "),
    (ANSWERS, "TAMIS_FAIL = ", OF_WORLD, "Fail = "),
    (STATUS, "TAMIS_INVALID_MESH = ", OF_MESH, "INVALID_MESH: i32 = "),
    (CLAMP, "double gap = ", OF_CLAMP, "ClampOptions { gap: "),
    (CLAMP, "int rounds = ", OF_CLAMP, ", rounds: "),
]

Fields = list[tuple[str, str]]
Call = tuple[list[str], str]


def rust_type(declared: str) -> str:
    """Return the type in Rust of a declaration in C: `const double* name`, or `double*`, or `double`."""
    const, base, stars = re.fullmatch(r"(const )?(\w+)\s*(\**)(?:\s*\w+)?", declared.strip()).groups()
    kinds = ["*const " if const else "*mut ", *["*mut "] * (len(stars) - 1)] if stars else []
    return "".join(reversed(kinds)) + IN_RUST.get(base, base)


def rust_types(parameters: str) -> list[str]:
    return [rust_type(each) for each in parameters.split(",") if each.strip() != "void"]


def fields_in_c(body: str) -> Fields:
    found: Fields = []
    for declared in filter(None, map(str.strip, body.split(";"))):
        if function := re.fullmatch(r"(.*)\(\*(\w+)\)\((.*)\)", declared, re.DOTALL):
            answer, name, parameters = function.groups()
            called = f'extern "C" fn({", ".join(rust_types(parameters))})'
            found.append((name, f"Option<{called} -> {rust_type(answer)}>".replace(" -> c_void", "")))
            continue
        kind, names = re.fullmatch(r"((?:const )?\w+\**) (.*)", declared, re.DOTALL).groups()
        for name, size in re.findall(r"(\w+)(?:\[(\w+)\])?", re.sub(r"\s", "", names)):
            found.append((name, f"[{rust_type(kind)}; {size}]" if size else rust_type(kind)))
    return found


def in_c() -> tuple[dict[str, Fields], dict[str, Call]]:
    text = "".join(re.sub(r"/\*.*?\*/", "", header.read_text(), flags=re.DOTALL) for header in HEADERS)
    structs = re.findall(r"^typedef struct \w+ \{(.*?)\n\} (\w+);", text, re.DOTALL | re.MULTILINE)
    calls = re.findall(r"^TAMIS_API ([^(;]*?)(tamis_\w+)\((.*?)\);", text, re.DOTALL | re.MULTILINE)
    return (
        {IN_RUST.get(name, name): fields_in_c(body) for body, name in structs},
        {name: (rust_types(parameters), rust_type(answer)) for answer, name, parameters in calls},
    )


def in_rust() -> tuple[dict[str, Fields], dict[str, Call]]:
    text = "".join(re.sub(r"//.*", "", source.read_text()) for source in sorted(CRATE.glob("*.rs")))
    text = text.replace("unsafe extern", "extern").replace("BodyId", "i32")
    shown = r"#\[repr\(C\)\]\s*(?:#\[.*?\]\s*)*pub struct (\w+) \{(.*?)\n *\}"
    structs = {
        name: re.findall(r"pub (\w+): (.*),$", body, re.MULTILINE) for name, body in re.findall(shown, text, re.DOTALL)
    }
    calls = re.findall(r"pub fn (tamis_\w+)\(([^)]*)\)(?: -> ([^;]*))?;", text)
    return (
        {name: fields for name, fields in structs.items() if fields},  # without fields: a handle
        {name: (re.findall(r"\w+: ([^,]+)", given), answer or "c_void") for name, given, answer in calls},
    )


def number_after(words: str, place: str) -> float:
    return float(re.search(re.escape(words) + r"([\d.e-]+)", (ROOT / place).read_text())[1])


def main() -> int:
    wrong = 0
    for header, there, source, here in NUMBERS:
        theirs, ours = number_after(there, header), number_after(here, source)
        if theirs != ours:
            print(f"{header} has {there}{theirs}\n{source} has {here}{ours}")
            wrong += 1
    for declared_there, declared_here in zip(in_c(), in_rust()):
        if not declared_here:
            sys.exit(f"nothing is declared in {CRATE}")
        for name, declared in declared_here.items():
            if declared != declared_there.get(name):
                print(f"{name}:\n  in Rust {declared}\n  in C    {declared_there.get(name, 'not there')}")
                wrong += 1
        print(f"{len(declared_here)} compared")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
