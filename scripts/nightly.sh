#!/usr/bin/env bash
# nightly.sh: all tests, and what takes too long for every day: each source compiled by itself, clang-tidy over everything, both sanitizers, the unit
# tests on 64-bit ARM, an hour of attacks and one of fuzzing. Some four hours on two cores; goes on after a failure,
# and names it at the end.
set -uo pipefail
cd "$(dirname "$0")/.."

export TAMIS_LONG=1       # the viewer's tests: a million contacts, a million triangles
export TAMIS_JOURNEYS=50  # kept detectors against new ones, through every scene
export TAMIS_NEWTON_FRAMES=650  # Newton's cloth examples with Tamis inside
export TAMIS_IPCTK_MESHES=1000  # random meshes through ipctk and its calls here
failed=()
run() { echo "nightly: $*"; "$@" || failed+=("$*"); }
run scripts/setup.sh --blender  # the add-on's tests run in it where it is
run scripts/test.sh
run python3 scripts/build_host.py build/dev/python blender
run env TAMIS_WHEEL="$(ls build/dev/python/dist/*.whl)" build/dev/python/blender/bin/python -m pytest python/tests/hosts/test_blender.py
run cmake --preset dev -B build/alone -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
run cmake --build build/alone
run scripts/check_tidy.sh build/dev/tidy --all
run scripts/sanitize.sh address
run scripts/sanitize.sh thread
run scripts/test_arm64.sh --all
run scripts/hostile.sh 3600
run scripts/fuzz.sh 600
((${#failed[@]} == 0)) && echo "nightly: all passed" && exit 0
printf 'nightly: failed: %s\n' "${failed[@]}" >&2
exit 1
