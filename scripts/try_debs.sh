#!/usr/bin/env bash
# try_debs.sh FOLDER: installs the Debian packages in FOLDER into the root that this is run in (scripts/try_in_root.sh), then builds
# and runs the README's example by find_package and by pkg-config, in C++ and in C, and asks the command, its page and completions.
set -euo pipefail
debs=$(realpath "$1")
cd "$(dirname "$0")/.."
export DEBIAN_FRONTEND=noninteractive
apt-get update -q >/dev/null
# g++ and make are the user's own; everything else comes with the packages.
apt-get install -q -y --no-install-recommends g++ make cmake pkg-config man-db bash-completion fish zsh "$debs"/*.deb >/dev/null
work=$(mktemp -d)
mkdir "$work/consumer"
expect() { "$@" | diff - examples/output/hello.cpp.txt; echo "try_debs: $1"; }
sed "s|../../../examples|$PWD/examples|" packaging/vcpkg/consumer/CMakeLists.txt >"$work/consumer/CMakeLists.txt"
cmake -S "$work/consumer" -B "$work/build" >/dev/null && cmake --build "$work/build" >/dev/null
expect "$work/build/hello"
g++ -std=c++20 examples/hello.cpp -o "$work/by_pkg_config" $(pkg-config --cflags --libs tamis)
expect "$work/by_pkg_config"
gcc examples/hello.c -o "$work/by_pkg_config_c" $(pkg-config --cflags --libs tamis-c)
"$work/by_pkg_config_c" | diff - examples/output/hello.c.txt
tamis --version
tamis scene funnel --triangles 500 --frames 2 --out "$work/frames" >/dev/null
tamis contacts "$work/frames/frame_0000.ply" "$work/frames/frame_0001.ply" --out "$work/page.html"
man tamis | grep safe-step >/dev/null
fish -c 'complete -C "tamis trun"' | grep '^truncate' >/dev/null
bash -c 'source /usr/share/bash-completion/completions/tamis; COMP_WORDS=(tamis trun); COMP_CWORD=1; _tamis; [[ ${COMPREPLY[*]} == truncate ]]'
zsh -n /usr/share/zsh/vendor-completions/_tamis
apt-get remove -q -y tamis libtamis-dev "libtamis0.1" >/dev/null
[[ ! -e /usr/bin/tamis ]]
echo "try_debs: all passed"
