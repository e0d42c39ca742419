#!/usr/bin/env bash
# release_wheels.sh FOLDER: puts the wheels for Python on Linux and Windows and the source distribution into FOLDER.
# scripts/release_wheel.py says how they are made and checked; its other targets have not been built yet. Without Python for Windows
# that wheel is left out. Exit code 77 if the compilers or the packages of PyPI cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

out=$(realpath -m "${1:?say which folder}")
for set in zig wheels; do
  tool=$(scripts/pinned.sh python "$set") || { echo "$tool"; exit 77; }
done
scripts/setup.sh --wheels || { echo "skipped: Debian's compilers cannot be had"; exit 77; }
work=$PWD/build/wheels
targets=(linux-x86_64)
if scripts/windows_python.sh "$work/python-windows"; then targets+=(windows-x86_64); fi
python3 scripts/release_wheel.py "$work" "${targets[@]}"
mkdir -p "$out"
cp "$work"/shipped/* "$out"
