#!/usr/bin/env bash
# check_viewer.sh CHECK [COMMAND|SITE [SCREENSHOTS]]. style: checks types, lint and format of the viewer's sources. page: checks that
# they build the committed pages, byte for byte. tests: runs the tests in Chromium. timed: runs those that bound the time of an
# answer, so nothing else should run. site: tests a built site (scripts/site.sh). Pictures of the pages go to the folder
# SCREENSHOTS, for who wants to look. Exit code 77 if Node, its packages or Chromium is absent.
set -euo pipefail
cd "$(dirname "$0")/../tools/viewer"

skip() { echo "skipped: $1"; exit 77; }
command -v node >/dev/null || skip "no node"
[[ -d node_modules ]] || skip "no tools/viewer/node_modules: scripts/setup.sh --all-tests installs it"
case $1 in
  style)
    node_modules/.bin/tsc --noEmit
    node_modules/.bin/eslint .
    node_modules/.bin/prettier --check .
    ;;
  page)
    built=$(mktemp --suffix=.html)
    trap 'rm -f "$built"' EXIT
    compare() {
      node "$1" "$built"
      cmp "$built" "$2" || { echo "$2, seen from tools/viewer, is not what tools/viewer/src builds: npm run build"; exit 1; }
    }
    compare build.mjs dist/viewer.html
    compare build_program.mjs ../program/dist/index.html
    ;;
  tests | timed)
    export TAMIS_CHROMIUM=${TAMIS_CHROMIUM:-/usr/bin/chromium}
    [[ -x $TAMIS_CHROMIUM ]] || skip "no $TAMIS_CHROMIUM"
    export TAMIS_DATA=${TAMIS_DATA:-$PWD/../../shared/data}
    folder=test
    [[ $1 == tests ]] || folder=test/timed
    TAMIS_COMMAND=$2 TAMIS_SCREENSHOTS=${3:-} node test.mjs "$folder"
    ;;
  site)
    export TAMIS_CHROMIUM=${TAMIS_CHROMIUM:-/usr/bin/chromium}
    [[ -x $TAMIS_CHROMIUM ]] || skip "no $TAMIS_CHROMIUM"
    [[ -e $2/index.html ]] || skip "no $2: scripts/site.sh builds it"
    node ../site/test.mjs "$2" ${3:+"$3"}
    ;;
esac
