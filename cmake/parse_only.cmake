# In folders that are added after this is included, C++ is only parsed, for its warnings. Objects, programs and libraries are
# empty files, for targets that depend on them. Precompiled headers are compiled nevertheless, as sources use them.
add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<STREQUAL:$<TARGET_PROPERTY:NAME>,tamis_test_headers>>>:-fsyntax-only>")
# Else a build that follows would parse all of them again.
list(APPEND CMAKE_CXX_COMPILE_OBJECT "${CMAKE_COMMAND} -E touch <OBJECT>")
foreach(kind LINK_EXECUTABLE CREATE_STATIC_LIBRARY CREATE_SHARED_LIBRARY CREATE_SHARED_MODULE)
  set(CMAKE_CXX_${kind} "${CMAKE_COMMAND} -E touch <TARGET>")
endforeach()
set(CMAKE_SKIP_RPATH ON)  # installing would change it, which an empty file does not have
