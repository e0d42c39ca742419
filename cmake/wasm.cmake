# Compiles for WebAssembly with emscripten, whose em++ is on the PATH. Node runs the programs.
find_program(TAMIS_EM_CONFIG em-config NO_CMAKE_FIND_ROOT_PATH)
if(NOT TAMIS_EM_CONFIG)
  message(FATAL_ERROR "tamis: emscripten is missing: install it (Debian 13: emscripten) and put its em++ and em-config on the PATH")
endif()
execute_process(COMMAND ${TAMIS_EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH OUTPUT_STRIP_TRAILING_WHITESPACE)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.50)
  message(FATAL_ERROR "tamis: emscripten in ${EMSCRIPTEN_ROOT_PATH} is version ${EMSCRIPTEN_VERSION}, whose C++ library has too little of C++20: "
    "take 3.1.50 or newer (Debian 13 has 3.1.69)")
endif()

# -msse2: emscripten turns the instructions of x86's baseline into WebAssembly's, one for one but for a few. So xsimd and the
# kernels take the branches that are tested on x86, and the minimum of a NaN and a number is the same.
set(tamis_wasm_flags "-msimd128 -msse2 -fwasm-exceptions")
set(CMAKE_C_FLAGS_INIT "${tamis_wasm_flags}")
set(CMAKE_CXX_FLAGS_INIT "${tamis_wasm_flags}")
# Memory that cannot grow: malloc returns null, and new throws.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sALLOW_MEMORY_GROWTH -sABORTING_MALLOC=0 -sSTACK_SIZE=1MB")
find_program(TAMIS_NODE NAMES node nodejs NO_CMAKE_FIND_ROOT_PATH)
set(CMAKE_CROSSCOMPILING_EMULATOR ${TAMIS_NODE})

# Header-only libraries are this machine's. Its /usr/include has its C library, too: so compilers see links to these alone.
set(TAMIS_WASM_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${TAMIS_WASM_HEADERS})
foreach(library boost fast_float fmt nlohmann xsimd xtl)
  if(EXISTS /usr/include/${library})
    file(CREATE_LINK /usr/include/${library} ${TAMIS_WASM_HEADERS}/${library} SYMBOLIC)
  endif()
endforeach()
string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${TAMIS_WASM_HEADERS}")
set(CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES /usr/include)  # CMake drops it from what packages want
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
set(Boost_INCLUDE_DIR ${TAMIS_WASM_HEADERS} CACHE PATH "Boost's headers")
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/wasm)
