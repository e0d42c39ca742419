# Where the includes of everything outside the library begin.
set(TAMIS_INCLUDES ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tools ${PROJECT_SOURCE_DIR}/bindings)

# What each compiler calls the same. MSVC: cl, which is untested, and clang-cl.
# No contraction: a product and a sum must round twice, or the error bounds do not hold. clang-cl ignores -ffp-contract unless
# /clang: stands before it; cl does not contract with /fp:precise (from Visual Studio 2022 on: platform.hpp).
# A parent project's options stand before a target's: these take -ffast-math, -Ofast and /fp:fast back. The sources refuse what
# is left.
if(NOT MSVC)
  set(TAMIS_ALWAYS -fno-fast-math -ffp-contract=off)
  set(TAMIS_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  set(TAMIS_OPTIMISES_LESS -O1)
  set(TAMIS_OPTIMISES_MOST -O3)
  set(TAMIS_AVX2 -mavx2)
  set(TAMIS_AVX512 -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx512vl -mprefer-vector-width=512)
else()
  set(TAMIS_ALWAYS /fp:precise /utf-8 /bigobj)
  set(TAMIS_OPTIMISES_LESS /O1)
  set(TAMIS_OPTIMISES_MOST $<$<NOT:$<CONFIG:Debug>>:/O2>)  # /O2 excludes the /RTC1 of Debug
  set(TAMIS_AVX2 /arch:AVX2)
  set(TAMIS_AVX512 /arch:AVX512)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    list(APPEND TAMIS_ALWAYS /clang:-fno-fast-math /clang:-ffp-contract=off)
    list(APPEND TAMIS_AVX512 /clang:-mprefer-vector-width=512)
    set(TAMIS_WARNINGS -Wextra -Wpedantic -Wshadow -Wconversion)  # its -Wall would be -Weverything
  else()
    list(APPEND TAMIS_ALWAYS /permissive- /Zc:preprocessor)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Templates serve doubles and lanes, so they join conditions with & and | for bool, too.
  list(APPEND TAMIS_WARNINGS -Wno-bitwise-instead-of-logical)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 18)
    # From 18 on clang warns of what the library of g++ 12 calls itself (llvm/llvm-project#76515). Other compilers check Tamis for it.
    list(APPEND TAMIS_WARNINGS -Wno-deprecated-declarations)
  endif()
endif()

# Settings that all targets of the project share. A parent project chooses its own warnings.
function(tamis_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  get_property(has_shared GLOBAL PROPERTY TARGET_SUPPORTS_SHARED_LIBS)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ${has_shared})
  target_compile_options(${target} PRIVATE ${TAMIS_ALWAYS})
  if(TAMIS_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE ${TAMIS_WARNINGS})
  endif()
  if(TAMIS_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<IF:$<BOOL:${MSVC}>,/WX,-Werror>)
  endif()
endfunction()

# If a hot loop's place in its cache line depends on the code linked before it, small questions cost up to 6% more.
function(tamis_align_functions target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<BOOL:${MSVC}>>:-falign-functions=64>)
endfunction()

# Compiles with -O1, for targets that only read, write and call the library: that takes a quarter less time to compile, and no
# question of the shipped programs is slower. Debug builds stay as they are.
function(tamis_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:${TAMIS_OPTIMISES_LESS}>)
endfunction()

# Of this shared library only the functions of the C headers are visible. On Windows TAMIS_API says it. Elsewhere the linker
# also hides symbols of static libraries and of C++'s headers, if it has an option for it.
include(CheckLinkerFlag)
function(tamis_export_c_functions target)
  set(map ${PROJECT_SOURCE_DIR}/bindings/c/exported.map)
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON LINK_DEPENDS ${map} DEFINE_SYMBOL tamis_c_EXPORTS)
  if(WIN32)
    return()
  endif()
  set(CMAKE_REQUIRED_QUIET ON)  # a linker has one of them: the other is not missing
  check_linker_flag(CXX "-Wl,--version-script=${map}" TAMIS_LINKER_READS_VERSIONS)
  check_linker_flag(CXX "-Wl,-exported_symbol,_tamis_*" TAMIS_LINKER_READS_NAMES)
  if(TAMIS_LINKER_READS_VERSIONS)
    target_link_options(${target} PRIVATE -Wl,--version-script=${map})
  elseif(TAMIS_LINKER_READS_NAMES)
    target_link_options(${target} PRIVATE -Wl,-exported_symbol,_tamis_*)
  endif()
endfunction()
