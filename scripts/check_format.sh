#!/usr/bin/env bash
# Checks that clang-format would change no C or C++ file; --fix formats them. Exit code 77 if it cannot be had (pinned.sh).
set -euo pipefail
cd "$(dirname "$0")/.."

tool=$(scripts/pinned.sh clang-format) || { echo "$tool"; exit 77; }
mode=(--dry-run -Werror)
[[ ${1:-} != --fix ]] || mode=(-i)
mapfile -t files < <(find . \( -path ./build -o -path ./out -o -name node_modules -o -name '.?*' \) -prune -o -name '*.[ch]pp' -print -o -name '*.[ch]' -print | sort)
"$tool" "${mode[@]}" "${files[@]}"
echo "${#files[@]} files, all formatted"
