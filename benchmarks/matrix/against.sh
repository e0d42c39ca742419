#!/usr/bin/env bash
# against.sh COMMIT [ARGUMENT...]: builds COMMIT and this checkout, and compares the two on the matrix; arguments go to
# compare.py. The builds stay in build/matrix, so that a commit is built once.
set -euo pipefail
cd "$(dirname "$0")/../.."
commit=$(git rev-parse --short "$1^{commit}")
shift

# build NAME CHECKOUT: the library of a checkout, and the driver of this one against it.
build() {
  local checkout=$2 folder=$PWD/build/matrix/$1
  cmake -S "$checkout" -B "$folder/tamis" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTAMIS_BUILD_TOOLS=OFF \
    -DTAMIS_BUILD_TESTS=OFF -DTAMIS_BUILD_MPI=OFF -DTAMIS_BUILD_C=OFF -Wno-dev >/dev/null
  ninja -C "$folder/tamis" tamis
  cmake -S benchmarks/matrix -B "$folder/driver" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DTAMIS_SOURCE="$checkout" -DTAMIS_LIBRARY="$folder/tamis/src/libtamis.a" >/dev/null
  ninja -C "$folder/driver"
}

old=$PWD/build/matrix/$commit/checkout
[[ -d $old ]] || git worktree add --quiet --detach "$old" "$commit"
build "$commit" "$old"
build here "$PWD"
exec benchmarks/matrix/compare.py build/matrix/{"$commit",here}/driver/bin/tamis_matrix "$@"
