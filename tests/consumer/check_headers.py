"""check_headers.py INCLUDE EIGEN COMPILER...: checks that taken.cpp compiles without a warning, and that of refused.cpp all
mistakes and nothing else are refused, each by an error with the sentence that says what to do."""
import pathlib
import re
import shutil
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
include, eigen, *compilers = sys.argv[1:]


def call(compiler, source):
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror", f"-I{include}",
             "-isystem", eigen, "-fsyntax-only"]
    outcome = subprocess.run([compiler, *flags, here / source], capture_output=True, text=True)
    return outcome.returncode == 0, outcome.stderr


def read_mistakes():
    """The lines and the sentence of each mistake of refused.cpp: a block from "{  // says: SENTENCE" to its brace."""
    text = (here / "refused.cpp").read_text()
    for block in re.finditer(r"^  \{  // says: (.*)(?:\n   .*)*", text, flags=re.MULTILINE):
        first, last = (text.count("\n", 0, place) + 1 for place in block.span())
        yield range(first, last + 1), block[1]


def faults_of(compiler):
    is_taken, said = call(compiler, "taken.cpp")
    if not is_taken:
        yield f"{compiler} refuses taken.cpp:\n{said}"
    _, said = call(compiler, "refused.cpp")
    # What stands before the first error; then file, line and text of each.
    _, *parts = re.split(r"^(\S+):(\d+):\d+: error:", said, flags=re.MULTILINE)
    errors = [(pathlib.Path(file).name, int(line), text) for file, line, text in zip(*[iter(parts)] * 3)]
    for file, line, text in errors:
        if file != "refused.cpp" or not any(line in lines for lines, _ in mistakes):
            yield f"{compiler} refuses line {line} of {file}:{text}"
    for lines, sentence in mistakes:
        if not any(line in lines and sentence in text for _, line, text in errors):
            yield f"{compiler} does not refuse line {lines[0]} of refused.cpp with '{sentence}':\n{said}"


mistakes = list(read_mistakes())
assert mistakes, "refused.cpp has no mistakes"
faults = [fault for compiler in filter(shutil.which, compilers) for fault in faults_of(compiler)]
print(*faults or [f"{len(mistakes)} mistakes are refused"], sep="\n")
sys.exit(bool(faults))
