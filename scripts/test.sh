#!/usr/bin/env bash
# Set-up, build and tests of the library, its C interface, files and command. Other arguments go to ctest:
# `scripts/test.sh -R filters`.
#   --all   every test: also those that need a second compiler, a browser, cargo, npm, PyPI or MPI
set -euo pipefail
cd "$(dirname "$0")/.."

circle=core
if [[ ${1:-} == --all ]]; then
  circle=all
  shift
fi
case ${1:-} in
  --once) echo "test.sh: --once is gone: use --all" >&2; exit 2 ;;
  --quick) echo "test.sh: --quick is gone: scripts/test.sh without it runs the short tests" >&2; exit 2 ;;
esac
scripts/setup.sh "--$circle-tests"
cmake --preset "$circle"
cmake --build --preset "$circle"
# One test more than there are cores, as some of --all wait for PyPI, for a browser, or for other ranks.
ctest --preset "$circle" --parallel "$(($(nproc) + 1))" "$@"
