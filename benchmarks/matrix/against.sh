#!/usr/bin/env bash
# against.sh COMMIT [ARGUMENT...]: builds COMMIT and this checkout, and compares the two on the matrix; arguments go to
# compare.py. The builds stay in build/matrix, so that a commit is built once.
# against.sh --in SYSTEM [ARGUMENT...]: compares this checkout by g++ 12 with itself elsewhere, by the wall clock, so on a machine with
# nothing else to do. SYSTEM is another compiler (clang++-19), `windows` (under Wine, after scripts/test_windows.sh) or `wasm` (Node). Not run yet.
set -euo pipefail
cd "$(dirname "$0")/../.."
with_cmake=(-G Ninja -DCMAKE_BUILD_TYPE=Release -Wno-dev)

# build NAME CHECKOUT [OPTION...]: the library of a checkout, and the driver of this one against it.
build() {
  local checkout=$2 folder=$PWD/build/matrix/$1
  cmake -S "$checkout" -B "$folder/tamis" "${with_cmake[@]}" -DTAMIS_BUILD_TOOLS=OFF \
    -DTAMIS_BUILD_TESTS=OFF -DTAMIS_BUILD_MPI=OFF -DTAMIS_BUILD_C=OFF -DTAMIS_BUILD_LAB=OFF "${@:3}" >/dev/null
  ninja -C "$folder/tamis" tamis
  cmake -S benchmarks/matrix -B "$folder/driver" "${with_cmake[@]}" \
    -DTAMIS_SOURCE="$checkout" -DTAMIS_LIBRARY="$folder/tamis/src/libtamis.a" "${@:3}" >/dev/null
  ninja -C "$folder/driver"
}

# in_system NAME [RUNNER...]: a program that runs the driver of that build.
in_system() {
  local folder=build/matrix/$1/driver/bin file
  file=$(find "$folder" -name 'tamis_matrix' -o -name '*.exe' -o -name '*.js')
  printf '#!/bin/sh\nexec %s --wall "$@"\n' "${*:2} $PWD/$file" >"build/matrix/$1/run"
  chmod +x "build/matrix/$1/run"
}

if [[ $1 == --in ]]; then
  system=$2 options=() runner=()
  shift 2
  case $system in
    windows)
      packages=$PWD/build/windows-packages
      options=(--toolchain "$PWD/cmake/windows.cmake" -DTAMIS_WINDOWS_PACKAGES="$packages")
      runner=(env WINEDEBUG=-all WINEPREFIX="$packages/wine" wine)
      ;;
    wasm)
      options=(--toolchain "$PWD/cmake/wasm.cmake" "-DCMAKE_EXE_LINKER_FLAGS=-sNODERAWFS -sEXIT_RUNTIME -sALLOW_MEMORY_GROWTH -sSTACK_SIZE=8MB")
      runner=(node)
      ;;
    *) options=(-DCMAKE_CXX_COMPILER="$system") ;;
  esac
  build g++-12 "$PWD" -DCMAKE_CXX_COMPILER=g++-12
  build "$system" "$PWD" "${options[@]}"
  in_system g++-12
  in_system "$system" "${runner[@]}"
  exec benchmarks/matrix/compare.py build/matrix/{g++-12,"$system"}/run --recorded "$@"
fi

commit=$(git rev-parse --short "$1^{commit}")
shift
old=$PWD/build/matrix/$commit/checkout
[[ -d $old ]] || git worktree add --quiet --detach "$old" "$commit"
build "$commit" "$old"
build here "$PWD"
exec benchmarks/matrix/compare.py build/matrix/{"$commit",here}/driver/bin/tamis_matrix "$@"
