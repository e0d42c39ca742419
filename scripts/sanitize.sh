#!/usr/bin/env bash
# sanitize.sh address|thread [CTEST ARGUMENTS]: builds everything with a sanitizer and runs the tests, which try all
# instruction sets of this machine. Half an hour on two cores each.
#   address  preset asan: the address and undefined behaviour sanitizers
#   thread   preset tsan. Debian's oneTBB is not instrumented, so that its synchronization is not seen and looks like races.
#            So the same version is built from Debian's source with the sanitizer, in build/tsan-tbb.
set -euo pipefail
cd "$(dirname "$0")/.."

# Builds oneTBB with the thread sanitizer into build/tsan-tbb/installed. The system's packages stay as they are.
build_tbb() {
  local folder=$PWD/build/tsan-tbb
  [[ -e $folder/complete ]] && return
  rm -rf "$folder"
  scripts/debian_source.sh onetbb "$folder/source"
  cmake -S "$folder/source" -B "$folder/tbb" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_SANITIZE=thread \
    -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON
  cmake --build "$folder/tbb"
  cmake --install "$folder/tbb" --prefix "$folder/installed"
  touch "$folder/complete"
}

kind=${1:-}
shift || true
case $kind in
  address) preset=asan options=() ;;
  thread) preset=tsan options=("-DTBB_DIR=$PWD/build/tsan-tbb/installed/lib/cmake/TBB") ;;
  *) echo "sanitize.sh: say address or thread" >&2; exit 2 ;;
esac
scripts/setup.sh --all-tests
[[ $kind != thread ]] || build_tbb
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"
export UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS=suppressions=$PWD/scripts/tsan.supp
ctest --preset "$preset" --parallel "$(nproc)" "$@"
