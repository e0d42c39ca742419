#!/usr/bin/env bash
# release_wheels.sh FOLDER: puts the wheel for Python on Linux and the source distribution into FOLDER. scripts/release_wheel.py says how
# they are made and checked; its other targets have not been built yet. Exit code 77 if the compilers or the packages of PyPI cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

out=$(realpath -m "${1:?say which folder}")
for set in zig wheels; do
  tool=$(scripts/pinned.sh python "$set") || { echo "$tool"; exit 77; }
done
scripts/setup.sh --wheels || { echo "skipped: Debian's compilers cannot be had"; exit 77; }
work=$PWD/build/wheels
python3 scripts/release_wheel.py "$work" linux-x86_64
mkdir -p "$out"
cp "$work"/shipped/* "$out"
