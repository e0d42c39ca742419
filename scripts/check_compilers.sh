#!/usr/bin/env bash
# check_compilers.sh [COMPILER...]: builds everything with each of these compilers, by default with all that the release of Debian has
# beside its own: g++-12, g++-14, clang++-14, clang++-19. Warnings are errors, and come after optimisation, too. Tests and benchmarks
# are parsed, not run: scripts/test.sh runs them with the release's own compiler.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh --all-tests
if (($# == 0)); then
  scripts/setup.sh --compilers
  for name in g++-12 g++-14 clang++-14 clang++-19; do
    ! command -v "$name" >/dev/null || set -- "$@" "$name"
  done
fi
for compiler in "$@"; do
  echo "check_compilers: $compiler"
  build=build/compilers/$compiler
  cmake --preset all -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2 -DTAMIS_PARSE_TESTS=ON
  cmake --build "$build" --parallel "$(nproc)"
done
echo "no warnings: $*"
