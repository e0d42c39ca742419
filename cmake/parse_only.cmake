# In folders that include this, and those below, C++ is only parsed, for its warnings. Programs and libraries are empty files,
# for targets that depend on them. Precompiled headers are compiled nevertheless, as sources use them.
add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<STREQUAL:$<TARGET_PROPERTY:NAME>,tamis_test_headers>>>:-fsyntax-only>")
foreach(kind LINK_EXECUTABLE CREATE_STATIC_LIBRARY CREATE_SHARED_LIBRARY CREATE_SHARED_MODULE)
  set(CMAKE_CXX_${kind} "${CMAKE_COMMAND} -E touch <TARGET>")
endforeach()
