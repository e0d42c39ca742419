#!/usr/bin/env bash
# Makes the part of a release that needs no build twice: the bytes must be the same. Another version must be refused.
set -euo pipefail
cd "$(dirname "$0")/../.."
version=$(sed -n 's/^project(tamis VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scripts/release.sh "$version" --cheap "$work/first"
sleep 1.1
scripts/release.sh "$version" --cheap "$work/second" >/dev/null
diff -r "$work/first" "$work/second"
for name in tamis-"$version"{-sources.tar.gz,.cdx.json} CHANGES.md CITATION.cff SHA256SUMS; do [[ -s $work/first/$name ]]; done
(cd "$work/first" && sha256sum --check --quiet SHA256SUMS)
if scripts/release.sh 99.0.0 --cheap "$work/third" >"$work/says"; then echo "version 99.0.0 is not refused" >&2; exit 1; fi
grep -q "not 99.0.0" "$work/says"
echo "the same bytes twice"
