#!/usr/bin/env bash
# clang.sh: prints the name of clang++. Exit code 77, and why, if it is absent. Debian 12 has it by the name clang++-14 unless the
# package clang is installed, too.
for name in clang++ clang++-14; do
  ! command -v "$name" >/dev/null || { echo "$name"; exit 0; }
done
echo "skipped: no clang++"
exit 77
