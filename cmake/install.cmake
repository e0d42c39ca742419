# The rules of `cmake --install`; `find_package(tamis)` then defines tamis::tamis.
include(CMakePackageConfigHelpers)

# The rules have components, for packages: `library`, for programs to run; `command`; `licence`; the others are `development`.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(TAMIS_RUNS LIBRARY COMPONENT library NAMELINK_COMPONENT development RUNTIME COMPONENT library)
set(TAMIS_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/tamis)
set_target_properties(tamis PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
install(TARGETS tamis EXPORT tamis-targets ${TAMIS_RUNS})
install(DIRECTORY include/tamis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp PATTERN c EXCLUDE)
# The libraries find each other in any folder.
set(here "$ORIGIN")
if(APPLE)
  set(here "@loader_path")
endif()
foreach(library tamis_c tamis_mpi)
  if(TARGET ${library})
    set_target_properties(${library} PROPERTIES INSTALL_RPATH "${here}")
  endif()
endforeach()
if(TAMIS_BUILD_C)
  install(TARGETS tamis_c EXPORT tamis-targets ${TAMIS_RUNS})
  install(DIRECTORY include/tamis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
endif()
if(TAMIS_BUILD_MPI)
  install(TARGETS tamis_mpi EXPORT tamis-mpi-targets)
  install(DIRECTORY distributed/include/tamis DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT tamis-mpi-targets NAMESPACE tamis:: DESTINATION ${TAMIS_PACKAGE_DIR})
endif()
install(EXPORT tamis-targets NAMESPACE tamis:: DESTINATION ${TAMIS_PACKAGE_DIR})

# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tamis-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_package_config_file(cmake/tamis-config.cmake.in ${PROJECT_BINARY_DIR}/tamis-config.cmake
  INSTALL_DESTINATION ${TAMIS_PACKAGE_DIR})
install(FILES ${PROJECT_BINARY_DIR}/tamis-config.cmake ${PROJECT_BINARY_DIR}/tamis-config-version.cmake
  DESTINATION ${TAMIS_PACKAGE_DIR})
include(cmake/pkg_config.cmake)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
