#!/usr/bin/env bash
# site.sh [FOLDER]: builds the site from the documents and the reference of C++, C and Python, into build/site or FOLDER.
# A broken link, a public name without a comment, and anything that a page would load from elsewhere fail. Exit code 77 if
# Doxygen is absent, or if Sphinx cannot be had from PyPI (pinned.sh). Without a compiler: docstrings are read, not run.
set -euo pipefail
cd "$(dirname "$0")/.."

skip() { echo "skipped: $1"; exit 77; }
[[ -e .git ]] || skip "no Git checkout"
command -v doxygen >/dev/null || skip "no doxygen: scripts/setup.sh --site installs it"
sphinx=$(scripts/pinned.sh sphinx-build site) || { echo "$sphinx"; exit 77; }
site=$(realpath -m "${1:-build/site}")
work=$site.work
[[ ! -e $site || -e $site/.buildinfo ]] || { echo "site.sh: $site is there and is not a site: give a new folder" >&2; exit 2; }
rm -rf "$work" "$site"
mkdir -p "$work/html" "$work/cpp" "$work/c"

read_headers() { # of a language, by the rest of the options
  { cat tools/site/Doxyfile; printf '%s\n' STRIP_FROM_PATH=include OUTPUT_DIRECTORY="$work/$1" "${@:2}"; } | doxygen -
}
read_headers cpp INPUT=include/tamis FILE_PATTERNS=*.hpp
read_headers c INPUT="include/tamis/c include/tamis/tamis.h" FILE_PATTERNS=*.h OPTIMIZE_OUTPUT_FOR_C=YES EXTENSION_MAPPING=h=C \
  PREDEFINED=TAMIS_API=
export TAMIS_SITE=$work PYTHONDONTWRITEBYTECODE=1
"${sphinx%/*}/python" tools/site/pages.py "$work"
"$sphinx" --quiet --fail-on-warning --keep-going --jobs auto --conf-dir tools/site --doctree-dir "$work/doctrees" \
  "$work/source" "$site"
"${sphinx%/*}/python" tools/site/check_built.py "$site"
rm -rf "$work"
echo "the site: $site/index.html, $(du -sh "$site" | cut -f1)"
