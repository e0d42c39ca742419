#!/usr/bin/env bash
# The same bits on 64-bit ARM (NEON): cross-compiles Tamis, runs it under qemu, and compares every contact of the
# generated scenes and of the recorded frames with this machine's. With --all it also runs the unit tests there.
# The libraries' arm64 packages are unpacked into build/arm64-packages: nothing installed here is changed. Exits with 77
# where the packages cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

case $* in
  "") target=tamis_same_bits ;;
  --all) target=all ;;
  *) echo "test_arm64.sh: $*: say --all or nothing" >&2; exit 2 ;;
esac

download() {
  apt=(apt-get -oAPT::Architecture=arm64 -oAPT::Architectures=arm64 -oDir::State::Lists="$packages/lists"
       -oDir::Cache="$packages/cache")
  fmt=$(dpkg-query -W -f='${Depends}' libfmt-dev | grep -o 'libfmt[0-9]*')
  rm -rf "$packages" && mkdir -p "$packages"/{lists/partial,cache/archives/partial,archives}
  "${apt[@]}" update -q || return
  (cd "$packages/archives" && "${apt[@]}" download -q \
    libxsimd-dev libtbb-dev libtbb12 libtbbmalloc2 libtbbbind-2-5 libhwloc15 libudev1 libfmt-dev "$fmt" \
    libmeshoptimizer-dev libmeshoptimizer2d zlib1g-dev zlib1g libgtest-dev) || return
  for package in "$packages"/archives/*.deb; do dpkg-deb -x "$package" "$packages"; done
  touch "$packages/complete"
}
no_packages() { echo "skipped: $1 cannot be had"; exit 77; }

packages=$PWD/build/arm64-packages
scripts/setup.sh --arm64 || no_packages "Debian's compiler for ARM, or qemu"
[[ -e $packages/complete ]] || download || no_packages "the libraries' arm64 packages"

cmake --preset arm64 -DTAMIS_ARM64_PACKAGES="$packages"
cmake --build --preset arm64 --target "$target"
scripts/setup.sh --all-tests
cmake --preset dev
cmake --build --preset dev --target tamis_same_bits

qemu=(qemu-aarch64 -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH="$packages/usr/lib/aarch64-linux-gnu:$packages/lib/aarch64-linux-gnu")
build/dev/tools/command/tests/same_bits/tamis_same_bits >build/same_bits_here.txt
"${qemu[@]}" build/arm64/tools/command/tests/same_bits/tamis_same_bits >build/same_bits_arm64.txt
diff build/same_bits_here.txt build/same_bits_arm64.txt
cat build/same_bits_here.txt
echo "the same on both: every bit of every contact"
[[ $target != all ]] || ctest --preset arm64 --parallel "$(nproc)"
