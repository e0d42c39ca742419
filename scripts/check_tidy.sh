#!/usr/bin/env bash
# check_tidy.sh BUILD [--all]: clang-tidy 14 over the library, its C interface, the files, the commands and MPI, as BUILD
# compiles them: the sources that have changed since origin/main, or in the last commits where there is nothing newer;
# a header brings the source of its name. --all: every source. Exit 77 where clang-tidy is absent.
set -euo pipefail
cd "$(dirname "$0")/.."
kLastCommits=10

command -v run-clang-tidy-14 >/dev/null || { echo "skipped: no clang-tidy-14"; exit 77; }
folders='(src|c|io|scenes|cli|mpi)'
changed_since() { { git diff --name-only "$1" -- && git ls-files --others --exclude-standard; } | sort -u; }
# As names without extension, one behind the other: src/detect/detector|io/obj
stems_of() { grep -E "^$folders/.*[.](cpp|hpp)$" | sed 's/[.][ch]pp$//' | sort -u | paste -sd'|'; }

if [[ ${2:-} == --all ]] || ! git rev-parse --git-dir >/dev/null 2>&1; then
  chosen="$folders/"
else
  stems=$(changed_since "$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD)" | stems_of || true)
  if [[ -z $stems ]]; then
    first=$(git rev-list --max-count="$kLastCommits" HEAD | tail -1)
    stems=$(changed_since "$first" | stems_of || true)
  fi
  [[ -n $stems ]] || { echo "nothing has changed"; exit 0; }
  chosen="($stems)[.]cpp\$"
fi
run-clang-tidy-14 -quiet -p "$1" -j "$(nproc)" "^$PWD/$chosen"
