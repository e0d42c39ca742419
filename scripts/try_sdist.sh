#!/usr/bin/env bash
# try_sdist.sh SDIST: as root on a Debian that has nothing yet (scripts/try_in_root.sh), builds Python's source distribution by pip with a
# compiler and Python alone, and runs the README's example and the command. Without Python's headers pip must name them.
set -euo pipefail
sdist=$(realpath "$1")
cd "$(dirname "$0")/.."

export DEBIAN_FRONTEND=noninteractive
apt-get update -q >/dev/null
install() { apt-get install -q -y --no-install-recommends "$@" >/dev/null; }
install g++ python3-venv
work=$(mktemp -d)
python3 -m venv "$work/env"
pip=("$work/env/bin/pip" --disable-pip-version-check install "$sdist")
if "${pip[@]}" >"$work/says.txt" 2>&1; then echo "try_sdist.sh: this worked without Python's headers" >&2; exit 1; fi
tr -s '[:space:]' ' ' <"$work/says.txt" | grep -oE "tamis: [^ ]+ [0-9.]+ has no headers here: install them \(Debian: python3-dev\)" || { cat "$work/says.txt"; exit 1; }
install python3-dev
time "${pip[@]}"
"$work/env/bin/python" examples/hello.py | diff - examples/output/hello.py.txt
"$work/env/bin/tamis" --version
"$work/env/bin/python" scripts/wheel_bits.py
