#!/usr/bin/env bash
# Checks that clang-format 14 would change no C or C++ file; --fix formats them. Exit code 77 if it is not installed.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v clang-format-14 >/dev/null || { echo "skipped: no clang-format-14"; exit 77; }
mode=(--dry-run -Werror)
[[ ${1:-} != --fix ]] || mode=(-i)
mapfile -t files < <(find . \( -path ./build -o -path ./out -o -name node_modules -o -name '.?*' \) -prune -o -name '*.[ch]pp' -print -o -name '*.[ch]' -print | sort)
clang-format-14 "${mode[@]}" "${files[@]}"
echo "${#files[@]} files, all formatted"
