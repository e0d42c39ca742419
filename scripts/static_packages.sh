#!/usr/bin/env bash
# static_packages.sh FOLDER [--tbb] [--zlib] [--googletest] OPTION...: the libraries that Tamis needs, for static linking, in FOLDER:
# this machine's header-only ones, with files for CMake, away from the C library; others from Debian's sources, compiled with
# these options of cmake. Makes nothing again.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=$(realpath -m "$1")
shift
wanted=()
while [[ ${1:-} =~ ^--(tbb|zlib|googletest)$ ]]; do wanted+=("$1"); shift; done
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

# Its own files for CMake always make a shared library, too, and need files that Debian's source does not have.
zlib() {
  local source=$packages/sources/zlib
  scripts/debian_source.sh zlib "$source"
  cat >"$source/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.20)
project(zlib C)
add_library(z STATIC adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c uncompr.c zutil.c)
target_compile_definitions(z PRIVATE fdopen=fdopen)  # zutil.h takes a new Mac for an old one, without this function
target_compile_options(z PRIVATE -w)
install(TARGETS z)
install(FILES zlib.h zconf.h DESTINATION include)
END
  by_cmake zlib "$source"
}

scripts/header_package.sh "$packages" xsimd xsimd libxsimd-dev xsimd
ln -s /usr/include/boost "$packages/include/"  # cmake/FindBoostHeaders.cmake needs no more
[[ ! -e /usr/include/fast_float ]] || ln -s /usr/include/fast_float "$packages/include/"  # for libc++ (tools/files/text.cpp)
scripts/header_package.sh "$packages" CLI11 CLI11::CLI11 libcli11-dev CLI
scripts/header_package.sh "$packages" nlohmann_json nlohmann_json::nlohmann_json nlohmann-json3-dev nlohmann
scripts/header_package.sh "$packages" fmt fmt::fmt libfmt-dev fmt FMT_HEADER_ONLY
scripts/header_package.sh "$packages" Eigen3 Eigen3::Eigen libeigen3-dev eigen3/Eigen
by_cmake meshoptimizer meshoptimizer
for each in "${wanted[@]}"; do
  case $each in
    --tbb) by_cmake tbb onetbb -D TBB_TEST=OFF -D TBBMALLOC_BUILD=OFF -D TBB_STRICT=OFF -D TBB_ENABLE_IPO=OFF \
      -D TBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON ;;
    --zlib) zlib ;;
    --googletest) by_cmake googletest /usr/src/googletest -D BUILD_GMOCK=OFF ;;
  esac
done
touch "$packages/complete"
