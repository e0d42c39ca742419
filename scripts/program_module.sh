#!/usr/bin/env bash
# program_module.sh: builds the module of the site's first page, tools/program/dist/module.js, and lists beside it the sources that
# the compiler read. --check: is the committed module what the sources give? Bytes are compared where emscripten is the pinned one
# (Debian 13's: `scripts/try_in_root.sh trixie scripts/program_module.sh --check`), elsewhere the hashes of these sources.
set -euo pipefail
cd "$(dirname "$0")/.."

pinned=3.1.69
list=tools/program/dist/module.sources
build=build/wasm
case $* in
  "" | --check) ;;
  *) echo "program_module.sh: $*: say --check or nothing" >&2; exit 2 ;;
esac
if ! em++ --version 2>/dev/null | grep -qF " $pinned "; then
  [[ ${1:-} == --check ]] || { echo "program_module.sh: no emscripten $pinned: Debian 13 has it (scripts/setup.sh --wasm)" >&2; exit 1; }
  sha256sum --check --quiet "$list" || { echo "tools/program/dist/module.js is older than these sources: scripts/program_module.sh" >&2; exit 1; }
  echo "the module is of these sources, by their hashes: no emscripten $pinned is here to build it"
  exit
fi

cmake --preset wasm >/dev/null
cmake --build --preset wasm --target tamis_program
if [[ ${1:-} == --check ]]; then
  node tools/program/module.mjs same $build/tools/program
  echo "the module is what the sources give, byte for byte"
  exit
fi
node tools/program/module.mjs pack $build/tools/program
# What the compiler read of the project, and what decides how.
objects=$(ninja -C $build -t inputs tamis_program | grep '\.o$')
{
  (cd $build && ninja -t deps $objects | sed -n 's/^  *//p' | xargs realpath --relative-to=../..) | grep -v '^\.\./\|^build/'
  printf '%s\n' CMakePresets.json bindings/wasm/check_engine.js cmake/{tamis_target,wasm}.cmake tools/program/CMakeLists.txt
} | LC_ALL=C sort -u | xargs sha256sum >$list
echo "tools/program/dist/module.js: $(wc -c <tools/program/dist/module.js) bytes, of $(wc -l <$list) sources"
