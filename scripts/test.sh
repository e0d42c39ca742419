#!/usr/bin/env bash
# Set-up, build, all tests. Arguments go to ctest: `scripts/test.sh -R readme`.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh --tests
cmake --preset dev
cmake --build --preset dev
ctest --preset dev --parallel "$(nproc)" "$@"
