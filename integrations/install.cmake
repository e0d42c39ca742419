# find_package(tamis COMPONENTS bullet) then defines tamis::bullet, if the adapter was built.
set(TAMIS_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/tamis)
set_target_properties(tamis_bullet PROPERTIES EXPORT_NAME bullet)
install(TARGETS tamis_adapters tamis_bullet EXPORT tamis-bullet-targets OPTIONAL)
install(EXPORT tamis-bullet-targets NAMESPACE tamis:: DESTINATION ${TAMIS_PACKAGE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/cmake/bullet.cmake DESTINATION ${TAMIS_PACKAGE_DIR})
install(FILES bodies.hpp clamp.hpp near_contacts.hpp vectors.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tamis-integrations/integrations)
install(FILES bullet/clamped_world.hpp bullet/mesh_of_shape.hpp bullet/solver_contacts.hpp bullet/truncated_world.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tamis-integrations/integrations/bullet)
