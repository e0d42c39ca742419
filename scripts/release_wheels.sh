#!/usr/bin/env bash
# release_wheels.sh FOLDER: puts the wheels for Python on Linux (x86-64, ARM64), macOS (ARM64) and Windows (x86-64), and the source
# distribution, into FOLDER. scripts/release_wheel.py says how they are made and checked. A target whose compiler or Python is missing is
# named. Exit code 77 if the packages of PyPI cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

out=$(realpath -m "${1:?say which folder}")
for set in zig wheels; do
  tool=$(scripts/pinned.sh python "$set") || { echo "$tool"; exit 77; }
done
scripts/setup.sh --wheels || echo "release_wheels: not all of Debian's packages can be had"
targets=(macos-arm64)
for processor in x86_64 aarch64; do
  if command -v "$processor-linux-gnu-g++" >/dev/null; then
    targets+=("linux-$processor")
  else
    echo "release_wheels: no wheel for linux-$processor: there is no $processor-linux-gnu-g++ here (scripts/setup.sh --wheels)"
  fi
done
work=$PWD/build/wheels
if scripts/windows_python.sh "$work/python-windows"; then
  targets+=(windows-x86_64)
else
  echo "release_wheels: no wheel for windows-x86_64: Python for Windows cannot be had"
fi
python3 scripts/release_wheel.py "$work" "${targets[@]}"
mkdir -p "$out"
cp "$work"/shipped/* "$out"
