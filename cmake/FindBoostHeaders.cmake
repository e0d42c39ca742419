# The headers of Boost (BSL-1.0): Boost::headers. Nothing of Boost is linked, so builds alone need them.
find_path(Boost_INCLUDE_DIR boost/multiprecision/cpp_int.hpp)
mark_as_advanced(Boost_INCLUDE_DIR)
if(Boost_INCLUDE_DIR)
  file(STRINGS ${Boost_INCLUDE_DIR}/boost/version.hpp boost_version REGEX "define BOOST_LIB_VERSION")
  string(REGEX REPLACE ".*\"([0-9]+)_([0-9]+).*" "\\1.\\2" BoostHeaders_VERSION "${boost_version}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(BoostHeaders REQUIRED_VARS Boost_INCLUDE_DIR VERSION_VAR BoostHeaders_VERSION)

if(BoostHeaders_FOUND AND NOT TARGET Boost::headers)
  add_library(Boost::headers INTERFACE IMPORTED)
  # Else Boost's exceptions name the folder of its headers, and the same sources give other bytes in another folder.
  set_target_properties(Boost::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${Boost_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS BOOST_DISABLE_CURRENT_LOCATION)
endif()
