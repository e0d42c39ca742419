# tamis_requires(package version variable how): finds a package of at least this version. `variable` says where it is, `how` how to
# get it. Stops with one sentence if it is missing or too old. (find_package's own check refuses newer major versions of many.)
macro(tamis_requires package version variable how)
  find_package(${package} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "tamis: ${package} ${version} or newer is missing: ${how}, or give -D ${variable}=FOLDER")
  elseif(${package}_VERSION VERSION_LESS ${version})
    message(FATAL_ERROR "tamis: ${package} in ${${variable}} is version ${${package}_VERSION}, but Tamis needs ${version} or newer: "
      "${how}, or give -D ${variable}=FOLDER of a newer one")
  endif()
endmacro()

# The sources need C++20 with its standard library.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS ${CMAKE_CXX20_STANDARD_COMPILE_OPTION})
check_cxx_source_compiles("
#include <bit>
#include <concepts>
#include <algorithm>
#include <memory>
#include <ranges>
#include <span>
template <std::unsigned_integral T> bool all_odd(std::span<const T> s) {
  return std::ranges::all_of(s, [](T x) { return std::popcount(x & 1U) == 1; });
}
int main() {
  const auto values = std::make_unique_for_overwrite<unsigned[]>(2);
  return all_odd(std::span<const unsigned>(values.get(), 2));
}" TAMIS_HAS_CXX20)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT TAMIS_HAS_CXX20)
  message(FATAL_ERROR "tamis: ${CMAKE_CXX_COMPILER} (${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}) has no C++20 with concepts and ranges: "
    "give -D CMAKE_CXX_COMPILER=COMPILER, of g++ 12, clang 14 or newer, in a new build folder")
endif()
