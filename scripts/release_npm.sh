#!/usr/bin/env bash
# release_npm.sh FOLDER: packs the package of npm into FOLDER: bindings/npm, and the WebAssembly of tools/program/dist/module.js, which is
# committed (scripts/program_module.sh). Exits with 77 where npm, or TypeScript in tools/viewer, cannot be had.
set -euo pipefail
out=$(realpath -m "$1")
cd "$(dirname "$0")/.."

command -v npm >/dev/null || { echo "skipped: no npm here; install Node 18 or newer"; exit 77; }
if [[ ! -e tools/viewer/node_modules/typescript ]]; then
  (cd tools/viewer && npm ci --silent --ignore-scripts) || { echo "skipped: TypeScript is not here, and npm's registry cannot be reached"; exit 77; }
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node bindings/npm/pack.mjs "$work"
mkdir -p "$out"
(cd "$work" && npm pack --silent --pack-destination "$out")
