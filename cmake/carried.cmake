# The packages that Python's source distribution carries in third_party (scripts/carry_packages.py), so that it needs no others but a
# compiler. find_package takes them, whatever the system has. The parts of zlib and meshoptimizer that Tamis calls are compiled.
set(third_party ${PROJECT_SOURCE_DIR}/third_party)
set(Boost_INCLUDE_DIR ${third_party} CACHE PATH "" FORCE)
set(xsimd_DIR ${third_party} CACHE PATH "" FORCE)
set(CMAKE_FIND_PACKAGE_PREFER_CONFIG ON)  # else CMake's own file for zlib finds the system's

# tamis_carried(package target library): find_package(package) finds the target, which is the library.
function(tamis_carried package target library)
  file(WRITE ${PROJECT_BINARY_DIR}/third_party/${package}Config.cmake "")
  set(${package}_DIR ${PROJECT_BINARY_DIR}/third_party CACHE PATH "" FORCE)
  add_library(${target} ALIAS ${library})
endfunction()

add_library(tamis_headers INTERFACE)
target_include_directories(tamis_headers SYSTEM INTERFACE ${third_party})
target_compile_definitions(tamis_headers INTERFACE FMT_HEADER_ONLY)
tamis_carried(CLI11 CLI11::CLI11 tamis_headers)
tamis_carried(Eigen3 Eigen3::Eigen tamis_headers)
tamis_carried(fmt fmt::fmt tamis_headers)
tamis_carried(nlohmann_json nlohmann_json::nlohmann_json tamis_headers)

enable_language(C)
foreach(name zlib meshoptimizer)
  file(GLOB sources ${third_party}/${name}/*.c ${third_party}/${name}/*.cpp)
  add_library(tamis_${name} STATIC ${sources})
  set_target_properties(tamis_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
  target_include_directories(tamis_${name} SYSTEM INTERFACE ${third_party}/${name})
endforeach()
target_compile_definitions(tamis_zlib PRIVATE fdopen=fdopen)  # zutil.h takes a new Mac for an old one, without this function
target_compile_options(tamis_zlib PRIVATE $<$<NOT:$<BOOL:${MSVC}>>:-w>)
tamis_carried(ZLIB ZLIB::ZLIB tamis_zlib)
tamis_carried(meshoptimizer meshoptimizer::meshoptimizer tamis_meshoptimizer)
