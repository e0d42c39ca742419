#!/usr/bin/env bash
# test_arm64_wheel.sh WHEEL HERE: tests the wheel for Linux on ARM64 as scripts/python_versions.sh does, in this Debian's Python for that
# processor, under qemu, and compares every contact of the generated scenes with those of the wheel HERE, for this machine. Python's
# arm64 packages are unpacked into build/arm64-python: nothing installed here is changed. Exit code 77 if they cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1") here=$(realpath "$2")

folder=$PWD/build/arm64-python
emulator="qemu-aarch64 -L $folder/root"
download() {
  rm -rf "$folder"
  mkdir -p "$folder"/{lists/partial,cache/archives/partial}
  : >"$folder/status"  # as if nothing were installed: all that Python needs comes, too
  local apt=(apt-get -q -oAPT::Architecture=arm64 -oAPT::Architectures=arm64 -oDir::State::Lists="$folder/lists" -oDebug::NoLocking=1
             -oDir::Cache="$folder/cache" -oDir::State::status="$folder/status")
  "${apt[@]}" update && "${apt[@]}" install --yes --download-only --no-install-recommends python3-venv libstdc++6 || return
  for package in "$folder"/cache/archives/*.deb; do dpkg-deb -x "$package" "$folder/root"; done
  # Python starts itself again by its own name: this program's.
  printf '#!/bin/sh\nexec %s -0 "$0" %s "$@"\n' "$emulator" "$(echo "$folder"/root/usr/bin/python3.[0-9]*)" >"$folder/python"
  chmod +x "$folder/python"
  rm -r "$folder/lists" "$folder/cache"
}
no_packages() { echo "skipped: $1 cannot be had"; exit 77; }

scripts/setup.sh --wheels || no_packages "qemu"
[[ -e $folder/python ]] || download || no_packages "Python for arm64"
EMULATOR=$emulator scripts/python_versions.sh "$wheel" "$folder/python"
python3 -m venv "$folder/here"
"$folder/here/bin/pip" --quiet --disable-pip-version-check install "$here"
"$folder/here/bin/python" scripts/wheel_bits.py >"$folder/bits.txt"
"$folder/python" -c 'import sys; print("%d.%d-aarch64" % sys.version_info[:2])' >"$folder/version.txt"
diff "$folder/bits.txt" "build/python-versions/$(cat "$folder/version.txt")/bits.txt"
echo "the same on both: every bit of every contact"
