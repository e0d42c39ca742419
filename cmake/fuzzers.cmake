# Included before all targets: all functions that are compiled report their coverage, which guides the fuzzer.
if(TAMIS_BUILD_TESTS OR TAMIS_BUILD_TOOLS)
  message(FATAL_ERROR "The fuzz targets are built alone: use the preset fuzz, or switch tests and tools off")
endif()
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "The fuzz targets need clang++ (Debian: clang, libclang-rt-dev): use the preset fuzz")
endif()
add_compile_options(-fsanitize=fuzzer-no-link)
