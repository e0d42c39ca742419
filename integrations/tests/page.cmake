# Installs this build, and builds and runs the program of docs/hosts/bullet.md with the project that the page shows.
# Variables: page, library (a build folder), work, generator, compiler.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE printed)
  set(printed "${printed}" PARENT_SCOPE)
endfunction()

function(read_block language variable)
  file(READ ${page} text)
  if(NOT text MATCHES "```${language}\n([^`]*)```")
    message(FATAL_ERROR "${page} has no block of ${language}")
  endif()
  set(${variable} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${work})
read_block(cpp program)
read_block(cmake project)
read_block(text expected)
file(WRITE ${work}/source/thrown.cpp "${program}")
file(WRITE ${work}/source/CMakeLists.txt "${project}")
run(${CMAKE_COMMAND} --install ${library} --prefix ${work}/installed)
run(${CMAKE_COMMAND} -S ${work}/source -B ${work}/build -G ${generator} -D CMAKE_CXX_COMPILER=${compiler}
    -D CMAKE_PREFIX_PATH=${work}/installed -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/thrown)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the program prints\n${printed}and the page says\n${expected}")
endif()
