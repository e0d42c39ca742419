# Where the includes of everything outside the library begin.
set(TAMIS_INCLUDES ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tools ${PROJECT_SOURCE_DIR}/bindings)

# Settings that all targets of the project share.
function(tamis_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  get_property(has_shared GLOBAL PROPERTY TARGET_SUPPORTS_SHARED_LIBS)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ${has_shared} CXX_SCAN_FOR_MODULES OFF)
  # No contraction: a product and a sum must round twice, or the error bounds do not hold.
  # A parent project's options stand before a target's: these take -ffast-math and -Ofast back. The sources refuse what is left.
  target_compile_options(${target} PRIVATE -fno-fast-math -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # Templates serve doubles and lanes, so they join conditions with & and | for bool, too.
    target_compile_options(${target} PRIVATE -Wno-bitwise-instead-of-logical)
  endif()
  if(TAMIS_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# Compiles with -O1, for targets that only read, write and call the library: that takes a quarter less time to compile, and no
# question of the shipped programs is slower. Debug builds stay as they are.
function(tamis_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()
