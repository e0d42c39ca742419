#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  const tamis::Shape wall({4, {{0, 1, 2}, {0, 2, 3}}}, {{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}});
  const tamis::Shape blade({3, {{0, 1, 2}}}, {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0.2}});
  tamis::World world;
  world.add(wall, tamis::Static{});
  for (int i = 0; i < 1000; ++i) {  // one mesh, a thousand bodies that turn
    const double y = 9.5 * i;
    world.add(blade, tamis::Rigid{tamis::interpolated_chain({{-2, y, 0}, {}}, {{-0.5, y, 0}, {0, 0, 0.5}})});
  }
  for (const tamis::BodyContact& c : world.contacts())
    std::printf("bodies %d and %d touch in [%.6f, %.6f]\n", c.bodies[0], c.bodies[1], c.toi_lower, c.toi_upper);
}
