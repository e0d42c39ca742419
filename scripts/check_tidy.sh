#!/usr/bin/env bash
# check_tidy.sh BUILD [--all]: clang-tidy 14 over the library, its C interface, the laboratory, the files, the commands and MPI, each
# source by itself as clang 14 would compile it (BUILD is configured for that, and nothing built): the sources that
# differ from the commit in tests/project/tidy_base, up to which all have passed (a header brings the source of its
# name), or with --all every one, as scripts/nightly.sh does. When all pass, write HEAD to that file, so that ordinary
# runs stay short. Exit 77 where clang-tidy is absent.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v run-clang-tidy-14 >/dev/null || { echo "skipped: no clang-tidy-14"; exit 77; }
folders='(src|c|io|scenes|cli|lab|mpi)'
changed_since() { { git diff --name-only "$1" -- && git ls-files --others --exclude-standard; } | sort -u; }
# As names without extension, one behind the other: src/detect/detector|io/obj
stems_of() { grep -E "^$folders/.*[.](cpp|hpp)$" | grep -v ^lab/tests/ | sed 's/[.][ch]pp$//' | sort -u | paste -sd'|'; }

if [[ ${2:-} == --all ]]; then
  chosen="$folders/(?!tests/)"
else
  base=$(<tests/project/tidy_base)
  git cat-file -e "$base^{commit}" 2>/dev/null || { echo "skipped: no history back to $base"; exit 77; }
  stems=$(changed_since "$base" | stems_of || true)
  [[ -n $stems ]] || { echo "no source differs from $base"; exit 0; }
  chosen="($stems)[.]cpp\$"
fi
cmake --preset clang -B "$1" -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
run-clang-tidy-14 -quiet -p "$1" -j "$(nproc)" "^$PWD/$chosen"
