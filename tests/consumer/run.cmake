# Builds and installs the library, then configures, builds and runs the consumer against the installed files alone.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(shared OFF)
if(linkage STREQUAL "shared")
  set(shared ON)
endif()
set(compile -G ${generator} -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${compiler}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher})
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)

file(REMOVE_RECURSE ${work}/prefix ${work}/consumer)
run(${CMAKE_COMMAND} -S ${root} -B ${work}/library ${compile} -D BUILD_SHARED_LIBS=${shared}
  -D TAMIS_BUILD_TOOLS=OFF -D TAMIS_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${work}/library --parallel ${cores})
run(${CMAKE_COMMAND} --install ${work}/library --prefix ${work}/prefix)

run(${CMAKE_COMMAND} -S ${root}/tests/consumer/project -B ${work}/consumer ${compile}
  -D CMAKE_PREFIX_PATH=${work}/prefix -D readme=${root}/README.md)
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/consumer --output-on-failure --no-tests=error)
