#!/usr/bin/env bash
# check_clang.sh BUILD [TARGET]: checks that clang 14 parses TARGET, or everything, without a warning. Exit code 77 if clang
# 14 is absent. All sources of a target are one unit, which shows names that two of them share. Only the library and its C
# interface are compiled: a shared library, which the test consumer.shared_library_from_readme installs. Not optimised, as
# clang warns before it optimises.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v clang++-14 >/dev/null || { echo "skipped: no clang++-14"; exit 77; }
cmake --preset clang -B "$1" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DTAMIS_OPTIMIZE_KERNELS=OFF \
  -DBUILD_SHARED_LIBS=ON -DTAMIS_PARSE_REST=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
cmake --build "$1" --parallel "$(nproc)" --target "${2:-all}"
