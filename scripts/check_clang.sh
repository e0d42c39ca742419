#!/usr/bin/env bash
# check_clang.sh BUILD [TARGET]: checks that TARGET, or everything, compiles with clang without a warning, and that tests
# and benchmarks are parsed without one. Exit code 77 if clang is absent. All sources of a target are compiled as one
# unit, which shows names that two of them share. Not optimised, as clang warns before it optimises. The library is a shared
# one, which the test consumer.shared_library_from_readme installs.
set -euo pipefail
cd "$(dirname "$0")/.."

clang=$(scripts/clang.sh) || { echo "$clang"; exit 77; }
cmake --preset clang -B "$1" -DCMAKE_CXX_COMPILER="$clang" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DTAMIS_OPTIMIZE_KERNELS=OFF -DBUILD_SHARED_LIBS=ON -DTAMIS_PARSE_TESTS=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
cmake --build "$1" --parallel "$(nproc)" --target "${2:-all}"
