#!/usr/bin/env bash
# build_macos.sh: builds the library, without oneTBB, and the C interface for macOS on 64-bit ARM, by zig from PyPI, and checks the
# files: their kind, the libraries they load, the symbols they export. Nothing is run, as no Mac is here. Exit code 77 if zig
# cannot be had.
set -euo pipefail
cd "$(dirname "$0")/.."

python=$(scripts/pinned.sh python zig) || { echo "$python"; exit 77; }
scripts/setup.sh
build=$PWD/build/macos

# Wrappers, as CMake wants each tool to be one program.
mkdir -p "$build/zig"
for tool in cc c++ ar ranlib; do
  options="-target aarch64-macos.11.0"
  [[ $tool == c* ]] || options=
  printf '#!/bin/sh\nexec "%s" -m ziglang %s %s "$@"\n' "$python" "$tool" "$options" >"$build/zig/$tool"
  chmod +x "$build/zig/$tool"
done
packages=$build/packages
rm -rf "$packages"
scripts/header_package.sh "$packages" xsimd xsimd libxsimd-dev xsimd
ln -s /usr/include/boost "$packages/include/"  # cmake/FindBoostHeaders.cmake needs no more

cmake -G Ninja -B "$build" -DCMAKE_TOOLCHAIN_FILE=cmake/zig.cmake -DTAMIS_ZIG="$build/zig" -DTAMIS_ZIG_SYSTEM=Darwin \
  -DTAMIS_ZIG_PROCESSOR=arm64 -DTAMIS_ZIG_PACKAGES="$packages" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_VISIBILITY_PRESET=hidden \
  -DCMAKE_SHARED_LINKER_FLAGS=-s -DTAMIS_TBB=OFF -DTAMIS_BUILD_TOOLS=OFF -DTAMIS_BUILD_LAB=OFF -DTAMIS_BUILD_TESTS=OFF -DTAMIS_WARNINGS_AS_ERRORS=ON
cmake --build "$build"
"$build/zig/c++" -std=c++20 -Iinclude examples/hello.cpp "$build/src/libtamis.a" -o "$build/hello_cpp"
"$build/zig/cc" -Iinclude examples/hello.c -L"$build/bindings/c" -ltamis_c -o "$build/hello_c"
for file in "$build"/bindings/c/libtamis_c.*.*.*.dylib "$build"/hello_{c,cpp}; do python3 scripts/apple_local.py "$file"; done
"$python" scripts/check_macos.py "$build" include/tamis/c
