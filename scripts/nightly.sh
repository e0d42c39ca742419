#!/usr/bin/env bash
# nightly.sh: runs all tests, and checks that take too long for every day: each source compiled by itself, clang-tidy over
# all sources, the core tests without oneTBB, both commands of the README and four compilers on new roots of both Debians,
# packages, release and its wheel, the newest hosts, both sanitizers, the core tests on 64-bit ARM, Windows and in WebAssembly, a build for macOS, an hour of
# attacks and 50 minutes of fuzzing. Takes some seven hours on two cores. A failure ends nothing: all failures are named at the end.
set -uo pipefail
cd "$(dirname "$0")/.."

export TAMIS_LONG=1             # the viewer's tests: also a million contacts, and a million triangles
export TAMIS_JOURNEYS=50        # seeds for which kept detectors are compared with new ones, in every scene
export TAMIS_NEWTON_FRAMES=650  # frames of Newton's cloth examples with Tamis inside
export TAMIS_IPCTK_MESHES=1000  # random meshes for which tamis.compat.ipctk is compared with ipctk
failed=()
run() { echo "nightly: $*"; "$@" || failed+=("$*"); }
run scripts/setup.sh --blender  # the add-on's tests run in the program, too, if it is installed
run scripts/test.sh --all
run python3 scripts/build_host.py build/all/python blender
run env TAMIS_WHEEL="$(ls build/all/python/dist/*.whl)" TAMIS_BACKEND="$(ls build/all/python/wheels/nanobind_backend-*.whl)" build/all/python/blender/bin/python -m pytest bindings/python/tests/hosts/test_blender.py
for host in newton mujoco; do  # do the newest versions work as those that were tested?
  run python3 scripts/build_host.py build/all/python "$host" --newest
  run "build/all/python/$host-newest/bin/python" -m pytest bindings/python/tests/hosts/test_"$host"*.py
done
run cmake --preset dev -B build/alone -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
run cmake --build build/alone
run scripts/check_tidy.sh build/all/tidy --all
run cmake --preset serial
run cmake --build --preset serial
run ctest --preset serial
for release in trixie bookworm; do
  run scripts/try_in_root.sh "$release" sh -c 'scripts/demo.sh && scripts/test.sh'
  run scripts/try_in_root.sh "$release" scripts/test.sh --all
  run scripts/try_in_root.sh "$release" scripts/check_compilers.sh
  run scripts/try_in_root.sh "$release" scripts/build_from_source.sh
done
run scripts/setup.sh --packages
run scripts/test_conan.sh
run scripts/test_vcpkg.sh
run scripts/test_crate.sh
run scripts/test_npm.sh --bundler
[[ -z ${TAMIS_IPC_TOOLKIT:-} ]] || run examples/ipc-toolkit/try.sh "$TAMIS_IPC_TOOLKIT" "${TAMIS_IPC_DEPENDENCIES:-}"
version=$(sed -n 's/^project(tamis VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
run scripts/release.sh "$version" build/release/nightly
run scripts/python_versions.sh build/release/nightly/*manylinux*x86_64.whl python3
run scripts/test_arm64_wheel.sh build/release/nightly/*manylinux*aarch64.whl build/release/nightly/*manylinux*x86_64.whl
run scripts/test_windows_wheel.sh build/release/nightly/*win_amd64.whl "$(ls build/python-versions/*-"$(uname -m)"/bin/python | head -n 1)"
run scripts/refused_wheels.sh build/release/nightly/*manylinux*x86_64.whl
for release in trixie bookworm; do
  run env TAMIS_DATA="$PWD/build/release/nightly" scripts/try_in_root.sh --data "$release" scripts/try_release.sh ../shared/data
  run env TAMIS_DATA="$PWD/build/release/nightly" scripts/try_in_root.sh --data "$release" scripts/try_sdist.sh ../shared/data/tamis-"$version".tar.gz
done
run scripts/sanitize.sh address
run scripts/sanitize.sh thread
run scripts/test_arm64.sh --all
run scripts/test_windows.sh --all
run scripts/try_in_root.sh --data trixie scripts/test_wasm.sh
run scripts/build_macos.sh
run scripts/hostile.sh 3600
run scripts/fuzz.sh 600
((${#failed[@]} == 0)) && echo "nightly: all passed" && exit 0
printf 'nightly: failed: %s\n' "${failed[@]}" >&2
exit 1
