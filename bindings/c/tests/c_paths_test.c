/* Curved motion, and a step for each vertex, from C99: what is answered, what is refused, and that all is freed. */
#include <math.h>

#include "expect.h"
#include "scene.h"

static const double half_turn[] = {0, 0, 3.14159265358979323846};
/* A wall at x = 0; a blade that turns about z from one side to the other, free at the start and at the end. */
static const double rest[] = {0, 1, -1, 0, 3, -1, 0, 2, 2, 1.9, -0.1, -2, 2.1, 0.1, -2, 2, 0, 0.5};
static const int32_t bodies[] = {0, 0, 0, 1, 1, 1};
static const size_t links_of_body[] = {0, 2};

static tamis_detector* detector_of_two(void) {
  tamis_detector* detector = NULL;
  tamis_mesh* mesh = two_triangles();
  EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_OK);
  tamis_mesh_free(mesh);
  return detector;
}

static tamis_path* turning_blade(void) {
  const tamis_pose still = {{0, 0, 0}, {0, 0, 0}};
  const double origin[] = {0, 0, 0};
  tamis_rigid_link links[2];
  tamis_rigid_path_input input = {sizeof input, 6, rest, bodies, 2, links_of_body, links, NULL};
  tamis_path* path = NULL;
  EXPECT(tamis_turned_chain(&still, half_turn, origin, NULL, links) == TAMIS_OK);
  EXPECT(tamis_rigid_path_create(&input, &path) == TAMIS_OK);
  return path;
}

/* The same motion, as functions; what rounding does to it is far below the error that they admit. */
static void points_at(void* user, double time, const int32_t* vertices, size_t count, double* points, double* errors) {
  const double angle = time * half_turn[2], c = cos(angle), s = sin(angle);
  size_t i;
  for (i = 0; i < count; ++i) {
    const double* at = rest + 3 * vertices[i];
    const int moves = bodies[vertices[i]];
    points[3 * i] = moves ? c * at[0] - s * at[1] : at[0];
    points[3 * i + 1] = moves ? s * at[0] + c * at[1] : at[1];
    points[3 * i + 2] = at[2];
    errors[i] = *(double*)user;
  }
}

static void deviations(void* user, double from, double to, const int32_t* vertices, size_t count, double* bounds) {
  size_t i;
  (void)user;
  for (i = 0; i < count; ++i)
    bounds[i] = bodies[vertices[i]] ? 2.2 * half_turn[2] * half_turn[2] * (to - from) * (to - from) / 8 : 0;
}

static void a_mesh_on_a_path(void) {
  tamis_detector* detector = detector_of_two();
  tamis_path* path = turning_blade();
  tamis_path_options options = {sizeof options, 1e-3, NULL};
  tamis_contact contacts[32];
  double lower = 0, upper = 0, points[18], first = 2;
  const double far = 0.25, all = 3;
  size_t count = 0, wide = 0, i;
  int is_free = -1;
  EXPECT(tamis_detector_contacts_on_path(detector, path, NULL, &count) == TAMIS_OK && count > 0 && count <= 32);
  EXPECT(tamis_detector_copy_contacts(detector, 0, count, contacts, sizeof contacts[0]) == TAMIS_OK);
  for (i = 0; i < count && i < 32; ++i) {
    EXPECT(contacts[i].certainty == TAMIS_CERTIFIED && contacts[i].toi_upper - contacts[i].toi_lower <= 1e-9);
    first = fmin(first, contacts[i].toi_lower);
  }
  EXPECT(tamis_detector_earliest_on_path(detector, path, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower == first && 0.4 < lower && lower <= upper && upper < 0.5);
  EXPECT(tamis_detector_is_free_on_path(detector, path, NULL, &is_free) == TAMIS_OK && is_free == 0);
  EXPECT(tamis_detector_contacts_on_path(detector, path, &options, &wide) == TAMIS_OK && wide > 0);
  options.min_separation = &far;
  EXPECT(tamis_detector_earliest_on_path(detector, path, &options, &lower, &upper, &count) == TAMIS_OK);
  EXPECT(lower < first);
  options.min_separation = &all;
  EXPECT(tamis_detector_contacts_on_path(detector, path, &options, &wide) == TAMIS_OK && wide > 0);
  options.at_start = TAMIS_IGNORE;
  EXPECT(tamis_detector_contacts_on_path(detector, path, &options, &count) == TAMIS_OK && count < wide);
  options.at_start = TAMIS_FAIL;
  EXPECT(tamis_detector_contacts_on_path(detector, path, &options, &count) == TAMIS_INVALID_STEP);
  options.at_start = 3;
  EXPECT(tamis_detector_contacts_on_path(detector, path, &options, &count) == TAMIS_INVALID_OPTIONS);

  EXPECT(tamis_path_points_at(path, 1, points) == TAMIS_OK);
  EXPECT(fabs(points[9] + 1.9) < 1e-12 && fabs(points[10] - 0.1) < 1e-12 && points[3] == 0);
  {
    tamis_step straight = {sizeof straight, 6, rest, points, 0, 0, NULL, TAMIS_REPORT};
    EXPECT(tamis_detector_is_free(detector, &straight, &is_free) == TAMIS_OK && is_free == 1);
  }
  tamis_path_free(path);
  tamis_path_free(NULL);
  tamis_detector_free(detector);
}

static void pairs_on_a_path(void) {
  tamis_path* path = turning_blade();
  tamis_path_options options = {sizeof options, 0, NULL};
  const double separation = 0.5;
  const int32_t edges[] = {0, 1, 3, 5, 0, 1, 4, 5}, face[] = {5, 0, 1, 2}, point_edge[] = {4, 0, 1}, points[] = {0, 5};
  const int32_t outside[] = {0, 1, 3, 6};
  tamis_pair_result r[2];
  EXPECT(tamis_path_edge_edge(path, NULL, 2, edges, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[1].touches == 1 && r[1].toi_lower < r[0].toi_lower);
  EXPECT(tamis_path_vertex_face(path, NULL, 1, face, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[0].toi_lower <= 0.5 && 0.5 <= r[0].toi_upper);
  options.min_separation = &separation;
  EXPECT(tamis_path_vertex_edge(path, &options, 1, point_edge, r, sizeof r[0]) == TAMIS_OK && r[0].touches == 0);
  EXPECT(tamis_path_vertex_vertex(path, &options, 1, points, r, sizeof r[0]) == TAMIS_OK && r[0].touches == 0);
  EXPECT(tamis_path_vertex_vertex(path, NULL, 0, NULL, NULL, 0) == TAMIS_OK);
  EXPECT(tamis_path_edge_edge(path, NULL, 1, outside, r, sizeof r[0]) == TAMIS_INVALID_PATH);
  EXPECT_SAYS(tamis_path_message(path), "6");
  EXPECT(tamis_path_edge_edge(path, NULL, 1, NULL, r, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_path_edge_edge(path, NULL, 1, edges, NULL, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  options.at_start = TAMIS_IGNORE;
  EXPECT(tamis_path_edge_edge(path, &options, 1, edges, r, sizeof r[0]) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_path_message(path), "leave it 0");
  options.at_start = TAMIS_REPORT;
  options.tolerance = 2;
  EXPECT(tamis_path_edge_edge(path, &options, 1, edges, r, sizeof r[0]) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_path_edge_edge(NULL, NULL, 1, edges, r, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  tamis_path_free(path);
}

static void other_paths(void) {
  tamis_detector* detector = detector_of_two();
  tamis_path* path = NULL;
  tamis_pose there = {{1, 2, 3}, {0, 0, 1}}, still = {{0, 0, 0}, {0, 0, 0}};
  tamis_rigid_link links[2];
  double frames[54], error = 1e-14, lower, upper, points[18];
  size_t count;
  int is_free = -1;
  tamis_spline_path_input input = {sizeof input, 6, 2, frames};
  tamis_path_functions functions = {sizeof functions, 6, points_at, deviations, &error};
  const size_t no_links[] = {0, 0};
  const tamis_rigid_path_input deforming = {sizeof deforming, 6, start, bodies, 2, no_links, NULL, end};
  memcpy(frames, start, sizeof start);
  memcpy(frames + 18, end, sizeof end);
  memcpy(frames + 36, start, sizeof start);
  EXPECT(tamis_bezier_path_create(&input, &path) == TAMIS_OK);
  EXPECT(tamis_detector_earliest_on_path(detector, path, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower <= 0.5 && 0.5 <= upper);
  tamis_path_free(path);
  input.frame_count = 3;
  EXPECT(tamis_catmull_rom_path_create(&input, &path) == TAMIS_OK);
  EXPECT(tamis_path_points_at(path, 0.5, points) == TAMIS_OK && memcmp(points, end, sizeof end) == 0);
  EXPECT(tamis_detector_earliest_on_path(detector, path, NULL, &lower, &upper, &count) == TAMIS_OK && upper < 0.5);
  tamis_path_free(path);

  EXPECT(tamis_function_path_create(&functions, &path) == TAMIS_OK);
  EXPECT(tamis_detector_is_free_on_path(detector, path, NULL, &is_free) == TAMIS_OK && is_free == 0);
  error = -1;
  EXPECT(tamis_detector_is_free_on_path(detector, path, NULL, &is_free) == TAMIS_INVALID_PATH);
  EXPECT_SAYS(tamis_detector_message(detector), "give a bound >= 0");
  tamis_path_free(path);

  EXPECT(tamis_rigid_path_create(&deforming, &path) == TAMIS_OK);
  EXPECT(tamis_detector_earliest_on_path(detector, path, NULL, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower <= 0.5 && 0.5 <= upper);
  tamis_path_free(path);

  EXPECT(tamis_chain_between(&still, &there, NULL, links) == TAMIS_OK);
  EXPECT(links[0].end.position[2] == 3 && fabs(links[0].end.rotation[2] - 1) < 1e-12);
  EXPECT(tamis_chain_between(&still, NULL, NULL, links) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_chain_between(&still, &there, NULL, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_turned_chain(&still, NULL, half_turn, NULL, links) == TAMIS_INVALID_ARGUMENT);
  tamis_detector_free(detector);
}

/* A quarter about z, given as engines keep it, about the point (1, 0, 0) of the body. */
static void poses_of_engines(void) {
  const double half = sqrt(0.5), quaternion[] = {half, 0, 0, (float)half}, rows[] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  const double origin[] = {0, 0, 0}, center[] = {1, 0, 0}, none[] = {2, 0, 0, 0}, nan_position[] = {0, NAN, 0};
  tamis_pose start = {{0, 0, 0}, {0, 0, 0}}, end, same, there;
  tamis_rigid_link links[2];
  double part = -1;
  EXPECT(tamis_pose_of_quaternion(quaternion, origin, &end) == TAMIS_OK &&
         fabs(end.rotation[2] - half_turn[2] / 2) < 1e-7);
  EXPECT(tamis_pose_of_matrix(rows, origin, &same) == TAMIS_OK && fabs(same.rotation[2] - half_turn[2] / 2) < 1e-15);
  EXPECT(tamis_pose_of_quaternion(none, origin, &end) == TAMIS_INVALID_PATH);
  EXPECT(tamis_pose_of_matrix(rows, nan_position, &end) == TAMIS_INVALID_PATH);
  EXPECT(tamis_chain_between(&start, &same, center, links) == TAMIS_OK);
  EXPECT(links[0].start.position[0] == 1 && fabs(links[0].end.position[1] - 1) < 1e-15);
  EXPECT(links[1].start.position[0] == -1);
  EXPECT(tamis_pose_at(links, 2, 1, &there) == TAMIS_OK && fabs(there.rotation[2] - same.rotation[2]) < 1e-15);
  EXPECT(tamis_pose_at(links, 2, 2, &there) == TAMIS_INVALID_PATH);
  EXPECT(tamis_pose_at(NULL, 1, 0, &there) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_pose_at(NULL, 0, 0, &there) == TAMIS_OK && there.position[0] == 0);
  EXPECT(tamis_nlerp_deviation(&start, &same, &part) == TAMIS_OK && 0.03 < part && part < 0.04);
  EXPECT(tamis_nlerp_deviation(&start, &start, &part) == TAMIS_OK && part == 0);
  EXPECT(tamis_nlerp_deviation(&start, &same, NULL) == TAMIS_INVALID_ARGUMENT);
}

static void bad_paths(void) {
  tamis_detector* detector = detector_of_two();
  tamis_path* path = NULL;
  tamis_rigid_path_input rigid = {sizeof rigid, 6, rest, bodies, 1, links_of_body, NULL, NULL};
  tamis_spline_path_input spline = {sizeof spline, 6, 1, rest};
  tamis_path_functions functions = {sizeof functions, -1, points_at, deviations, NULL};
  size_t count = 0;
  double points[18];
  EXPECT(tamis_rigid_path_create(&rigid, &path) == TAMIS_INVALID_PATH);
  EXPECT_SAYS(tamis_path_message(path), "body 1");
  EXPECT(tamis_detector_contacts_on_path(detector, path, NULL, &count) == TAMIS_INVALID_PATH);
  EXPECT_SAYS(tamis_detector_message(detector), "body 1");
  EXPECT(tamis_path_points_at(path, 0, points) == TAMIS_INVALID_PATH);
  tamis_path_free(path);
  rigid.body_count = 2;
  EXPECT(tamis_rigid_path_create(&rigid, &path) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_path_message(path), "links is NULL");
  tamis_path_free(path);
  EXPECT(tamis_catmull_rom_path_create(&spline, &path) == TAMIS_INVALID_PATH);
  EXPECT_SAYS(tamis_path_message(path), "at least 2");
  tamis_path_free(path);
  spline.frames = NULL;
  EXPECT(tamis_bezier_path_create(&spline, &path) == TAMIS_INVALID_ARGUMENT);
  tamis_path_free(path);
  EXPECT(tamis_function_path_create(&functions, &path) == TAMIS_INVALID_PATH);
  tamis_path_free(path);
  functions.vertex_count = 6;
  functions.deviations = NULL;
  EXPECT(tamis_function_path_create(&functions, &path) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_path_message(path), "deviations is NULL");
  tamis_path_free(path);
  EXPECT(tamis_function_path_create(&functions, NULL) == TAMIS_INVALID_ARGUMENT);

  EXPECT(tamis_detector_contacts_on_path(detector, NULL, NULL, &count) == TAMIS_INVALID_ARGUMENT);
  spline.frames = rest;
  spline.vertex_count = 5;
  EXPECT(tamis_bezier_path_create(&spline, &path) == TAMIS_OK);
  EXPECT(tamis_detector_contacts_on_path(detector, path, NULL, &count) == TAMIS_INVALID_PATH);
  EXPECT(tamis_detector_contacts_on_path(detector, path, NULL, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_path_points_at(path, 1.5, points) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_path_points_at(path, 1, NULL) == TAMIS_INVALID_ARGUMENT);
  tamis_path_free(path);
  tamis_detector_free(detector);
}

static void a_step_for_each_vertex(void) {
  tamis_detector* detector = detector_of_two();
  tamis_step step = falling();
  double sideways[18], positions[18], fractions[6], same[18];
  int is_free = -1, i;
  memcpy(sideways, end, sizeof end);
  sideways[7] = 1.25; /* vertex 2 meets nothing */
  step.end = sideways;
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, TAMIS_FLOAT64, positions, fractions, &is_free) == TAMIS_OK &&
         is_free == 1);
  EXPECT(0.1 <= positions[11] && positions[11] < 0.5);
  for (i = 0; i < 6; ++i) EXPECT(0 <= fractions[i] && fractions[i] <= 1);
  EXPECT(fractions[2] > fractions[3] && fabs(positions[11] - (1 - 2 * fractions[3])) < 1e-12);
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, TAMIS_FLOAT64, same, NULL, &is_free) == TAMIS_OK);
  EXPECT(memcmp(same, positions, sizeof same) == 0);
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, TAMIS_FLOAT32, same, NULL, &is_free) == TAMIS_OK);
  for (i = 0; i < 18; ++i) EXPECT(same[i] == (float)same[i] && fabs(same[i] - positions[i]) < 1e-6);
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, 2, same, NULL, &is_free) == TAMIS_INVALID_ARGUMENT);
  step.end = positions;
  is_free = -1;
  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_OK && is_free == 1);

  EXPECT(tamis_detector_truncate(detector, &step, 0, TAMIS_FLOAT64, positions, fractions, &is_free) ==
         TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_detector_truncate(detector, &step, 1, TAMIS_FLOAT64, positions, fractions, &is_free) ==
         TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, TAMIS_FLOAT64, NULL, fractions, &is_free) ==
         TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_truncate(detector, &step, 0.1, TAMIS_FLOAT64, positions, fractions, NULL) ==
         TAMIS_INVALID_ARGUMENT);
  tamis_detector_free(detector);
}

int main(void) {
  a_mesh_on_a_path();
  pairs_on_a_path();
  other_paths();
  poses_of_engines();
  bad_paths();
  a_step_for_each_vertex();
  return expect_failures > 0;
}
