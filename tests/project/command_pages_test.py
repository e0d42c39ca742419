#!/usr/bin/env python3
"""command_pages_test.py COMMAND: the man page and all completions have each verb and option, and bash and man can read them."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools/command/tests/hostile"))
sys.dont_write_bytecode = True

import discovery  # noqa: E402

BASH = 'source "$1"; COMP_WORDS=(tamis "$2" "$3"); COMP_CWORD=$4; _tamis; echo "${COMPREPLY[@]}"'


def completed(file: pathlib.Path, *words: str) -> str:
    """Return what bash offers for the last word; these are all words after the command."""
    padded = [*words, ""][:2]
    return subprocess.run(["bash", "-c", BASH, "bash", file, *padded, str(len(words))], capture_output=True, text=True, check=True).stdout.strip()


def main() -> int:
    command = sys.argv[1]
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([sys.executable, ROOT / "packaging/debian/command_pages.py", command, "0.0.0", "2000-01-01", folder], check=True)
        page, zsh, fish = ((folder / each).read_text() for each in ("tamis.1", "_tamis", "tamis.fish"))
        verbs = discovery.verbs_of(command)
        for verb in verbs:
            if completed(folder / "tamis.bash", verb.name) != verb.name:
                faults.append(f"bash does not complete {verb.name}")
            for option in verb.options:
                if option.name not in completed(folder / "tamis.bash", verb.name, option.name).split():
                    faults.append(f"bash does not complete {verb.name} {option.name}")
                row = page.partition("\n.SS " + verb.name.replace("-", "\\-") + "\n")[2].partition("\n.SS ")[0]
                if option.name.replace("-", "\\-") not in row:
                    faults.append(f"the man page has no {verb.name} {option.name}")
                if f"'{option.name}[" not in zsh or f"from {verb.name}' -l {option.name[2:]} " not in fish:
                    faults.append(f"zsh or fish does not complete {verb.name} {option.name}")
        if shutil.which("man"):
            says = subprocess.run(["man", "--warnings", "--local-file", folder / "tamis.1"], capture_output=True, text=True, check=False)
            faults += [says.stderr] if says.returncode or says.stderr else []
        for shell, file in (("zsh", "_tamis"), ("fish", "tamis.fish")):
            if shutil.which(shell) and subprocess.run([shell, "-n", folder / file], check=False).returncode:
                faults.append(f"{shell} cannot read {file}")
    print("\n".join(faults) or f"{len(verbs)} verbs, {sum(len(verb.options) for verb in verbs)} options")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
