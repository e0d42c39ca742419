#!/usr/bin/env bash
# try.sh CHECKOUT [DEPENDENCIES]: builds ipc-toolkit in CHECKOUT as a whole, and Tamis by its recipe from an archive of HEAD, then runs
# `compare` on its own scene and on recorded steps (those of TAMIS_DATA). DEPENDENCIES: a folder with checkouts of what ipc-toolkit
# needs (dependencies.cmake); without it ipc-toolkit downloads them. TAMIS_JOBS: how many compile at a time. Exits with 77 where
# there is no checkout.
set -euo pipefail
checkout=${1:-../ipc-toolkit} dependencies=${2:-}
[[ -z $dependencies ]] || dependencies=$(realpath "$dependencies")
[[ -e $checkout/src/ipc/ipc.hpp ]] || {
  echo "skipped: no ipc-toolkit in '$checkout': git clone https://github.com/ipc-sim/ipc-toolkit, and name the folder"
  exit 77
}
checkout=$(realpath "$checkout")
cd "$(dirname "$0")/../.."

build=$PWD/build/ipc-toolkit
mkdir -p "$build"
archive=$build/tamis-$(git rev-parse --short HEAD).tar.gz  # CPM takes a file of one name for one archive
git archive --format=tar.gz --prefix=tamis/ --output="$archive" HEAD
frames=()
for pair in armadillo-rollers/32{6,7} cloth-funnel/22{7,8} kick/frame_6{2,3}; do
  file=$(realpath -m "${TAMIS_DATA:-../shared/data}/frames/$pair.ply")
  [[ ! -e $file ]] || frames+=("$file")
done
((${#frames[@]})) || echo "no recorded steps in ${TAMIS_DATA:-../shared/data}: its own scene alone is tried"
cmake -S examples/ipc-toolkit -B "$build" -D IPC_TOOLKIT="$checkout" -D IPC_DEPENDENCIES="$dependencies" \
  -D TAMIS_ARCHIVE="$archive" -D CPM_SOURCE_CACHE="$build/cpm" -D FRAMES="$(IFS=';' && echo "${frames[*]}")" >"$build/configured.txt"
cmake --build "$build" --target compare --parallel "${TAMIS_JOBS:-$(nproc)}" >"$build/built.txt" || {
  tail -30 "$build/built.txt" >&2
  exit 1
}
echo "try.sh: with ipc-toolkit $(git -C "$checkout" rev-parse --short HEAD 2>/dev/null || echo of an unknown commit)"
ctest --test-dir "$build" --output-on-failure --verbose | grep -E '^[0-9]+: |tests passed|FAILED'
