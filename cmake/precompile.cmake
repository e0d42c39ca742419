# Headers that nearly every source includes are read once a target, not once a source: 0.9 to 2 seconds of each.
# Every source still includes what it uses; -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON must build, too, and the preset arm64 does.
set(tamis_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <numeric> <optional> <span> <sstream> <string> <string_view> <tuple> <vector>)

# tamis_precompile(target header...): these, and what all have in common.
function(tamis_precompile target)
  target_precompile_headers(${target} PRIVATE ${tamis_common_headers} ${ARGN})
endfunction()
