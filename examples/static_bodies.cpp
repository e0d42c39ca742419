#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  const tamis::Shape wall({4, {{0, 1, 2}, {0, 2, 3}}}, {{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}});
  const tamis::Pose poses[] = {{}, {{0, 0, 0}, {0, 0, 1}}};  // two walls that pass through each other
  tamis::World world;
  for (const tamis::Pose& pose : poses) world.add(wall, tamis::Static{pose});
  std::printf("both static: %s\n", world.has_intersection() ? "intersections" : "nothing was looked at");
  std::printf("with static bodies: %s\n", world.has_intersection({.include_static = true}) ? "intersections" : "none");
}
