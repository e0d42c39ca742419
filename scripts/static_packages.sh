#!/usr/bin/env bash
# static_packages.sh FOLDER [--tbb] [--googletest] OPTION...: the libraries that Tamis needs, for static linking, in FOLDER:
# this machine's header-only ones, with files for CMake, away from the C library; others from Debian's sources, compiled with
# these options of cmake. Makes nothing again.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=$(realpath -m "$1")
shift
wanted=()
while [[ ${1:-} =~ ^--(tbb|googletest)$ ]]; do wanted+=("$1"); shift; done
options=("$@")
[[ ! -e $packages/complete ]] || exit 0
rm -rf "$packages"

# by_cmake NAME SOURCE OPTION...: builds and installs a library. SOURCE is a folder, or the name of a package of Debian.
by_cmake() {
  local source=$2
  [[ $source == /* ]] || { source=$packages/sources/$1; scripts/debian_source.sh "$2" "$source"; }
  cmake -S "$source" -B "$packages/from_source/$1" -G Ninja -D CMAKE_BUILD_TYPE=Release -D BUILD_SHARED_LIBS=OFF \
    -D CMAKE_POSITION_INDEPENDENT_CODE=ON -D CMAKE_INSTALL_LIBDIR=lib "${options[@]}" "${@:3}"
  cmake --build "$packages/from_source/$1"
  cmake --install "$packages/from_source/$1" --prefix "$packages"
}

scripts/header_package.sh "$packages" xsimd xsimd libxsimd-dev xsimd
ln -s /usr/include/boost "$packages/include/"  # cmake/FindBoostHeaders.cmake needs no more
scripts/header_package.sh "$packages" CLI11 CLI11::CLI11 libcli11-dev CLI
scripts/header_package.sh "$packages" nlohmann_json nlohmann_json::nlohmann_json nlohmann-json3-dev nlohmann
scripts/header_package.sh "$packages" fmt fmt::fmt libfmt-dev fmt FMT_HEADER_ONLY
scripts/header_package.sh "$packages" Eigen3 Eigen3::Eigen libeigen3-dev eigen3/Eigen
by_cmake meshoptimizer meshoptimizer
for each in "${wanted[@]}"; do
  case $each in
    --tbb) by_cmake tbb onetbb -D TBB_TEST=OFF -D TBBMALLOC_BUILD=OFF -D TBB_STRICT=OFF -D TBB_ENABLE_IPO=OFF \
      -D TBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON ;;
    --googletest) by_cmake googletest /usr/src/googletest -D BUILD_GMOCK=OFF ;;
  esac
done
touch "$packages/complete"
