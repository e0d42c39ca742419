# Cross-compiles with zig (PyPI's ziglang), which brings clang, a linker and each system's C library: scripts/build_macos.sh.
# TAMIS_ZIG is the folder of its wrappers, TAMIS_ZIG_SYSTEM and TAMIS_ZIG_PROCESSOR what it builds for, TAMIS_ZIG_PACKAGES the folder
# of the header-only packages. (The host's own folder of headers also has its C library.)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TAMIS_ZIG TAMIS_ZIG_SYSTEM TAMIS_ZIG_PROCESSOR TAMIS_ZIG_PACKAGES)
set(CMAKE_SYSTEM_NAME ${TAMIS_ZIG_SYSTEM})
set(CMAKE_SYSTEM_PROCESSOR ${TAMIS_ZIG_PROCESSOR})
set(CMAKE_C_COMPILER ${TAMIS_ZIG}/cc)
set(CMAKE_CXX_COMPILER ${TAMIS_ZIG}/c++)
set(CMAKE_AR ${TAMIS_ZIG}/ar CACHE FILEPATH "")
set(CMAKE_RANLIB ${TAMIS_ZIG}/ranlib CACHE FILEPATH "")
# Boost before 1.81 asks for a class that C++17 removed, and zig's C++ library does not have. That library's <cmath> has no NAN if
# <cfloat> comes before it (zig 0.17).
set(CMAKE_CXX_FLAGS_INIT "-DBOOST_NO_CXX98_FUNCTION_BASE -include cmath")
set(CMAKE_INSTALL_NAME_DIR @rpath)  # as on a Mac, whose version CMake does not find here
set(CMAKE_BUILD_WITH_INSTALL_NAME_DIR ON)
set(CMAKE_INSTALL_NAME_TOOL ${CMAKE_COMMAND} CACHE FILEPATH "")  # asked for; only an installation would run it
set(CMAKE_FIND_ROOT_PATH ${TAMIS_ZIG_PACKAGES})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
