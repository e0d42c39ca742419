"""check_headers.py INCLUDE EIGEN COMPILER...: taken.cpp compiles without a warning; each mistake of refused.cpp does not
compile, and what the compiler shows has the sentence that says what to do."""
import pathlib
import re
import shutil
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
include, eigen, *compilers = sys.argv[1:]


def compiled(compiler, source, *more):
    words = [compiler, "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror",
             "-fsyntax-only", f"-I{include}", "-isystem", eigen, *more, here / source]
    outcome = subprocess.run(words, capture_output=True, text=True)
    return outcome.returncode == 0, outcome.stderr


faults = []
mistakes = re.findall(r"MISTAKE == (\d+)  // says: (.*)", (here / "refused.cpp").read_text())
for compiler in filter(shutil.which, compilers):
    for source in ("taken.cpp", "refused.cpp"):
        is_taken, said = compiled(compiler, source)
        if not is_taken:
            faults.append(f"{compiler} refuses {source}:\n{said}")
    for number, sentence in mistakes:
        is_taken, said = compiled(compiler, "refused.cpp", f"-DMISTAKE={number}")
        if is_taken or sentence not in said:
            faults.append(f"{compiler} does not refuse mistake {number} with '{sentence}':\n{said}")
assert mistakes, "refused.cpp has no mistakes"
print(*faults or [f"{len(mistakes)} mistakes are refused"], sep="\n")
sys.exit(bool(faults))
