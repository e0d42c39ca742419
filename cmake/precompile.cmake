# Headers that nearly every source includes are read once a target, not once a source: 0.9 to 2 seconds of each. Where
# sources are joined that no longer pays: reading them once for later takes longer than once for eight sources.
# Every source still includes what it uses; most presets do without.
set(tamis_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <numeric> <optional> <span> <sstream> <string> <string_view> <tuple> <vector>)

# tamis_precompile(target header...): these, and what all have in common.
function(tamis_precompile target)
  if(CMAKE_UNITY_BUILD)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${tamis_common_headers} ${ARGN})
endfunction()
