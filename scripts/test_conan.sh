#!/usr/bin/env bash
# test_conan.sh [OPTION=VALUE...]: runs the whole recipe of packaging/conan and its test_package, without any remote: the static and
# the shared library, and one with oneTBB. Boost, xsimd and oneTBB are this system's. Options, as shared=True, try that variant alone.
# Needs PyPI once; exits with 77 if it cannot be reached.
set -euo pipefail
cd "$(dirname "$0")/.."

conan=$(scripts/pinned.sh conan conan) || { echo "$conan"; exit 77; }
work=$PWD/build/conan
mkdir -p "$work"
export CONAN_HOME=$work/home
"$conan" profile detect --force >/dev/null 2>&1
cat >"$work/profile" <<'END'
include(default)
[settings]
compiler.cppstd=20
build_type=Release
[platform_requires]
boost/1.83.0
xsimd/13.0.0
END
# The library is linked with oneTBB, so a package must say how: this one names the system's.
mkdir -p "$work/onetbb"
cat >"$work/onetbb/conanfile.py" <<'END'
from conan import ConanFile


class OneTbb(ConanFile):
    name = "onetbb"
    version = "2021.12.0"

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "TBB")
        library = self.cpp_info.components["libtbb"]
        library.set_property("cmake_target_name", "TBB::tbb")
        library.system_libs, library.includedirs = ["tbb"], []
END
variants=("shared=False" "shared=True" "shared=False with_tbb=True")
(($# == 0)) || variants=("$*")
"$conan" create "$work/onetbb" --no-remote >"$work/onetbb.txt" 2>&1 || { tail -n 20 "$work/onetbb.txt"; exit 1; }
for variant in "${variants[@]}"; do
  echo "test_conan: $variant"
  options=()
  for option in $variant; do options+=(-o "&:$option"); done
  "$conan" create packaging/conan --no-remote --profile:all "$work/profile" "${options[@]}" >"$work/log.txt" 2>&1 ||
    { tail -n 40 "$work/log.txt"; exit 1; }
  (($(grep -c 'vertex 3 meets' "$work/log.txt") == 2)) ||
    { tail -n 40 "$work/log.txt"; echo "test_conan: the two examples did not print their contact" >&2; exit 1; }
done
echo "test_conan: ${#variants[@]} packages were made, and both examples run with each"
