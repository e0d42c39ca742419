# Builds the project, and compares what it prints with what `expected` prints, a program of the usual build. The project has
# no oneTBB.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} -S ${root}/tests/consumer/from_source -B ${work} -G ${generator}
  -D program=${root}/tests/consumer/fast_math/main.cpp -D TAMIS_TBB=OFF
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher}
  -D CMAKE_BUILD_TYPE=Debug "-D CMAKE_CXX_FLAGS=-Ofast -ffast-math -fno-signed-zeros" -D CMAKE_CXX_FLAGS_DEBUG=-O1
  -D TAMIS_OPTIMIZE_KERNELS=OFF -D TAMIS_TBB=OFF)
run(${CMAKE_COMMAND} --build ${work})
run(${work}/simulator OUTPUT_FILE ${work}/found.txt)
run(${expected} OUTPUT_FILE ${work}/expected.txt)
run(${CMAKE_COMMAND} -E compare_files ${work}/found.txt ${work}/expected.txt)
