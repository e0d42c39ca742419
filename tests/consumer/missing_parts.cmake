# What is missing or too old is named when the library is configured, with how to get it, and stops with exit code 1.
set(configure ${CMAKE_COMMAND} -G ${generator} -S ${root} -D CMAKE_BUILD_TYPE=Release -D TAMIS_BUILD_LAB=OFF -D TAMIS_BUILD_TOOLS=OFF
  -D TAMIS_BUILD_TESTS=OFF -D TAMIS_BUILD_C=OFF)
file(REMOVE_RECURSE ${work})

# expect(name sentence option...)
function(expect name sentence)
  execute_process(COMMAND ${configure} -B ${work}/${name} ${ARGN} OUTPUT_VARIABLE printed ERROR_VARIABLE said RESULT_VARIABLE code)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${sentence}" place)
  if(code EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "${name}: exit code ${code}, and this does not say '${sentence}':\n${said}")
  endif()
endfunction()

# A package that is found, of another version.
function(old_package package version)
  file(WRITE ${work}/old/${package}Config.cmake "")
  file(WRITE ${work}/old/${package}ConfigVersion.cmake "set(PACKAGE_VERSION ${version})\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
endfunction()

set(with_compiler -D CMAKE_CXX_COMPILER=${compiler})
expect(no_xsimd "tamis: xsimd 8.1 or newer is missing: install it (Debian: libxsimd-dev" ${with_compiler} -D CMAKE_DISABLE_FIND_PACKAGE_xsimd=ON)
old_package(xsimd 7.6.0)
expect(old_xsimd "tamis: xsimd in ${work}/old is version 7.6.0, but Tamis needs 8.1 or newer: install it" ${with_compiler} -D xsimd_DIR=${work}/old)
expect(no_boost "tamis: BoostHeaders 1.74 or newer is missing: install Boost's headers (Debian: libboost-dev" ${with_compiler} -D CMAKE_DISABLE_FIND_PACKAGE_BoostHeaders=ON)
file(WRITE ${work}/old/boost/version.hpp "#define BOOST_LIB_VERSION \"1_66\"\n")
expect(old_boost "tamis: BoostHeaders in ${work}/old is version 1.66, but Tamis needs 1.74 or newer: install" ${with_compiler} -D Boost_INCLUDE_DIR=${work}/old)
expect(no_tbb "oneTBB was not found: install it (Debian: libtbb-dev)" ${with_compiler} -D TAMIS_TBB=ON -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
expect(no_mpi "need MPI, which is missing: install it (Debian: libopenmpi-dev)" ${with_compiler} -D TAMIS_BUILD_MPI=ON -D CMAKE_DISABLE_FIND_PACKAGE_MPI=ON)

# A compiler that knows only C++17, whatever it is told.
file(WRITE ${work}/bin/c++17 "#!/bin/sh\nexec \"${compiler}\" \"$@\" -std=c++17\n")
file(CHMOD ${work}/bin/c++17 PERMISSIONS OWNER_READ OWNER_EXECUTE)
expect(no_ranges "has no C++20 with concepts and ranges: give -D CMAKE_CXX_COMPILER=COMPILER" -D CMAKE_CXX_COMPILER=${work}/bin/c++17)
