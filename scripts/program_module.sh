#!/usr/bin/env bash
# program_module.sh: builds the module of the site's first page and of the package of npm, tools/program/dist/module.js.
# --check: fails unless the committed module is what the sources give, byte for byte. Both need the pinned emscripten, which Debian 13
# has (scripts/setup.sh --wasm); as a check it exits with 77 without it. scripts/test_wasm.sh checks at night.
set -euo pipefail
cd "$(dirname "$0")/.."

pinned=3.1.69
build=build/wasm
case $* in
  "" | --check) ;;
  *) echo "program_module.sh: $*: say --check or nothing" >&2; exit 2 ;;
esac
if ! em++ --version 2>/dev/null | grep -qF " $pinned "; then
  echo "program_module.sh: no emscripten $pinned: Debian 13 has it (scripts/setup.sh --wasm)" >&2
  [[ ${1:-} != --check ]] || exit 77
  exit 1
fi

cmake --preset wasm >/dev/null
cmake --build --preset wasm --target tamis_wasm
if [[ ${1:-} == --check ]]; then
  node tools/program/module.mjs same $build/bindings/wasm
  echo "the module is what the sources give, byte for byte"
  exit
fi
node tools/program/module.mjs pack $build/bindings/wasm
echo "tools/program/dist/module.js: $(wc -c <tools/program/dist/module.js) bytes"
