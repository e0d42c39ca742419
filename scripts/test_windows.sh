#!/usr/bin/env bash
# test_windows.sh [--all | --dll] [--here BUILD]: the same bits on 64-bit Windows. Cross-compiles Tamis by MinGW-w64, runs it under
# Wine, and compares every contact of the generated scenes and of the recorded frames with this machine's. Checks that the
# kernels need no aligned stack, that the C interface's DLL stands alone, and that no program takes a DLL of another version.
#   --all         also builds the command, and runs the core tests there
#   --dll         builds and checks the C interface's DLL alone
#   --here BUILD  a folder with a build for this machine; otherwise the preset dev is built
# The libraries are gathered in build/windows-packages. Exits with 77 where the packages cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

targets=(tamis_same_bits tamis_c c_test)
here=
while (($# > 0)); do
  case $1 in
    --all) targets=(all) ;;
    --dll) targets=(tamis_c c_test) ;;
    --here) here=${2:?--here needs a build folder}; shift ;;
    *) echo "test_windows.sh: no option is called $1: use --all, --dll or --here BUILD" >&2; exit 2 ;;
  esac
  shift
done
packages=$PWD/build/windows-packages
export WINEDEBUG=-all WINEPREFIX=$packages/wine

fail() { echo "test_windows.sh: $*" >&2; exit 1; }

# The kernels: g++ does not align the stack for wide registers on Windows (src/search/kernels/CMakeLists.txt).
check_moves() {
  local wide moves
  wide=$(find build/windows/src/search/kernels -name '*.obj' -exec x86_64-w64-mingw32-objdump -d --no-show-raw-insn {} + |
    grep -E '\svmov.*%[yz]mm') || fail "no kernel moves a wide register: were their objects found?"
  moves=$(grep -E '\svmov(ap[sd]|dqa[0-9]*)\s(.*[(].*%[yz]mm|.*%[yz]mm.*[(])' <<<"$wide" || true)
  [[ -z $moves ]] || fail "moves that need an aligned stack: $(head -3 <<<"$moves")"
}

check_dll() {
  local bin=build/windows/bin other needs
  needs=$(objdump -p "$bin/$dll" | sed -n 's/.*DLL Name: //p')
  [[ -n $needs ]] || fail "$dll needs no DLL: was it read?"
  needs=$(grep -viE '^(kernel32|msvcrt|advapi32)\.dll$' <<<"$needs" || true)
  [[ -z $needs ]] || fail "$dll needs $needs"
  python3 scripts/check_c_symbols.py "$bin/$dll" include/tamis/c
  wine "$bin/c_test.exe" || fail "c_test.exe ends with $?"
  other=$(mktemp -d)
  cp "$bin/c_test.exe" "$other" && cp "$bin/$dll" "$other/libtamis_c-9.9.dll"
  if WINEDEBUG= wine "$other/c_test.exe" 2>"$other/says"; then fail "a DLL of another version is taken"; fi
  grep -q "$dll.*not found" "$other/says" || fail "a missing DLL is not named: $(cat "$other/says")"
  rm -rf "$other"
}

scripts/setup.sh --windows || { echo "skipped: Debian's compiler for Windows, or Wine, cannot be had"; exit 77; }
scripts/static_packages.sh "$packages" --googletest --toolchain "$PWD/cmake/windows.cmake" -D TAMIS_WINDOWS_PACKAGES="$packages"
[[ -e $WINEPREFIX ]] || wine wineboot --init
cmake --preset windows -D TAMIS_WINDOWS_PACKAGES="$packages"
cmake --build --preset windows --target "${targets[@]}"
dll=libtamis_c-0.1.dll
check_moves
check_dll
[[ ${targets[*]} != "tamis_c c_test" ]] || exit 0

if [[ -z $here ]]; then
  here=build/dev
  cmake --preset dev
  cmake --build "$here" --target tamis_same_bits cli_test
fi
same_bits=tools/command/tests/same_bits/tamis_same_bits
"$here/$same_bits" >build/same_bits_here.txt
wine build/windows/$same_bits.exe | tr -d '\r' >build/same_bits_windows.txt
diff build/same_bits_here.txt build/same_bits_windows.txt
cat build/same_bits_here.txt
echo "the same on both: every bit of every contact"
[[ ${targets[*]} == all ]] || exit 0

ctest --preset windows --parallel "$(nproc)"
# The tests of the command run here, as they call a shell, and call the Windows program.
printf '#!/bin/sh\nexec wine %s "$@"\n' "$PWD/build/windows/bin/tamis.exe" >"$packages/tamis"
chmod +x "$packages/tamis"
# Not these: the first three expect / in names that Windows writes with its own separator; others need names, descriptors or
# limits that Windows or Wine does not have.
no=Verbs.SequenceTakesFramesInNaturalOrder:Verbs.SequenceAndFreeAnswerByTheirExitCode:Verbs.AStepThatIsRefusedIsNamed:Names.*
no+=:Outputs.NeverReplaceTheAnswer:Outputs.GoIntoPipes:Outputs.DoNotMixWithAnAnswerThatMustStandAlone:BadInput.TooLittleMemoryNamesTheFile
TAMIS_COMMAND=$packages/tamis "$here"/tools/command/tests/cli_test --gtest_brief=1 --gtest_filter="-$no"
