#!/usr/bin/env bash
# pinned.sh TOOL [SET]: prints the path of a program of PyPI, of the version in scripts/requirements-SET.txt. It comes into
# build/SET-tools, so that what it does does not depend on the system. The set `format` has clang-format and clang-tidy. Exit
# code 77, and why, if it cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

set=${2:-format}
folder=$PWD/build/$set-tools wanted=scripts/requirements-$set.txt
mkdir -p build
exec 9>"build/$set-tools.lock"
flock 9
if ! cmp -s "$wanted" "$folder/installed"; then
  { rm -rf "$folder" && python3 -m venv "$folder" && "$folder/bin/pip" --quiet --disable-pip-version-check install -r "$wanted" &&
    cp "$wanted" "$folder/installed"; } >&2 || { echo "skipped: no $1, as PyPI cannot be reached or python3 has no venv"; exit 77; }
fi
echo "$folder/bin/$1"
