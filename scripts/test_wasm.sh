#!/usr/bin/env bash
# WebAssembly: builds the library, its C interface, the module for JavaScript and their tests by emscripten, and runs the tests
# under Node. Then compares every contact of the generated scenes and of the recorded frames with this machine's.
# --quick: the module, its test and the comparison alone. Exits with 77 where emscripten cannot be had, as on Debian 12:
# `scripts/try_in_root.sh --data trixie scripts/test_wasm.sh`.
set -euo pipefail
cd "$(dirname "$0")/.."

case $* in
  "") targets=(all) tests=() ;;
  --quick) targets=(tamis_wasm tamis_same_bits) tests=(-R '^wasm') ;;
  *) echo "test_wasm.sh: $*: say --quick or nothing" >&2; exit 2 ;;
esac
scripts/setup.sh --wasm || { echo "skipped: emscripten 3.1.50 or newer cannot be had"; exit 77; }

cmake --preset wasm
cmake --build --preset wasm --target "${targets[@]}"
ctest --preset wasm --parallel "$(nproc)" "${tests[@]}"
scripts/program_module.sh --check
for file in build/wasm/bindings/wasm/tamis.{js,wasm}; do
  echo "$(basename "$file"): $(wc -c <"$file") bytes, by gzip -9 $(gzip -9c "$file" | wc -c)"
done

cmake -S . -B build/beside_wasm -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_UNITY_BUILD=ON -D CMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -D TAMIS_TESTS=library -D TAMIS_BUILD_TOOLS=OFF -D TAMIS_BUILD_LAB=OFF
cmake --build build/beside_wasm --target tamis_same_bits
build/beside_wasm/tools/command/tests/same_bits/tamis_same_bits baseline >build/same_bits_here.txt
node build/wasm/tools/command/tests/same_bits/tamis_same_bits.js >build/same_bits_wasm.txt
diff build/same_bits_here.txt build/same_bits_wasm.txt
cat build/same_bits_here.txt
echo "the same on both: every bit of every contact"
