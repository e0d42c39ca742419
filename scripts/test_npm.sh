#!/usr/bin/env bash
# test_npm.sh [--bundler]: packs the package of npm, installs the file into an empty project without a network, and runs there the
# README's examples and the package's tests; TypeScript checks a program that uses it. --bundler: also a project that Vite bundles,
# whose page Chromium opens, with the worker of examples/worker; Vite is npm's. Exits with 77 where something cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

work=$PWD/build/npm
rm -rf "$work"
mkdir -p "$work/user"
scripts/release_npm.sh "$work"
file=$(echo "$work"/tamis-*.tgz)
install() { npm install --silent --no-audit --no-fund "$@"; }

cd "$work/user"
echo '{"private": true, "type": "module"}' >package.json
install --offline "$file"
cp ../../../bindings/npm/tests/{package_test,scene,detectors,paths,worlds,planners,pairs}.mjs node_modules/tamis/examples/*.mjs .
for example in hello bodies curve; do node $example.mjs | diff "../../../examples/output/$example.mjs.txt" -; done
TAMIS_HEADERS=../../../include/tamis/c node --test package_test.mjs
# A program that TypeScript accepts, except for the lines that it marks as wrong.
cp ../../../bindings/npm/tests/types.ts .
node ../../../tools/viewer/node_modules/typescript/bin/tsc --noEmit --strict --target es2022 --lib es2022,esnext.disposable,dom \
  --module nodenext --moduleResolution nodenext types.ts
# A module of another version is refused.
sed -i 's/^export const version = .*/export const version = "99.0.0";/' node_modules/tamis/module.js
! node hello.mjs 2>refused.txt || { echo "test_npm.sh: a module of another version is taken" >&2; exit 1; }
grep -q 'TamisError: module.js holds tamis .*, but the package is 99.0.0: install the package anew' refused.txt
echo "test_npm: a project without a network uses $(basename "$file")"
[[ ${1:-} == --bundler ]] || exit 0

cp -r ../../../bindings/npm/examples/worker "$work/bundled"
cd "$work/bundled"
echo '{"private": true, "type": "module"}' >package.json
install "$file" vite@7.3.8 || { echo "skipped: npm's registry cannot be reached"; exit 77; }
npx vite build --base ./ --logLevel warn
cd ../../..
node bindings/npm/tests/in_browser.mjs "$work/bundled/dist"
