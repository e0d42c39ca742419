#!/usr/bin/env bash
# header_package.sh FOLDER PACKAGE TARGET DEBIAN_PACKAGE HEADERS [DEFINITION]: puts a header-only library of this machine into FOLDER,
# with files for CMake: HEADERS is its folder in /usr/include. Cross-compilers take it from there, as /usr/include also has this
# machine's C library.
set -euo pipefail

cmake=$1/lib/cmake/$2
mkdir -p "$cmake" "$1/include"
ln -sfn "/usr/include/$5" "$1/include/$(basename "$5")"
cat >"$cmake/$2Config.cmake" <<END
if(NOT TARGET $3)
  add_library($3 INTERFACE IMPORTED)
endif()
set_target_properties($3 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES $1/include INTERFACE_COMPILE_DEFINITIONS "${6:-}")
END
cat >"$cmake/$2ConfigVersion.cmake" <<END
set(PACKAGE_VERSION $(dpkg-query -W -f='${source:Upstream-Version}' "$4"))
set(PACKAGE_VERSION_COMPATIBLE TRUE)
END
