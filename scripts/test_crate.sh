#!/usr/bin/env bash
# test_crate.sh [FOLDER]: packs the crate, and builds the README's example as a project that has the .crate file and no network. With
# FOLDER the crate links the libtamis_c there; else it builds the library from what it carries, and nothing else of Boost and xsimd.
# A second version of the crate in the same project is refused. Exits with 77 where cargo, or a crate that it needs, cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

library=${1:-}
work=$PWD/build/crate${library:+_system}
rm -rf "$work"
mkdir -p "$work/user/src"
scripts/release_crate.sh "$work"
version=$(basename "$work"/tamis-*.crate .crate)
version=${version#tamis-}

# As cargo vendor leaves a crate: beside those that it needs.
vendor=$work/vendor
fetch=(--quiet --locked --manifest-path bindings/rust/Cargo.toml)
cargo vendor --offline "${fetch[@]}" "$vendor" >/dev/null 2>&1 || timeout 120 cargo vendor "${fetch[@]}" "$vendor" >/dev/null ||
  { echo "skipped: the crates are not here, and their registry cannot be reached"; exit 77; }
tar -C "$vendor" -xzf "$work/tamis-$version.crate"
mv "$vendor/tamis-$version" "$vendor/tamis"
sum=$(sha256sum "$work/tamis-$version.crate" | cut -d' ' -f1)
echo "{\"files\":{},\"package\":\"$sum\"}" >"$vendor/tamis/.cargo-checksum.json"

user=$work/user
mkdir "$user/.cargo"
printf '[source.crates-io]\nreplace-with = "here"\n[source.here]\ndirectory = "%s"\n' "$vendor" >"$user/.cargo/config.toml"
printf '[package]\nname = "user"\nversion = "1.0.0"\nedition = "2021"\n[dependencies]\ntamis = "%s"\n[features]\nsystem = ["tamis/system"]\nclamp = ["tamis/clamp"]\n' \
  "$version" >"$user/Cargo.toml"
cp bindings/rust/examples/hello.rs "$user/src/main.rs"
unset TAMIS_LIBRARY_DIR
features=("" clamp)
if [[ -n $library ]]; then
  export TAMIS_LIBRARY_DIR=$library LD_LIBRARY_PATH=$library
  features=(system)
fi
for feature in "${features[@]}"; do
  (cd "$user" && cargo build --quiet --offline --features "$feature")
  "$user/target/debug/user" | diff examples/output/hello.rs.txt -
done
if [[ -z $library ]]; then
  read=$(grep -rlE --include='*.d' '/usr/include/(boost|xsimd)/' "$user/target" || true)
  [[ -z $read ]] || { echo "test_crate.sh: the crate takes headers of the system: $read" >&2; exit 1; }
fi

cp -r "$vendor/tamis" "$work/next"
sed -i "s/^version = \"$version\"/version = \"99.0.0\"/" "$work/next/Cargo.toml"
printf 'next = { package = "tamis", path = "../next" }\n' >"$work/line"
sed -i "/^tamis = /r $work/line" "$user/Cargo.toml"
! (cd "$user" && cargo build --quiet --offline 2>"$work/refused.txt") || { echo "test_crate.sh: two versions are linked" >&2; exit 1; }
grep -q 'tamis_c' "$work/refused.txt"
echo "test_crate: a project uses tamis-$version.crate${library:+, which links $library}"
