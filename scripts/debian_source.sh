#!/usr/bin/env bash
# debian_source.sh PACKAGE FOLDER: unpacks the source of a package of Debian, as its authors wrote it, into the new FOLDER. The
# system's lists of packages stay as they are.
set -euo pipefail

lists=$(mktemp -d)
trap 'rm -rf "$lists"' EXIT
mkdir -p "$lists"/{lists/partial,cache/archives/partial,sources,packed} "$2"
for file in /etc/apt/sources.list.d/*.sources; do
  [[ ! -e $file ]] || sed 's/^Types: deb$/Types: deb-src/' "$file" >"$lists/sources/$(basename "$file")"
done
[[ ! -e /etc/apt/sources.list ]] || sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$lists/sources/main.list"
apt=(apt-get -q -oDir::State::Lists="$lists/lists" -oDir::Cache="$lists/cache" -oAPT::Sandbox::User=root
     -oDir::Etc::sourceparts="$lists/sources" -oDir::Etc::sourcelist=/dev/null)
"${apt[@]}" update
(cd "$lists/packed" && "${apt[@]}" source --download-only "$1")
tar -xf "$lists"/packed/*.orig.tar.* --strip-components=1 -C "$2"
