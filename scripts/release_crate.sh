#!/usr/bin/env bash
# release_crate.sh FOLDER: packs the crate tamis into FOLDER: bindings/rust, the library's sources, and the headers of Boost and xsimd
# that they need, as this machine has them. Nothing is built. Exits with 77 where cargo is missing, or its registry cannot be reached.
set -euo pipefail
out=$(realpath -m "$1")
cd "$(dirname "$0")/.."

command -v cargo >/dev/null || { echo "skipped: no cargo here; install Rust"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git ls-files -z bindings/rust | grep -zv '/tests/' | xargs -0 cp --parents -t "$work"
crate=$work/bindings/rust
library=$crate/library
mkdir -p "$library/third_party" "$out"
git ls-files -z CMakeLists.txt LICENSE cmake include src bindings/c integrations |
  grep -zvE '^(integrations/(bullet|blender|rapier/(tamis|Cargo|rustfmt)|tests)|bindings/c/tests)' | xargs -0 cp --parents -t "$library"
cp LICENSE "$crate"
cp packaging/debian/copyright "$library/LICENCES"
echo "release_crate: with $(python3 scripts/carry_headers.py "$library/third_party")"
pack() { (cd "$crate" && cargo package --quiet --no-verify --allow-dirty --locked --target-dir "$work/target" "$@"); }
pack --offline 2>/dev/null || timeout 120 pack || { echo "skipped: the registry of crates cannot be reached"; exit 77; }
cp "$work"/target/package/tamis-*.crate "$out"
ls -l "$out"/tamis-*.crate
