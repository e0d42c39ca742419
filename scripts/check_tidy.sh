#!/usr/bin/env bash
# check_tidy.sh BUILD [FILTER]: clang-tidy 14 over the library, its C interface, the files, the commands and MPI, as BUILD compiles them;
# exit 77 where it is absent.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v run-clang-tidy-14 >/dev/null || { echo "skipped: no clang-tidy-14"; exit 77; }
run-clang-tidy-14 -quiet -p "$1" -j "$(nproc)" "${2:-^$PWD/(src|c|io|scenes|cli|mpi)/}"
