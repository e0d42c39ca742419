#!/usr/bin/env bash
# release.sh VERSION [--cheap] [FOLDER]: makes all files of a release from a clean clone of HEAD, in FOLDER (build/release/VERSION):
# the archive of the sources, Debian packages, archives for Linux, Windows and macOS, wheels, crate and npm package; what changed,
# CITATION.cff, a bill of materials, and the SHA-256 of each file. It uploads nothing. The same commit gives the same bytes.
#   --cheap   only what needs no build: archive, crate, npm package
# A part whose tools are missing is named at the end. VERSION stands in CMakeLists.txt: scripts/check_version.py.
set -euo pipefail
cd "$(dirname "$0")/.."

version=${1:?say which version, as 0.1.0}
shift
cheap=
if [[ ${1:-} == --cheap ]]; then cheap=yes; shift; fi
out=$(realpath -m "${1:-build/release/$version}")
packages=$PWD/build/windows-packages  # what scripts/test_windows.sh gathered before, if it did
modules=$PWD/tools/viewer/node_modules
python3 scripts/check_version.py "$version"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone --quiet . "$work/tamis"
cd "$work/tamis"
commit=$(git rev-parse HEAD)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH LC_ALL=C TZ=UTC
umask 022
rm -rf "$out" && mkdir -p "$out"
name=tamis-$version
left_out=()

# packed FOLDER: an archive of a folder in $work whose bytes depend on names and contents alone.
packed() {
  tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mode=go=rX,u+rw --mtime=@"$SOURCE_DATE_EPOCH" -cf - "$1" |
    gzip -9n >"$out/$1.tar.gz"
}

debian() {
  scripts/build_debs.sh "$work/debs"
  cp "$work"/debs/*.deb "$out"
}

# linux PROCESSOR: library and C interface.
linux() {
  local folder=$name-linux-$1
  python3 scripts/release_archive.py build/wheels "$work/$folder" "$1"
  packed "$folder"
}

# c_interface SYSTEM FILE...: the C interface alone, as a C++ library fits one compiler.
c_interface() {
  local folder=$name-$1
  mkdir -p "$work/$folder/include/tamis"
  cp -P "${@:2}" LICENSE packaging/debian/copyright "$work/$folder"
  cp -r include/tamis/tamis.h include/tamis/c "$work/$folder/include/tamis"
  packed "$folder"
}

windows() {
  if ! { command -v x86_64-w64-mingw32-g++-posix && command -v wine; } >/dev/null; then
    left_out+=("Windows: MinGW-w64 or Wine is missing (scripts/setup.sh --windows)")
    return
  fi
  mkdir -p build
  [[ ! -e $packages/complete ]] || ln -s "$packages" build/windows-packages
  scripts/test_windows.sh --dll
  c_interface windows-x86_64 build/windows/bin/libtamis_c-*.dll build/windows/bindings/c/*.dll.a build/windows/bindings/c/*.lib
}

macos() {
  scripts/build_macos.sh
  c_interface macos-arm64 build/macos/bindings/c/libtamis_c*.dylib
}

# elsewhere SCRIPT: a part with a script of its own, which writes its files into the folder it is given.
elsewhere() {
  if [[ ! -x $1 ]]; then left_out+=("$1 does not exist"); return; fi
  mkdir -p "$work/part"
  local rc=0
  "$1" "$work/part" || rc=$?
  case $rc in
    0)
      for file in "$work"/part/*; do
        [[ ! -e $out/${file##*/} ]] || { echo "release.sh: $1 makes a second ${file##*/}" >&2; exit 1; }
        cp "$file" "$out"
      done
      ;;
    77) left_out+=("$1 was skipped") ;;
    *) echo "release.sh: $1 ended with $rc" >&2; exit 1 ;;
  esac
  rm -rf "$work/part"
}

git archive --format=tar --prefix="$name/" HEAD | gzip -9n >"$out/$name-sources.tar.gz"  # without -sources: Python's
awk -v title="## $version" 'index($0, "## ") == 1 { on = index($0, title) == 1 } on' CHANGELOG.md >"$out/CHANGES.md"
if [[ ! -s $out/CHANGES.md ]]; then
  left_out+=("CHANGELOG.md has no part '## $version': CHANGES.md has its part 'Unreleased'")
  awk '/^## / { on = /^## Unreleased/ } on' CHANGELOG.md >"$out/CHANGES.md"
fi
[[ -s $out/CHANGES.md ]] || { echo "release.sh: CHANGELOG.md has neither a part '## $version' nor '## Unreleased'" >&2; exit 1; }
cp CITATION.cff "$out"
[[ ! -e $modules ]] || ln -s "$modules" tools/viewer/node_modules
for part in crate npm; do elsewhere scripts/release_$part.sh; done
if [[ -z $cheap ]]; then
  debian
  windows
  if ! scripts/pinned.sh python zig >/dev/null; then
    left_out+=("archives for Linux and macOS, and the wheels: PyPI cannot be reached")
  else
    scripts/setup.sh --wheels
    elsewhere scripts/release_wheels.sh
    for system in manylinux_2_28_x86_64 manylinux_2_28_aarch64 macosx_11_0_arm64 win_amd64; do
      compgen -G "$out/*-$system.whl" >/dev/null || left_out+=("the wheel for $system: release_wheels.sh said above what is missing")
    done
    for processor in x86_64 aarch64; do linux $processor; done
    macos
  fi
fi
python3 scripts/sbom.py "$version" "$commit" "$SOURCE_DATE_EPOCH" "$out"/* >"$work/sbom.json"
cp "$work/sbom.json" "$out/$name.cdx.json"
(cd "$out" && sha256sum -- * >"$work/SHA256SUMS" && cp "$work/SHA256SUMS" .)
cat "$out/SHA256SUMS"
((${#left_out[@]} == 0)) || printf 'release: left out: %s\n' "${left_out[@]}"
