#!/usr/bin/env bash
# try_release.sh FOLDER [PART...]: in a root that has nothing yet (scripts/try_in_root.sh), installs each package of a release in FOLDER as its
# users do, and runs the README's example with it: Debian's by apt, the archive for Linux by CMake and pkg-config, the wheel by pip,
# npm's file by npm, the crate by cargo add --path, and the recipe of Conan from the archive of the sources. A package that the
# release lacks is named. Takes some ten minutes; PARTs are by_apt, by_archive, by_pip, by_npm, by_cargo and by_conan.
set -euo pipefail
folder=$(realpath "$1")
cd "$(dirname "$0")/.."
root=$PWD
export DEBIAN_FRONTEND=noninteractive
install() { apt-get install -q -y --no-install-recommends "$@" >/dev/null; }
left_out=()
work=$(mktemp -d)
tar -C "$work" -xzf "$folder"/tamis-*-sources.tar.gz
sources=$(echo "$work"/tamis-*)

by_pip() {
  install python3-venv
  python3 -m venv "$work/env"
  "$work/env/bin/pip" install --quiet "$1"
  "$work/env/bin/python" examples/hello.py | diff - examples/output/hello.py.txt
}

by_npm() {
  install nodejs npm
  mkdir "$work/npm" && cd "$work/npm"
  npm install --silent --no-audit --no-fund "$1"
  cp "$root/examples/hello.mjs" . && node hello.mjs | diff - "$root/examples/output/hello.mjs.txt"
}

by_cargo() {
  local web=  # Debian 12's cargo is too old, and has a newer one beside it
  ! apt-cache show cargo-web >/dev/null 2>&1 || web=-web
  install cargo$web rustc$web g++ cmake make
  mkdir "$work/crate" && tar -C "$work/crate" --strip-components=1 -xzf "$1"
  cargo new --quiet "$work/user" && cd "$work/user"
  cargo add --quiet --path "$work/crate"
  cp "$root/bindings/rust/examples/hello.rs" src/main.rs
  cargo run --quiet | diff - "$root/examples/output/hello.rs.txt"
}

by_conan() {
  install python3-venv g++ cmake make libboost-dev libxsimd-dev
  "$sources/scripts/test_conan.sh" shared=False
}

by_apt() { scripts/try_debs.sh "$folder"; }

# The archive for Linux, by CMake and by pkg-config.
by_archive() {
  install g++ cmake make pkg-config
  tar -C "$work" -xzf "$1"
  local prefix
  prefix=$(echo "$work"/tamis-*-linux-*)
  cmake -S packaging/vcpkg/consumer -B "$work/consumer" -D CMAKE_PREFIX_PATH="$prefix" >/dev/null && cmake --build "$work/consumer" >/dev/null
  "$work/consumer/hello" | diff - examples/output/hello.cpp.txt
  export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
  gcc examples/hello.c -o "$work/hello_c" $(pkg-config --cflags --libs tamis-c) -Wl,-rpath,"$prefix/lib"
  "$work/hello_c" | diff - examples/output/hello.c.txt
}

parts=("${@:2}")
((${#parts[@]})) || parts=(by_apt by_archive by_pip by_npm by_cargo by_conan)
declare -A file=([by_apt]=$(echo "$folder"/libtamis0*.deb) [by_pip]=$(echo "$folder"/tamis-*"$(uname -m)".whl)
  [by_npm]=$(echo "$folder"/tamis-*.tgz) [by_cargo]=$(echo "$folder"/tamis-*.crate) [by_conan]=$folder
  [by_archive]=$(echo "$folder"/tamis-*-linux-"$(uname -m)".tar.gz))
apt-get update -q >/dev/null
for part in "${parts[@]}"; do
  cd "$root"
  if [[ ! -e ${file[$part]} ]]; then left_out+=("$part: the release has none"); continue; fi
  "$part" "${file[$part]}"
  echo "try_release: $part is done"
done
((${#left_out[@]} == 0)) || printf 'try_release: left out: %s\n' "${left_out[@]}"
