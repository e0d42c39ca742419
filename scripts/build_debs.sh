#!/usr/bin/env bash
# build_debs.sh [FOLDER]: makes the Debian packages libtamis0.1, libtamis-dev and tamis in FOLDER (build/debs), and checks them by
# lintian if it is installed. Packages that are made on Debian 12 are for Debian 12 and newer. The same commit gives the same bytes.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$(realpath -m "${1:-build/debs}")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
umask 022
cmake --preset debian
cmake --build --preset debian
rm -rf build/debian/_CPack_Packages "$out"
mkdir -p "$out"
cpack --config build/debian/CPackConfig.cmake -B "$out"
rm -rf "$out/_CPack_Packages"
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error "$out"/*.deb
else
  echo "build_debs: lintian is not installed: the packages are not checked"
fi
ls -l "$out"
