#!/usr/bin/env python3
"""check_assertions.py [ROOT]: names each test that expects nothing, neither itself nor in a function that it calls.

Reads tests of GoogleTest (TEST, TEST_F, TEST_P), of pytest (test_*), of Node (test(...)) and of Rust (#[test]). A function
counts as an expectation if its body has one, or calls such a function; functions are known by name, over all sources of a
language. Comments and strings do not count."""
import pathlib
import re
import subprocess
import sys

# A call that fails the test if something is not as it should be.
EXPECTS = {
    "cpp": r"\b(?:EXPECT|ASSERT)_\w+\s*\(|\b(?:ADD_FAILURE|FAIL|GTEST_FAIL)\s*\(",
    "py": r"\bassert\b|\bpytest\.(?:raises|warns|fail)\b|\bassert_\w+\s*\(|\braise\s+AssertionError|check=True|check_call",
    "js": r"\bassert\b|\bexpect\s*\(",
    "rs": r"\b(?:debug_)?assert(?:_eq|_ne)?!|\bpanic!|\bunreachable!|\.expect_err\(|\.unwrap_err\(",
}
SUFFIXES = {".cpp": "cpp", ".hpp": "cpp", ".py": "py", ".mjs": "js", ".ts": "js", ".rs": "rs"}
# Where a test or a function begins: its name, and for languages with braces the opening one.
BEGINS = {
    "cpp": r"\b(?:(?P<test>TEST(?:_F|_P)?\s*\(\s*\w+\s*,\s*\w+)\s*\)|(?P<name>[A-Za-z_]\w*)\s*\([^;{}]*\)\s*(?:const\s*)?(?:noexcept\s*)?"
           r"(?:override\s*)?(?:->\s*[\w:<>]+\s*)?)\s*\{|\b(?P<lambda>[A-Za-z_]\w*)\s*=\s*\[[^\]]*\]\s*(?:\([^{};]*\))?[^;{}()]*\{",
    "js": r"\b(?P<test>(?:test|it)\(\s*[\"'`][^\"'`]*[\"'`]).*?=>\s*\{|\bfunction\s+(?P<name>\w+)\s*\([^{]*\{"
          r"|\bconst\s+(?P<lambda>\w+)\s*=\s*(?:async\s*)?\([^{;]*=>\s*\{",
    "rs": r"(?P<test>#\[test\](?:\s*#\[[^\]]*\])*\s*fn\s+\w+)[^{;]*\{|\bfn\s+(?P<name>\w+)[^{;]*\{|\bmacro_rules!\s+(?P<lambda>\w+)\s*\{",
}
CALL = re.compile(r"\b([A-Za-z_]\w*)!?\s*(?:<[^<>;()]*>)?\s*\(")


def code_of(text: str, language: str) -> str:
    """Return the text with comments and strings blanked out, at the same places."""
    strings = r"'''.*?'''|\"\"\".*?\"\"\"|" if language == "py" else ""
    strings += r'R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"' + ("" if language == "rs" else r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'")
    comments = r"|#[^\n]*" if language == "py" else r"|//[^\n]*|/\*.*?\*/"
    return re.sub(strings + comments, lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.DOTALL)


def braced(code: str, opening: int) -> str:
    """Return what stands between this brace and the one that closes it."""
    depth = 0
    for place in range(opening, len(code)):
        depth += {"{": 1, "}": -1}.get(code[place], 0)
        if depth == 0:
            return code[opening:place]
    return code[opening:]


def functions_of(text: str, language: str) -> list:
    """Return (name, test or None, line, body) of each function."""
    code, found = code_of(text, language), []
    if language == "py":
        for m in re.finditer(r"^([ \t]*)(?:async )?def (\w+)\(", code, re.MULTILINE):
            end = re.compile(rf"^[ \t]{{0,{len(m[1])}}}\S(?<!\))", re.MULTILINE).search(code, m.end())
            body = code[m.end():end.start() if end else len(code)]
            found.append((m[2], m[2] if m[2].startswith("test_") else None, code.count("\n", 0, m.start()) + 1, body))
        return found
    for m in re.finditer(BEGINS[language], text if language == "js" else code, re.DOTALL):
        name = m["name"] or m["lambda"] or ""
        if name in ("if", "for", "while", "switch", "catch", "return"):
            continue
        test = m["test"] and re.sub(r"\s+", " ", m["test"])
        found.append((name, test, code.count("\n", 0, m.start()) + 1, braced(code, m.end() - 1)))
    return found


def tests_that_expect_nothing(sources: dict) -> list[str]:
    """Return `path:line: test` for each; `sources` holds the text of each path."""
    bodies, tests = {}, []
    for path, text in sources.items():
        language = SUFFIXES[pathlib.PurePath(path).suffix]
        for name, test, line, body in functions_of(text, language):
            bodies.setdefault((language, name), []).append(body)
            if test:
                tests.append((language, f"{path}:{line}: {test}", body))
    expecting = set()

    def expects(language: str, body: str) -> bool:
        return bool(re.search(EXPECTS[language], body)) or any((language, name) in expecting for name in CALL.findall(body))

    grew = True
    while grew:
        more = {key for key, of in bodies.items() if key not in expecting and key[1] and any(expects(key[0], b) for b in of)}
        expecting |= more
        grew = bool(more)
    return [place for language, place, body in tests if not expects(language, body)]


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    paths = subprocess.run(["git", "ls-files"], cwd=root, check=True, capture_output=True, text=True).stdout.split("\n")
    test_code = re.compile(r"(^|/)tests?/|^integrations/rapier/|_test\.")
    sources = {p: (root / p).read_text() for p in paths
               if test_code.search(p) and pathlib.PurePath(p).suffix in SUFFIXES and (root / p).is_file()}
    wrong = tests_that_expect_nothing(sources)
    print("\n".join(wrong + [f"{len(wrong)} tests expect nothing: a test must fail if what it names is wrong"])
          if wrong else f"every test of {len(sources)} files expects something")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
