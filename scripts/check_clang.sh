#!/usr/bin/env bash
# check_clang.sh BUILD: library and command compile with clang 14 without a warning; exit 77 where it is absent.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v clang++-14 >/dev/null || { echo "skipped: no clang++-14"; exit 77; }
cmake --preset clang -B "$1" -DTAMIS_BUILD_TESTS=OFF
cmake --build "$1" --parallel "$(nproc)"
