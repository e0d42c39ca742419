# In a folder that includes this, and those below it, C++ is only parsed, for its warnings: nothing is compiled to code,
# and what would be linked are empty files, so that who depends on it is satisfied. Headers that are read beforehand are
# compiled all the same: sources take them.
add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<STREQUAL:$<TARGET_PROPERTY:NAME>,tamis_test_headers>>>:-fsyntax-only>")
foreach(kind LINK_EXECUTABLE CREATE_STATIC_LIBRARY CREATE_SHARED_LIBRARY CREATE_SHARED_MODULE)
  set(CMAKE_CXX_${kind} "${CMAKE_COMMAND} -E touch <TARGET>")
endforeach()
