/* Worlds of bodies, from C99: what is answered, what is refused and changes nothing, and that all is freed. */
#include <math.h>
#include <stdlib.h>
#include <tamis/tamis.h>

#include "expect.h"

/* A plate at z = 0 and a blade: a triangle whose tip is two away from its origin. */
static const int32_t face[] = {0, 1, 2};
static const double plate_points[] = {-5, -5, 0, 5, -5, 0, 0, 5, 0}, blade_points[] = {0, 0, 0, 2, 0, 0, 1, 0.5, 0};
static const double quarter = 1.57079632679489662;

static tamis_shape* shape_of(const double* points) {
  tamis_mesh_input input = {sizeof input, 3, face, 1, NULL, 0, NULL, 0};
  tamis_mesh* mesh = NULL;
  tamis_shape* shape = NULL;
  EXPECT(tamis_mesh_create(&input, &mesh) == TAMIS_OK);
  EXPECT(tamis_shape_create(mesh, points, NULL, &shape) == TAMIS_OK);
  tamis_mesh_free(mesh); /* the shape has its own */
  return shape;
}

static tamis_motions motions(size_t count) {
  tamis_motions none;
  memset(&none, 0, sizeof none);
  none.size = sizeof none;
  none.count = count;
  return none;
}

static tamis_rigid_link turning(double x, double height, double angle) {
  const tamis_rigid_link link = {{{x, 0, height}, {0, 0, 0}}, {{x, 0, height}, {0, angle, 0}}};
  return link;
}

/* The plate is body 0, the blade body 1: it turns a quarter about y, and its tip goes down to the plate. */
static tamis_world* blade_over_plate(void) {
  tamis_shape *plate = shape_of(plate_points), *blade = shape_of(blade_points);
  tamis_world* world = NULL;
  tamis_motions motion = motions(1);
  const tamis_rigid_link turn = turning(0, 1, quarter);
  int32_t bodies[2] = {-1, -1};
  EXPECT(tamis_world_create(NULL, &world) == TAMIS_OK);
  EXPECT(tamis_world_add(world, plate, &motion, &bodies[0]) == TAMIS_OK);
  motion.links = &turn;
  motion.links_of_each = 1;
  EXPECT(tamis_world_add(world, blade, &motion, &bodies[1]) == TAMIS_OK);
  EXPECT(bodies[0] == 0 && bodies[1] == 1);
  tamis_shape_free(plate); /* bodies keep what they need */
  tamis_shape_free(blade);
  return world;
}

static void what_is_answered(void) {
  tamis_world* world = blade_over_plate();
  tamis_contact contacts[8];
  tamis_near_pair near[8];
  tamis_intersection crossing;
  tamis_statistics statistics;
  tamis_safe_step safe = {sizeof safe};
  tamis_path_options options = {sizeof options, 1e-3};
  const double far = 0.5;
  double lower = 0, upper = 0, first = 2;
  size_t count = 0, i;
  int is_free = -1;
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK && 0 < count && count <= 8);
  EXPECT(tamis_world_copy_contacts(world, 0, count, contacts, sizeof contacts[0]) == TAMIS_OK);
  for (i = 0; i < count && i < 8; ++i) {
    EXPECT(contacts[i].bodies[0] != contacts[i].bodies[1] && contacts[i].toi_upper - contacts[i].toi_lower <= 1e-9);
    first = fmin(first, contacts[i].toi_lower);
  }
  EXPECT(tamis_world_first_contacts(world, NULL, &count) == TAMIS_OK && count == 1);
  EXPECT(tamis_world_copy_contacts(world, 0, 1, contacts, sizeof contacts[0]) == TAMIS_OK);
  EXPECT(contacts[0].toi_lower == first && contacts[0].bodies[0] == 1 && contacts[0].bodies[1] == 0);
  EXPECT(tamis_world_earliest(world, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower == first && fabs(lower - 1.0 / 3) < 1e-6 && lower <= upper);
  EXPECT(tamis_world_copy_contacts(world, 0, 1, contacts, sizeof contacts[0]) == TAMIS_OK);
  EXPECT(contacts[0].kind == TAMIS_VERTEX_FACE && contacts[0].vertices[0] == 1 && contacts[0].vertices[1] == 0);
  EXPECT(contacts[0].bodies[0] == 1 && contacts[0].bodies[1] == 0);
  EXPECT(tamis_world_is_free(world, NULL, &is_free) == TAMIS_OK && is_free == 0);
  options.min_separation = &far;
  EXPECT(tamis_world_earliest(world, &options, &lower, &upper, &count) == TAMIS_OK && lower < first - 0.1);
  memset(&statistics, 0, sizeof statistics);
  statistics.size = sizeof statistics;
  EXPECT(tamis_world_statistics(world, &statistics) == TAMIS_OK && statistics.memory_bytes > 0);

  EXPECT(tamis_world_pairs_within(world, 1.05, 0, &count) == TAMIS_OK && count == 3);
  EXPECT(tamis_world_copy_pairs_within(world, 0, 3, near, sizeof near[0]) == TAMIS_OK);
  for (i = 0; i < 3; ++i) EXPECT(near[i].distance == 1 && near[i].bodies[0] == 1 && near[i].bodies[1] == 0);
  EXPECT(tamis_world_intersections(world, 0, &count) == TAMIS_OK && count == 0);
  EXPECT(tamis_world_copy_intersections(world, 0, 0, NULL, sizeof crossing) == TAMIS_OK);
  EXPECT(tamis_world_safe_step(world, 0.5, NULL, &safe) == TAMIS_OK && 0 < safe.toi_lower && safe.toi_lower < first);
  EXPECT(tamis_world_set_radius(world, &contacts[0].bodies[0], 1, -1) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_world_set_radius(world, &contacts[0].bodies[0], 1, 0.5) == TAMIS_OK);
  EXPECT(tamis_world_earliest(world, NULL, &lower, &upper, &count) == TAMIS_OK && lower < first - 0.1);
  tamis_world_free(world);
  tamis_world_free(NULL);
}

static void where_vertices_are(void) {
  tamis_world* world = blade_over_plate();
  double points[9], error = -1;
  EXPECT(tamis_world_points_at(world, 1, 1, 3, points, &error) == TAMIS_OK && 0 < error && error < 1e-14);
  EXPECT(fabs(points[3]) < 1e-14 && points[4] == 0 && fabs(points[5] + 1) < 1e-14); /* the tip, a quarter further */
  EXPECT(tamis_world_points_at(world, 0, 0.5, 3, points, NULL) == TAMIS_OK);
  EXPECT(memcmp(points, plate_points, sizeof points) == 0);
  EXPECT(tamis_world_points_at(world, 1, 1, 4, points, &error) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_world_message(world), "body 1 has 3 vertices");
  EXPECT(tamis_world_points_at(world, 1, 1, 3, NULL, &error) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_points_at(world, 1, 1.5, 3, points, &error) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_world_points_at(world, 2, 1, 3, points, &error) == TAMIS_INVALID_OPTIONS);
  tamis_world_free(world);
}

static void what_goes_straight_and_what_deforms(void) {
  tamis_world* world = blade_over_plate();
  tamis_shape* blade = shape_of(blade_points);
  tamis_motions motion = motions(1);
  const tamis_rigid_link down = {{{0, 0, 1}, {0, quarter, 0}}, {{0, 0, 2.5}, {0, quarter, 0}}};
  const tamis_pose upright = {{0, 0, 1}, {0, quarter, 0}};
  const double soft_start[] = {0, 0, 3, 2, 0, 3, 1, 0.5, 3}, soft_end[] = {0, 0, -1, 2, 0, 3, 1, 0.5, 3};
  const int32_t moved = 1;
  tamis_safe_step safe = {sizeof safe};
  tamis_contact contact;
  tamis_intersection crossing;
  int intersects = -1;
  int32_t soft = -1;
  double lower = 0, upper = 0;
  size_t count = 0;
  motion.poses = &upright; /* it stays in the plate: two that stay are not asked about */
  EXPECT(tamis_world_move(world, &moved, &motion) == TAMIS_OK);
  EXPECT(tamis_world_intersections(world, 0, &count) == TAMIS_OK && count == 0);
  EXPECT(tamis_world_has_intersection(world, 0, &intersects) == TAMIS_OK && intersects == 0);
  EXPECT(tamis_world_has_intersection(world, 0, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_has_overlap(world, 0, &intersects) == TAMIS_OK && intersects == 0);
  EXPECT(tamis_world_has_overlap(world, 1, &intersects) == TAMIS_OK && intersects == 1);
  EXPECT(tamis_world_has_overlap(world, 0, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_is_closed(world, moved, &intersects) == TAMIS_OK && intersects == 0);
  EXPECT(tamis_world_is_closed(world, moved, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_is_closed(world, 99, &intersects) == TAMIS_INVALID_OPTIONS);
  motion.poses = NULL;
  motion.links = &down; /* out of the plate */
  motion.links_of_each = 1;
  EXPECT(tamis_world_move(world, &moved, &motion) == TAMIS_OK);
  EXPECT(tamis_world_intersections(world, 0, &count) == TAMIS_OK && count > 0);
  EXPECT(tamis_world_has_intersection(world, 0, &intersects) == TAMIS_OK && intersects == 1);
  EXPECT(tamis_world_copy_intersections(world, 0, 1, &crossing, sizeof crossing) == TAMIS_OK);
  EXPECT(crossing.bodies[0] == 1 && crossing.bodies[1] == 0);

  EXPECT(tamis_world_remove(world, &moved, 1) == TAMIS_OK);
  motion = motions(1);
  motion.start = soft_start;
  motion.end = soft_end;
  motion.vertex_count = 3;
  EXPECT(tamis_world_add(world, blade, &motion, &soft) == TAMIS_OK && soft == 2);
  EXPECT(tamis_world_earliest(world, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower <= 0.75 && 0.75 <= upper && upper - lower < 1e-6);
  EXPECT(tamis_world_copy_contacts(world, 0, 1, &contact, sizeof contact) == TAMIS_OK && contact.bodies[0] == soft);
  EXPECT(tamis_world_safe_step(world, 0.5, NULL, &safe) == TAMIS_OK);
  EXPECT(fabs(safe.toi_lower - 0.375) < 1e-6 && safe.pair.bodies[0] == soft && safe.pair.bodies[1] == 0 &&
         safe.pair.distance == 3);
  motion.vertex_count = 2;
  EXPECT(tamis_world_move(world, &soft, &motion) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_world_message(world), "give one point a vertex");
  EXPECT(tamis_world_earliest(world, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  tamis_shape_free(blade);
  tamis_world_free(world);
}

/* A row of blades; each third turns far enough. */
static void many_in_one_call(void) {
  enum { kCount = 300 };
  tamis_world* world = blade_over_plate();
  tamis_shape *blade = shape_of(blade_points), *ground = NULL;
  tamis_motions motion = motions(kCount);
  tamis_rigid_link* links = malloc(kCount * sizeof *links);
  int32_t* bodies = malloc(kCount * sizeof *bodies);
  tamis_contact contact;
  const double wide_points[] = {-1e4, -1e4, 0, 1e5, -1e4, 0, 0, 1e5, 0};
  tamis_motions one = motions(1);
  size_t count = 0, i;
  int32_t before;
  for (i = 0; i < kCount; ++i) links[i] = turning(3.0 * (double)i, 1, i % 3 == 0 ? 0.55 : 0.5);
  ground = shape_of(wide_points);
  for (before = 0; before < 2; ++before) EXPECT(tamis_world_remove(world, &before, 1) == TAMIS_OK);
  EXPECT(tamis_world_add(world, ground, &one, &before) == TAMIS_OK && before == 2);
  EXPECT(tamis_world_add(world, blade, &motion, bodies) == TAMIS_OK && bodies[0] == 3 &&
         bodies[kCount - 1] == kCount + 2);
  motion.links = links;
  motion.links_of_each = 1;
  EXPECT(tamis_world_move(world, bodies, &motion) == TAMIS_OK);
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK && count == kCount / 3);
  for (i = 0; i < count; ++i) {
    EXPECT(tamis_world_copy_contacts(world, i, 1, &contact, sizeof contact) == TAMIS_OK);
    EXPECT((contact.bodies[0] - 3) % 3 == 0 && contact.bodies[1] == 2);
  }
  EXPECT(tamis_world_set_enabled(world, bodies, kCount, 0) == TAMIS_OK);
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK && count == 0);
  EXPECT(tamis_world_set_enabled(world, bodies + 3, 1, 1) == TAMIS_OK);
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK && count > 0);
  free(links);
  free(bodies);
  tamis_shape_free(ground);
  tamis_shape_free(blade);
  tamis_world_free(world);
}

static size_t contacts_of(tamis_world* world) {
  size_t count = 0;
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK);
  return count;
}

static void what_is_refused_changes_nothing(void) {
  tamis_world* world = blade_over_plate();
  tamis_shape* blade = shape_of(blade_points);
  tamis_motions motion = motions(2);
  const tamis_pose poses[] = {{{0, 0, 50}, {0, 0, 0}}, {{0, 0, NAN}, {0, 0, 0}}};
  const tamis_rigid_link link = turning(0, 1, 0), far = turning(0, 1, 5000);
  const int32_t there[] = {1, 0}, gone[] = {1, 7}, twice[] = {1, 1};
  const size_t all = contacts_of(world);
  int32_t added[2];
  size_t count = 0;
  EXPECT(all > 0);
  motion.poses = poses;
  EXPECT(tamis_world_move(world, there, &motion) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_world_message(world), "body 0 is not finite");
  EXPECT(contacts_of(world) == all);
  EXPECT(tamis_world_add(world, blade, &motion, added) == TAMIS_INVALID_STEP && contacts_of(world) == all);
  EXPECT(tamis_world_move(world, gone, &motion) == TAMIS_INVALID_OPTIONS && contacts_of(world) == all);
  EXPECT(tamis_world_move(world, twice, &motion) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_world_message(world), "body 1 is named twice");
  EXPECT(tamis_world_remove(world, gone, 2) == TAMIS_INVALID_OPTIONS && contacts_of(world) == all);
  EXPECT(tamis_world_remove(world, twice, 2) == TAMIS_INVALID_OPTIONS && contacts_of(world) == all);
  EXPECT(tamis_world_set_enabled(world, gone, 2, 0) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_world_message(world), "no body 7");
  EXPECT(tamis_world_set_may_touch(world, gone, 1, 0) == TAMIS_INVALID_OPTIONS && contacts_of(world) == all);
  EXPECT(tamis_world_set_may_touch(world, twice, 1, 1) == TAMIS_INVALID_OPTIONS);

  motion.count = 1;
  motion.poses = NULL;
  motion.links = &far;
  motion.links_of_each = 1;
  EXPECT(tamis_world_move(world, there, &motion) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_world_message(world), "body 1 turns by 5000 radians in one step");
  EXPECT(contacts_of(world) == all);
  motion.count = 2;
  motion.poses = poses;
  motion.links_of_each = 0;

  motion.links = &link;
  EXPECT(tamis_world_move(world, there, &motion) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_world_message(world), "more than one of");
  motion.links = NULL;
  motion.links_of_each = 1;
  EXPECT(tamis_world_move(world, there, &motion) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_world_message(world), "links is NULL");
  motion.links_of_each = 0;
  motion.size = 3;
  EXPECT(tamis_world_move(world, there, &motion) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_move(world, there, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_add(world, NULL, &motion, added) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_contacts(world, NULL, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_contacts(NULL, NULL, &count) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_world_pairs_within(world, NAN, 0, &count) == TAMIS_INVALID_OPTIONS);

  EXPECT(tamis_world_set_may_touch(world, there, 1, 0) == TAMIS_OK && contacts_of(world) == 0);
  EXPECT(tamis_world_set_may_touch(world, there, 1, 1) == TAMIS_OK && contacts_of(world) == all);
  tamis_shape_free(blade);
  tamis_world_free(world);
}

static void what_cannot_be_made(void) {
  const double bad_points[] = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
  tamis_mesh_input input = {sizeof input, 3, face, 1, NULL, 0, NULL, 0};
  tamis_world_options options;
  tamis_shape_options of_shape = {sizeof of_shape, NULL};
  tamis_motions motion = motions(1);
  tamis_mesh* mesh = NULL;
  tamis_shape* shape = NULL;
  tamis_world* world = NULL;
  int32_t body = -1;
  size_t count = 0;
  EXPECT(tamis_mesh_create(&input, &mesh) == TAMIS_OK);
  EXPECT(tamis_shape_create(mesh, bad_points, NULL, &shape) == TAMIS_INVALID_MESH);
  EXPECT_SAYS(tamis_shape_message(shape), "vertex 2");
  EXPECT(tamis_world_create(NULL, &world) == TAMIS_OK);
  EXPECT(tamis_world_add(world, shape, &motion, &body) == TAMIS_INVALID_MESH);
  EXPECT_SAYS(tamis_world_message(world), "vertex 2");
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_OK && count == 0);
  tamis_shape_free(shape);
  tamis_world_free(world);
  EXPECT(tamis_shape_create(mesh, NULL, NULL, &shape) == TAMIS_INVALID_ARGUMENT);
  tamis_shape_free(shape);
  of_shape.isa = "baseline";
  EXPECT(tamis_shape_create(mesh, blade_points, &of_shape, &shape) == TAMIS_OK);
  tamis_shape_free(shape);
  of_shape.isa = "perhaps";
  EXPECT(tamis_shape_create(mesh, blade_points, &of_shape, &shape) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_shape_message(shape), "perhaps");
  tamis_shape_free(shape);
  tamis_mesh_free(mesh);

  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.min_separation = -1;
  EXPECT(tamis_world_create(&options, &world) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_world_contacts(world, NULL, &count) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_world_message(world), "min_separation");
  tamis_world_free(world);
}

/* Three motions of the blade: down through the plate, up from it, and a turn. The first and the last meet it. */
static void many_motions(void) {
  tamis_world* world = blade_over_plate();
  const tamis_rigid_link links[] = {{{{0, 0, 1}, {0, 0, 0}}, {{0, 0, -1}, {0, 0, 0}}},
                                    {{{0, 0, 1}, {0, 0, 0}}, {{0, 0, 3}, {0, 0, 0}}},
                                    turning(0, 1, quarter)};
  tamis_motions motion = motions(3);
  tamis_earliest answers[3], shorter[3];
  const int32_t blade[] = {1, 0}, gone = 5;
  double lower = 0, upper = 0;
  size_t count = 0;
  motion.links = links;
  motion.links_of_each = 1;
  EXPECT(tamis_world_earliest_many(world, blade, 1, &motion, NULL, answers, sizeof answers[0]) == TAMIS_OK);
  EXPECT(answers[0].has_contact == 1 && answers[0].toi_lower <= 0.5 && 0.5 <= answers[0].toi_upper);
  EXPECT(answers[1].has_contact == 0 && answers[1].toi_lower == 1 && answers[1].toi_upper == 1);
  EXPECT(answers[2].has_contact == 1 && answers[2].contact.bodies[0] == 1 && answers[2].contact.bodies[1] == 0);
  EXPECT(tamis_world_earliest(world, NULL, &lower, &upper, &count) == TAMIS_OK && lower == answers[2].toi_lower);
  memset(shorter, 0, sizeof shorter);
  EXPECT(tamis_world_earliest_many(world, blade, 1, &motion, NULL, shorter, offsetof(tamis_earliest, contact)) ==
         TAMIS_OK);
  EXPECT(((double*)shorter)[0] == answers[0].toi_lower);
  EXPECT(tamis_world_earliest_many(world, blade, 2, &motion, NULL, answers, sizeof answers[0]) ==
         TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_world_message(world), "3 motions for 2 bodies");
  EXPECT(tamis_world_earliest_many(world, &gone, 1, &motion, NULL, answers, sizeof answers[0]) ==
         TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_world_earliest_many(world, blade, 1, &motion, NULL, NULL, sizeof answers[0]) == TAMIS_INVALID_ARGUMENT);
  motion.count = 0;
  EXPECT(tamis_world_earliest_many(world, blade, 1, &motion, NULL, NULL, sizeof answers[0]) == TAMIS_OK);
  tamis_world_free(world);
}

/* The blade slides along z by a joint, down through the plate. */
static void edges(void) {
  tamis_world* world = blade_over_plate();
  tamis_joint joint;
  tamis_carried_body carried;
  tamis_linkage *linkage = NULL, *bad = NULL;
  tamis_edge_answer answers[2];
  tamis_path_options options;
  const double starts[] = {2, 2}, ends[] = {-2, 3}, waypoints[] = {4, 3, 2, -2};
  const int32_t pairs[] = {0, 1, 2, 3};
  uint8_t are_free[2], of_map[4], edges_of_map[2];
  size_t edge = 0;
  memset(&joint, 0, sizeof joint);
  memset(&carried, 0, sizeof carried);
  joint.parent = -1;
  joint.joint_kind = TAMIS_SLIDING;
  joint.axis[2] = 1;
  joint.factor = 1;
  carried.body = 1;
  EXPECT(tamis_linkage_create(&joint, 1, &carried, 1, &linkage) == TAMIS_OK);
  EXPECT(*tamis_linkage_message(linkage) == 0);
  EXPECT(tamis_linkage_dimension(linkage) == 1 && tamis_linkage_dimension(NULL) == 0);
  EXPECT(tamis_world_edges_are_free(world, linkage, starts, ends, 2, 0, NULL, are_free) == TAMIS_OK);
  EXPECT(are_free[0] == 0 && are_free[1] == 1);
  EXPECT(tamis_world_configurations_are_free(world, linkage, starts, 2, NULL, are_free) == TAMIS_OK);
  EXPECT(are_free[0] == 1 && are_free[1] == 1);
  EXPECT(tamis_world_last_valid(world, linkage, starts, ends, 2, 1, NULL, answers, sizeof answers[0]) == TAMIS_OK);
  EXPECT(answers[0].has_contact == 1 && answers[0].fraction > 0 && answers[0].fraction < 1);
  EXPECT(answers[0].bodies[0] >= 0 && answers[0].contact.bodies[0] == answers[0].bodies[0]);
  EXPECT(answers[1].has_contact == 0 && answers[1].fraction == 1 && answers[1].bodies[0] == -1);
  EXPECT(tamis_world_first_bad_edge(world, linkage, waypoints, 4, 0, NULL, &edge, answers, sizeof answers[0]) ==
         TAMIS_OK);
  EXPECT(edge == 2 && answers[0].has_contact == 1);
  EXPECT(tamis_world_first_bad_edge(world, linkage, waypoints, 3, 0, NULL, &edge, answers, sizeof answers[0]) ==
         TAMIS_OK);
  EXPECT(edge == 2 && answers[0].has_contact == 0);
  EXPECT(tamis_world_roadmap(world, linkage, waypoints, 4, pairs, 2, NULL, of_map, edges_of_map) == TAMIS_OK);
  EXPECT(of_map[0] == 1 && of_map[3] == 1 && edges_of_map[0] == 1 && edges_of_map[1] == 0);
  EXPECT(tamis_world_first_bad_edge(world, linkage, waypoints, 1, 0, NULL, &edge, answers, sizeof answers[0]) ==
         TAMIS_INVALID_OPTIONS);
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  options.at_start = TAMIS_IGNORE;
  EXPECT(tamis_world_edges_are_free(world, linkage, starts, ends, 2, 0, &options, are_free) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_world_message(world), "at_start");
  joint.joint_kind = 3;
  EXPECT(tamis_linkage_create(&joint, 1, &carried, 1, &bad) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_linkage_message(bad), "joint_kind");
  EXPECT(tamis_world_edges_are_free(world, bad, starts, ends, 2, 0, NULL, are_free) == TAMIS_INVALID_OPTIONS);
  tamis_linkage_free(bad);
  tamis_linkage_free(linkage);
  tamis_world_free(world);
}

int main(void) {
  edges();
  many_motions();
  what_is_answered();
  where_vertices_are();
  what_goes_straight_and_what_deforms();
  many_in_one_call();
  what_is_refused_changes_nothing();
  what_cannot_be_made();
  return expect_failures > 0;
}
