# Finds Embree, version 4 or 3. tools/files/picture/embree.hpp includes the header of the same version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()
