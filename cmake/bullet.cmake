# Bullet of Debian's libbullet-dev, in floats: its package file for CMake names folders relative to a prefix that it does
# not know. Defines tamis_bullet_dynamics (rigid bodies) where it is found.
find_path(BULLET_INCLUDE btBulletDynamicsCommon.h PATH_SUFFIXES bullet)
find_library(BULLET_DYNAMICS BulletDynamics)
find_library(BULLET_COLLISION BulletCollision)
find_library(BULLET_MATH LinearMath)
if(BULLET_INCLUDE AND BULLET_DYNAMICS AND BULLET_COLLISION AND BULLET_MATH AND NOT TARGET tamis_bullet_dynamics)
  add_library(tamis_bullet_dynamics INTERFACE)
  target_include_directories(tamis_bullet_dynamics SYSTEM INTERFACE ${BULLET_INCLUDE})
  target_link_libraries(tamis_bullet_dynamics INTERFACE ${BULLET_DYNAMICS} ${BULLET_COLLISION} ${BULLET_MATH})
endif()
