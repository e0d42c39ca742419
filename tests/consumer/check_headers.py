"""check_headers.py INCLUDE EIGEN COMPILER...: checks that taken.cpp compiles without a warning, that each mistake of
refused.cpp does not compile, and that the compiler's error has the sentence that says what to do."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
include, eigen, *compilers = sys.argv[1:]


def call(compiler, *words):
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror", f"-I{include}",
             "-isystem", eigen]
    outcome = subprocess.run([compiler, *flags, *words], capture_output=True, text=True)
    return outcome.returncode == 0, outcome.stderr


def read_headers(compiler, folder):
    """Precompile the headers that refused.cpp includes, so that they are read once, not once a mistake."""
    headers = pathlib.Path(folder) / f"{pathlib.Path(compiler).name}.hpp"
    headers.write_text("\n".join(re.findall("#include.*", (here / "refused.cpp").read_text())))
    call(compiler, "-x", "c++-header", headers, "-o", f"{headers}.gch")
    return headers


faults = []
mistakes = re.findall(r"MISTAKE == (\d+)  // says: (.*)", (here / "refused.cpp").read_text())
with tempfile.TemporaryDirectory() as folder:
    for compiler in filter(shutil.which, compilers):
        headers = read_headers(compiler, folder)
        for source in ("taken.cpp", "refused.cpp"):
            is_taken, said = call(compiler, "-fsyntax-only", here / source)
            if not is_taken:
                faults.append(f"{compiler} refuses {source}:\n{said}")
        for number, sentence in mistakes:
            is_taken, said = call(compiler, "-fsyntax-only", "-include", headers, f"-DMISTAKE={number}", here / "refused.cpp")
            if is_taken or sentence not in said:
                faults.append(f"{compiler} does not refuse mistake {number} with '{sentence}':\n{said}")
assert mistakes, "refused.cpp has no mistakes"
print(*faults or [f"{len(mistakes)} mistakes are refused"], sep="\n")
sys.exit(bool(faults))
