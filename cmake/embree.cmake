# Finds Embree, version 4 or 3. For the contender in benchmarks/.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()
