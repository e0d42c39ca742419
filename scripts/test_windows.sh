#!/usr/bin/env bash
# The same bits on 64-bit Windows: cross-compiles Tamis by MinGW-w64, runs it under Wine, and compares every contact of the
# generated scenes and of the recorded frames with this machine's. Checks that the C interface's DLL stands alone, and that
# a program refuses one of another version. With --all it also builds the command, and runs the core tests there.
# The libraries are gathered in build/windows-packages. Exits with 77 where the packages cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

case $* in
  "") targets=(tamis_same_bits tamis_c c_test) ;;
  --all) targets=(all) ;;
  *) echo "test_windows.sh: $*: say --all or nothing" >&2; exit 2 ;;
esac
packages=$PWD/build/windows-packages
export WINEDEBUG=-all WINEPREFIX=$packages/wine

# header_only PACKAGE TARGET DEBIAN_PACKAGE FOLDER [DEFINITION]: the host's header-only library, away from the host's C
# library, with files for CMake.
header_only() {
  local cmake=$packages/lib/cmake/$1
  mkdir -p "$cmake" "$packages/include"
  ln -s "/usr/include/$4" "$packages/include/"
  cat >"$cmake/$1Config.cmake" <<END
add_library($2 INTERFACE IMPORTED)
set_target_properties($2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES $packages/include INTERFACE_COMPILE_DEFINITIONS "${5:-}")
END
  cat >"$cmake/$1ConfigVersion.cmake" <<END
set(PACKAGE_VERSION $(dpkg-query -W -f='${source:Upstream-Version}' "$3"))
set(PACKAGE_VERSION_COMPATIBLE TRUE)
END
}

gather() {
  rm -rf "$packages"
  header_only xsimd xsimd libxsimd-dev xsimd
  header_only Boost Boost::headers libboost-dev boost
  header_only CLI11 CLI11::CLI11 libcli11-dev CLI
  header_only nlohmann_json nlohmann_json::nlohmann_json nlohmann-json3-dev nlohmann
  header_only fmt fmt::fmt libfmt-dev fmt FMT_HEADER_ONLY
  cmake -S /usr/src/googletest -B "$packages/googletest" -G Ninja --toolchain "$PWD/cmake/windows.cmake" \
    -D TAMIS_WINDOWS_PACKAGES="$packages" -D CMAKE_BUILD_TYPE=Release -D BUILD_GMOCK=OFF
  cmake --build "$packages/googletest"
  cmake --install "$packages/googletest" --prefix "$packages"
  wine wineboot --init
  touch "$packages/complete"
}

scripts/setup.sh --windows || { echo "skipped: Debian's compiler for Windows, or Wine, cannot be had"; exit 77; }
[[ -e $packages/complete ]] || gather
cmake --preset windows -D TAMIS_WINDOWS_PACKAGES="$packages"
cmake --build --preset windows --target "${targets[@]}"
cmake --preset dev
cmake --build --preset dev --target tamis_same_bits

same_bits=tools/command/tests/same_bits/tamis_same_bits
build/dev/$same_bits >build/same_bits_here.txt
wine build/windows/$same_bits.exe | tr -d '\r' >build/same_bits_windows.txt
diff build/same_bits_here.txt build/same_bits_windows.txt
cat build/same_bits_here.txt
echo "the same on both: every bit of every contact"
