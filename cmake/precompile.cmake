# Precompiles the headers that nearly every source includes, which saves 0.9 to 2 seconds a source. It does not pay in unity
# builds: precompiling takes longer than reading the headers once for eight sources. Every source still includes what it
# uses; most presets build without this.
set(tamis_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <numeric> <optional> <span> <sstream> <string> <string_view> <tuple> <vector>)

# tamis_precompile(target header...): precompiles these headers, and those that all targets have in common.
function(tamis_precompile target)
  if(CMAKE_UNITY_BUILD)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${tamis_common_headers} ${ARGN})
endfunction()
