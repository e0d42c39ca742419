# Compiles for Linux with glibc 2.28 or newer, with Debian's g++: scripts/release_wheel.py. TAMIS_PROCESSOR is x86_64 or aarch64,
# TAMIS_PACKAGES the folder of scripts/static_packages.sh, TAMIS_OLD_GLIBC that of scripts/old_glibc.py.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TAMIS_PROCESSOR TAMIS_PACKAGES TAMIS_OLD_GLIBC)
if(NOT TAMIS_PROCESSOR STREQUAL CMAKE_HOST_SYSTEM_PROCESSOR)
  set(CMAKE_SYSTEM_NAME Linux)
  set(CMAKE_SYSTEM_PROCESSOR ${TAMIS_PROCESSOR})
endif()
set(CMAKE_C_COMPILER ${TAMIS_PROCESSOR}-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER ${TAMIS_PROCESSOR}-linux-gnu-g++)
set(CMAKE_STRIP ${TAMIS_PROCESSOR}-linux-gnu-strip)
list(APPEND CMAKE_PREFIX_PATH ${TAMIS_PACKAGES})  # after the packages of the Python that builds
set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)
# Without local symbols (-s), which differ from folder to folder, a build identity is the same in each.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-B${TAMIS_OLD_GLIBC} -L${TAMIS_OLD_GLIBC} -Wl,--exclude-libs,ALL -s")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "${CMAKE_EXE_LINKER_FLAGS_INIT}")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "${CMAKE_EXE_LINKER_FLAGS_INIT}")
