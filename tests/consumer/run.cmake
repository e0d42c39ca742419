# Installs the library, then configures, builds and runs the consumer against only the installed files.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(compile -G ${generator} -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${compiler}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher})
file(REMOVE_RECURSE ${work}/prefix ${work}/consumer)

if(library STREQUAL "${work}/library")
  set(shared OFF)
  if(linkage STREQUAL "shared")
    set(shared ON)
  endif()
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  # Not optimised: that compiles faster, and links in the same way.
  run(${CMAKE_COMMAND} -S ${root} -B ${library} ${compile} -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0
    -D BUILD_SHARED_LIBS=${shared}
    -D TAMIS_BUILD_LAB=OFF -D TAMIS_BUILD_TOOLS=OFF -D TAMIS_BUILD_TESTS=OFF)
  run(${CMAKE_COMMAND} --build ${library} --parallel ${cores})
endif()
run(${CMAKE_COMMAND} --install ${library} --prefix ${work}/prefix)

run(${CMAKE_COMMAND} -S ${root}/tests/consumer/project -B ${work}/consumer ${compile}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D compiled=${compiled} -D examples=${root}/examples)
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/consumer --output-on-failure --no-tests=error)

# The same by pkg-config and the compiler alone. Of a static library it names what that links, too.
find_program(pkg_config pkg-config REQUIRED)
file(GLOB_RECURSE pc_files ${work}/prefix/*/tamis.pc)
get_filename_component(folder "${pc_files}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${folder}:$ENV{PKG_CONFIG_PATH})
set(static)
if(linkage STREQUAL "static")
  set(static --static)
endif()
function(by_pkg_config package example)
  execute_process(COMMAND ${pkg_config} --cflags --libs ${ARGN} ${package} OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  execute_process(COMMAND ${pkg_config} --variable=libdir ${package} OUTPUT_VARIABLE libdir OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(program ${work}/${example}_by_pkg_config)
  run(${compiler} -Wl,-rpath,${libdir} -o ${program} ${root}/examples/${example} ${flags})
  run(${CMAKE_COMMAND} -D example=${program} -D expected=${root}/examples/output/${example}.txt -P ${root}/examples/compare.cmake)
endfunction()
set(compiler ${compiler} -std=c++20)
by_pkg_config(tamis hello.cpp ${static})
set(compiler cc)
by_pkg_config(tamis-c hello.c)
