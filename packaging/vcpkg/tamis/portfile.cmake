# An overlay port: it builds the clone that it lies in. A registry's port would take an archive instead (vcpkg_from_github).
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

if(VCPKG_TARGET_IS_WINDOWS)
  vcpkg_check_linkage(ONLY_STATIC_LIBRARY)  # C++ exports nothing there
endif()
vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES
  c TAMIS_BUILD_C
  tbb TAMIS_TBB
)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${features}
    -DTAMIS_BUILD_TOOLS=OFF
    -DTAMIS_BUILD_LAB=OFF
    -DTAMIS_BUILD_MPI=OFF
    -DTAMIS_BUILD_TESTS=OFF
    -DTAMIS_INSTALL=ON
)
vcpkg_cmake_install()
vcpkg_copy_pdbs()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/tamis)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share" "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
