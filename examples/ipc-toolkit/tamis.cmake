# Tamis: continuous collision detection that misses nothing. It needs Boost's headers and xsimd.
# License: MIT
if(TARGET tamis::tamis)
    return()
endif()

message(STATUS "Third-party: creating target 'tamis::tamis'")

include(CPM)
CPMAddPackage(NAME tamis URL "${TAMIS_ARCHIVE}" OPTIONS "TAMIS_TBB ON")

set_target_properties(tamis PROPERTIES FOLDER "ThirdParty")
