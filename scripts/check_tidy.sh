#!/usr/bin/env bash
# check_tidy.sh BUILD [--all]: runs clang-tidy over sources of the library, its C interface, the file formats, the
# commands, the laboratory and MPI, each source by itself. BUILD is configured for clang; nothing is built. Checked are
# the sources that differ from the commit where this branch left main (on main: from the commit before); a header counts as
# the source of its name. With --all every source is checked, as in scripts/nightly.sh. Exit code 77 if clang 14, clang-tidy
# (pinned.sh) or the history is absent.
set -euo pipefail
cd "$(dirname "$0")/.."

clang=$(scripts/clang.sh) || { echo "$clang"; exit 77; }
version=$("$clang" -dumpversion)
[[ ${version%%.*} == 14 ]] || { echo "skipped: clang-tidy 14 cannot read the headers of clang $version"; exit 77; }
tool=$(scripts/pinned.sh clang-tidy) || { echo "$tool"; exit 77; }
folders='(src|c|audit|io|scenes|cli|lab|mpi)'
changed_since() { { git diff --name-only "$1" -- && git ls-files --others --exclude-standard; } | sort -u; }
# Joins names without extension to a pattern: src/api/detector|tools/files/obj
stems_of() { grep -E "^$folders/.*[.](cpp|hpp)$" | grep -v ^paper/tests/ | sed 's/[.][ch]pp$//' | sort -u | paste -sd'|'; }

if [[ ${2:-} == --all ]]; then
  chosen="$folders/(?!tests/)"
else
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null || true)
  [[ -n $base && $base != $(git rev-parse HEAD) ]] || base=$(git rev-parse --verify --quiet HEAD^) ||
    { echo "skipped: no history to compare with"; exit 77; }
  stems=$(changed_since "$base" | stems_of || true)
  [[ -n $stems ]] || { echo "no source differs from $base"; exit 0; }
  chosen="($stems)[.]cpp\$"
fi
cmake --preset clang -B "$1" -DCMAKE_CXX_COMPILER="$clang" -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
sources_of() {
  python3 -c 'import json, re, sys
for entry in json.load(open(sys.argv[1])):
    if re.search(sys.argv[2], entry["file"]): print(entry["file"])' "$1/compile_commands.json" "^$PWD/$chosen"
}
# PyPI's clang-tidy comes without the headers of the compiler itself.
headers=$("$clang" -print-resource-dir)
sources_of "$1" | sort -u |
  xargs --no-run-if-empty -P "$(nproc)" -n 1 "$tool" --quiet -p "$1" --extra-arg-before="-resource-dir=$headers"
