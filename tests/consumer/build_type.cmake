# Without a build type the project is built as Release. As a part of another project it only says what that costs, in the way
# that docs/cpp.md shows.
set(configure ${CMAKE_COMMAND} -G ${generator} -D CMAKE_CXX_COMPILER=${compiler} -D TAMIS_BUILD_LAB=OFF -D TAMIS_BUILD_TOOLS=OFF -D TAMIS_BUILD_TESTS=OFF
  -D TAMIS_BUILD_C=OFF -D TAMIS_BUILD_MPI=OFF)
file(REMOVE_RECURSE ${work})

function(expect_in text expected)
  string(FIND "${text}" "${expected}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "this does not say '${expected}':\n${text}")
  endif()
endfunction()

execute_process(COMMAND ${configure} -S ${root} -B ${work}/alone OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
expect_in("${said}" "no CMAKE_BUILD_TYPE is given: it is Release")
file(READ ${work}/alone/CMakeCache.txt cache)
expect_in("${cache}" "CMAKE_BUILD_TYPE:STRING=Release")

file(WRITE ${work}/other/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(other CXX)\ninclude(FetchContent)\nFetchContent_Declare(tamis SOURCE_DIR ${root})\n"
  "FetchContent_MakeAvailable(tamis)\nadd_library(simulator INTERFACE)\ntarget_link_libraries(simulator INTERFACE tamis::tamis)\n")
execute_process(COMMAND ${configure} -S ${work}/other -B ${work}/part ERROR_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
expect_in("${said}" "give -D CMAKE_BUILD_TYPE=Release")
file(READ ${work}/part/CMakeCache.txt cache)
expect_in("${cache}" "CMAKE_BUILD_TYPE:STRING=\n")

# Without oneTBB the library is built for the caller's threads, and says so; if oneTBB is demanded, the error says what to do.
execute_process(COMMAND ${configure} -D TAMIS_TBB=OFF -S ${root} -B ${work}/serial OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
expect_in("${said}" "tamis: without oneTBB")
execute_process(COMMAND ${configure} -D TAMIS_TBB=ON -D CMAKE_DISABLE_FIND_PACKAGE_TBB=ON -S ${root} -B ${work}/missing
  ERROR_VARIABLE said RESULT_VARIABLE result OUTPUT_QUIET)
expect_in("${said}" "TAMIS_TBB is ON, and oneTBB was not found: install it")
if(result EQUAL 0)
  message(FATAL_ERROR "TAMIS_TBB=ON is taken without oneTBB")
endif()
