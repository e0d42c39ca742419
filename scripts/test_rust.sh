#!/usr/bin/env bash
# test_rust.sh FOLDERS TARGET: builds and tests bindings/rust and integrations/rapier against the libraries tamis_c and tamis_clamp
# in FOLDERS (A:B). cargo's output stays in TARGET. Exit code 77 if cargo is missing or too old, or if the crates they need
# are missing and the registry cannot be reached.
set -euo pipefail
cd "$(dirname "$0")/.."

needed=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' integrations/rapier/Cargo.toml)
if ! here=$(cargo --version 2>/dev/null | cut -d' ' -f2) || [[ -z $here ]]; then
  echo "skipped: no cargo here; install Rust $needed or newer"
  exit 77
fi
if [[ $(printf '%s\n' "$needed" "$here" | sort -V | head -n 1) != "$needed" ]]; then
  echo "skipped: cargo $here is too old; install Rust $needed or newer"
  exit 77
fi
crates=(bindings/rust integrations/rapier)
fetch() { (cd "$1" && { cargo fetch --quiet --locked --offline 2>/dev/null || timeout 120 cargo fetch --quiet --locked; }); }
for crate in "${crates[@]}"; do
  if ! fetch "$crate"; then
    echo "skipped: the crates are not here, and their registry cannot be reached"
    exit 77
  fi
  ! cargo fmt --version >/dev/null 2>&1 || (cd "$crate" && cargo fmt --all --check)
done
export TAMIS_LIBRARY_DIR=$1 LD_LIBRARY_PATH=$1${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export RUSTFLAGS="${RUSTFLAGS:-} -D warnings"  # of these crates alone
run() { (cd "$1" && cargo test --quiet --locked --offline --target-dir "$2" "${@:3}"); }
run bindings/rust "$2"  # without the clamp, as most users have it
run bindings/rust "$2" --features clamp
run integrations/rapier "$2"
# A library that calls itself another version: this function hides that of libtamis_c.
echo 'const char* tamis_version(void) { return "99.0.0"; }' | ${CC:-cc} -shared -fPIC -x c -o "$2/libanother_version.so" -
LD_PRELOAD=$2/libanother_version.so run bindings/rust "$2" --test another_version -- --ignored
