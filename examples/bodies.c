#include <stdio.h>
#include <tamis/tamis.h>

int main(void) {
  /* a floor that stays, and a blade above it that turns about y by a quarter: its tip goes down */
  const int32_t face[] = {0, 1, 2};
  const double floor_points[] = {-5, -5, 0, 5, -5, 0, 0, 5, 0}, blade_points[] = {0, 0, 0, 2, 0, 0, 1, 0.5, 0};
  const tamis_rigid_link turn = {{{0, 0, 1}, {0, 0, 0}}, {{0, 0, 1}, {0, 1.5707963267948966, 0}}};
  const tamis_mesh_input input = {.size = sizeof input, .vertex_count = 3, .faces = face, .face_count = 1};
  const tamis_motions stays = {.size = sizeof stays, .count = 1};
  const tamis_motions turns = {.size = sizeof turns, .count = 1, .links = &turn, .links_of_each = 1};
  tamis_mesh* mesh;
  tamis_shape *floor, *blade;
  tamis_world* world;
  tamis_contact contact;
  int32_t bodies[2];
  double lower, upper;
  size_t count = 0;

  tamis_mesh_create(&input, &mesh);
  tamis_shape_create(mesh, floor_points, NULL, &floor);
  tamis_shape_create(mesh, blade_points, NULL, &blade);
  tamis_world_create(NULL, &world);
  tamis_world_add(world, floor, &stays, &bodies[0]);
  tamis_world_add(world, blade, &turns, &bodies[1]);
  if (tamis_world_earliest(world, NULL, &lower, &upper, &count) != TAMIS_OK) puts(tamis_world_message(world));
  if (count > 0) {
    tamis_world_copy_contacts(world, 0, 1, &contact, sizeof contact);
    printf("free before %.6f: then vertex %d of body %d meets body %d\n", lower, contact.vertices[0], contact.bodies[0],
           contact.bodies[1]);
  }
  tamis_world_free(world);
  tamis_shape_free(floor);
  tamis_shape_free(blade);
  tamis_mesh_free(mesh);
  return 0;
}
