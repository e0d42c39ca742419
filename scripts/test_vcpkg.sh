#!/usr/bin/env bash
# test_vcpkg.sh [static|shared [Release|Debug]]: what reviewers of vcpkg's ports try, without vcpkg: the library with the options of
# packaging/vcpkg, static and shared, Debug and Release, each used by find_package, by pkg-config and by the compiler's flags alone.
# All optional packages are switched off, then each alone (configured, not built), and CMake may download nothing. Files that vcpkg's own
# functions move stay where they are.
set -euo pipefail
cd "$(dirname "$0")/.."

port=packaging/vcpkg/tamis
mapfile -t options < <(sed -n '/^  OPTIONS/,/^)/p' $port/portfile.cmake | grep -oE -- '-D[A-Z_]+=[A-Z]+')
((${#options[@]} > 3)) || { echo "test_vcpkg.sh: $port/portfile.cmake has no OPTIONS" >&2; exit 1; }
optional=(TBB MPI fmt Eigen3 CLI11 nlohmann_json ZLIB meshoptimizer GTest benchmark)
all_off=("${optional[@]/#/-DCMAKE_DISABLE_FIND_PACKAGE_}")
all_off=("${all_off[@]/%/=ON}")
cxx=${CXX:-c++}

uses() {  # uses HOW PROGRAM: runs it, and compares
  cmake -D example="$2" -D expected=examples/output/hello.cpp.txt -P examples/compare.cmake
  echo "test_vcpkg: $linkage $build: $1 works"
}

try() {
  linkage=$1 build=$2
  local work=$PWD/build/vcpkg/$1-$2 shared=OFF
  local prefix=$work/prefix
  [[ $1 != shared ]] || shared=ON
  rm -rf "$prefix" "$work/consumer"
  cmake -S . -B "$work/build" -G Ninja "${options[@]}" "${all_off[@]}" -D TAMIS_TBB=OFF -D TAMIS_BUILD_C=$shared -D BUILD_SHARED_LIBS=$shared \
    -D CMAKE_BUILD_TYPE="$2" -D FETCHCONTENT_FULLY_DISCONNECTED=ON -D CMAKE_INSTALL_PREFIX="$prefix" -D CMAKE_INSTALL_LIBDIR=lib \
    -D CMAKE_UNITY_BUILD_BATCH_SIZE=0 >"$work.txt" 2>&1 || { cat "$work.txt"; return 1; }
  cmake --build "$work/build"
  cmake --install "$work/build" >/dev/null
  local found
  if [[ $1 == static ]]; then found=$(find "$prefix" -name '*.so*' -o -name '*.dll'); else found=$(find "$prefix" -name '*.a'); fi
  [[ -z $found ]] || { echo "test_vcpkg.sh: $1 installs $found" >&2; return 1; }

  export LD_LIBRARY_PATH=$prefix/lib PKG_CONFIG_PATH=$prefix/lib/pkgconfig
  cmake -S packaging/vcpkg/consumer -B "$work/consumer" -G Ninja -D CMAKE_BUILD_TYPE="$2" -D CMAKE_PREFIX_PATH="$prefix" >/dev/null
  cmake --build "$work/consumer" >/dev/null
  uses find_package "$work/consumer/hello"
  local static=
  [[ $1 == shared ]] || static=--static
  $cxx -std=c++20 examples/hello.cpp -o "$work/by_pkg_config" $(pkg-config $static --cflags --libs tamis)
  uses pkg-config "$work/by_pkg_config"
  $cxx -std=c++20 examples/hello.cpp -I "$prefix/include" -L "$prefix/lib" -ltamis -pthread -o "$work/by_flags"
  uses "the compiler's flags alone" "$work/by_flags"
  unset LD_LIBRARY_PATH PKG_CONFIG_PATH
}

# Without one package the library builds what it builds without all.
one_by_one() {
  local work=$PWD/build/vcpkg/one_by_one
  for package in "${optional[@]}"; do
    rm -f "$work/CMakeCache.txt"
    cmake -S . -B "$work" -G Ninja "${options[@]}" -D TAMIS_TBB=AUTO -D CMAKE_BUILD_TYPE=Release -D FETCHCONTENT_FULLY_DISCONNECTED=ON \
      -D "CMAKE_DISABLE_FIND_PACKAGE_$package=ON" >"$work.txt" 2>&1 || { cat "$work.txt"; return 1; }
    echo "test_vcpkg: configured without $package"
  done
}

mkdir -p build/vcpkg
(($#)) || one_by_one
for linkage in ${1:-static shared}; do
  for build in ${2:-Release Debug}; do try "$linkage" "$build"; done
done
