#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a wall that stands, a blade that turns and goes to it, and a sheet between them that is drawn away
  const tamis::Mesh square(4, {{0, 1, 2}, {0, 2, 3}});
  const std::vector<tamis::Point> corners{{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}};
  const tamis::Shape wall(square, corners), blade(tamis::Mesh(3, {{0, 1, 2}}), {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0.2}});
  std::vector<tamis::Point> sheet = corners, next = corners;
  for (tamis::Point& p : sheet) p[0] -= 0.9;

  tamis::World world;
  world.add(wall, tamis::Static{});
  tamis::Pose now{{-3, 0, 0}, {}};
  const tamis::BodyId turning = world.add(blade, tamis::Static{now});
  const tamis::BodyId soft = world.add({square, corners}, tamis::Deforming{sheet, sheet});
  for (int step = 1; step <= 3; ++step) {
    tamis::Pose wanted = now;
    wanted.position[0] += 0.7;
    wanted.rotation[2] += 0.25;
    for (std::size_t v = 0; v < sheet.size(); ++v) next[v] = {sheet[v][0] + 0.2, sheet[v][1], sheet[v][2]};
    const tamis::RigidChain way = tamis::interpolated_chain(now, wanted);
    world.move(turning, tamis::Rigid{way});  // each step, each body that moves
    world.move(soft, tamis::Deforming{sheet, next});
    for (const tamis::BodyContact& c : world.contacts())
      std::printf("step %d: bodies %d and %d would touch at t = %.4f\n", step, c.bodies[0], c.bodies[1], c.toi_lower);
    const double part = world.safe_step(0.1).toi_lower;  // so far may all go: every pair keeps a tenth of its distance
    std::printf("step %d goes %.4f of its way\n", step, part);
    now = tamis::pose_at(way, part);
    for (std::size_t v = 0; v < sheet.size(); ++v) sheet[v][0] += part * 0.2;
  }
}
