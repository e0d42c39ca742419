#!/usr/bin/env bash
# Set-up, build, all tests. Arguments go to ctest: `scripts/test.sh -R readme`.
#   --quick   for the daily loop: without what takes minutes (tests by clang, clang-tidy, fuzzing, attacks, the module
#             for Python, the crates, the viewer, packages built against an installed Tamis)
#   --once    a checkout that is built this once and then thrown away: whole targets at a time, no debug information
set -euo pipefail
cd "$(dirname "$0")/.."

preset=dev
if [[ ${1:-} == --once ]]; then
  preset=once
  shift
fi
quick=()
if [[ ${1:-} == --quick ]]; then
  quick=(-E '^(fuzz|hostile|python|rust|viewer|consumer|bench)[.]|^project[.](clang|tidy)')
  shift
fi
scripts/setup.sh --tests
cmake --preset "$preset"
cmake --build --preset dev
# One test more than there are cores, as some wait for PyPI, for a browser, or for other ranks.
ctest --preset dev --parallel "$(($(nproc) + 1))" "${quick[@]}" "$@"
