/* Every function of the C interface, from C99: what it answers, what it refuses, and that it frees all it takes (the
 * program also runs under valgrind and the sanitizers). */
#include <math.h>
#include <stdlib.h>

#include "expect.h"
#include "scene.h"

static void expect_the_one_contact(const tamis_contact* c) {
  EXPECT(c->kind == TAMIS_VERTEX_FACE && c->certainty == TAMIS_CERTIFIED);
  EXPECT(c->vertices[0] == 3 && c->vertices[1] == 0 && c->vertices[2] == 1 && c->vertices[3] == 2);
  EXPECT(c->toi_lower <= 0.5 && 0.5 <= c->toi_upper && c->toi_upper - c->toi_lower < 1e-9);
  EXPECT(fabs(c->u - 0.25) < 1e-9 && fabs(c->v - 0.25) < 1e-9);
  EXPECT(fabs(c->normal[2] - 1) < 1e-9);
}

static void meshes(void) {
  size_t count = 99;
  const int32_t edge[] = {0, 1}, point[] = {2}, wrong[] = {0, 1, 7};
  tamis_mesh* mesh = two_triangles();
  EXPECT(strlen(tamis_mesh_message(mesh)) == 0);
  EXPECT(tamis_mesh_edges(mesh, &count)[1] == 1 && count == 6);
  EXPECT(tamis_mesh_points(mesh, &count)[5] == 5 && count == 6);
  tamis_mesh_free(mesh);

  {
    tamis_mesh_input rods = {sizeof rods, 3, NULL, 0, edge, 1, point, 1};
    EXPECT(tamis_mesh_create(&rods, &mesh) == TAMIS_OK);
    EXPECT(tamis_mesh_edges(mesh, &count) && count == 1);
    EXPECT(tamis_mesh_points(mesh, &count) && count == 3);
    tamis_mesh_free(mesh);
  }
  {
    tamis_mesh_input outside = {sizeof outside, 3, wrong, 1, NULL, 0, NULL, 0};
    EXPECT(tamis_mesh_create(&outside, &mesh) == TAMIS_INVALID_MESH);
    EXPECT_SAYS(tamis_mesh_message(mesh), "7");
    EXPECT(tamis_mesh_edges(mesh, &count) == NULL && count == 0);
    {
      tamis_detector* detector = NULL;
      EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_INVALID_MESH);
      EXPECT_SAYS(tamis_detector_message(detector), "7");
      tamis_detector_free(detector);
    }
    tamis_mesh_free(mesh);
    outside.faces = NULL;
    EXPECT(tamis_mesh_create(&outside, &mesh) == TAMIS_INVALID_ARGUMENT);
    EXPECT_SAYS(tamis_mesh_message(mesh), "faces is NULL");
    tamis_mesh_free(mesh);
    EXPECT(tamis_mesh_create(&outside, NULL) == TAMIS_INVALID_ARGUMENT);
    EXPECT(tamis_mesh_create(NULL, &mesh) == TAMIS_INVALID_ARGUMENT);
    tamis_mesh_free(mesh);
  }
  tamis_mesh_free(NULL);
}

static void questions(void) {
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  tamis_contact contact;
  tamis_safe_step safe = {sizeof safe};
  tamis_statistics statistics;
  size_t count = 0;
  double lower = 0, upper = 0;
  int is_free = -1;
  EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_OK);
  tamis_mesh_free(mesh); /* the detector has its own */

  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 1);
  EXPECT(tamis_detector_copy_contacts(detector, 0, 1, &contact, sizeof contact) == TAMIS_OK);
  expect_the_one_contact(&contact);
  memset(&statistics, 0, sizeof statistics);
  statistics.size = sizeof statistics;
  EXPECT(tamis_detector_statistics(detector, &statistics) == TAMIS_OK);
  EXPECT(statistics.rebuilt == 1 && statistics.stage_count >= 2 && statistics.seconds_total > 0);
  EXPECT(!strcmp(statistics.stages[0].name, "boxes") && statistics.stages[0].pairs[TAMIS_VERTEX_FACE] >= 1);
  EXPECT(statistics.isa != NULL);

  EXPECT(tamis_detector_earliest(detector, &step, &lower, &upper, &count) == TAMIS_OK && count == 1);
  EXPECT(lower <= 0.5 && 0.5 <= upper);
  EXPECT(tamis_detector_copy_contacts(detector, 0, 1, &contact, sizeof contact) == TAMIS_OK);
  expect_the_one_contact(&contact);

  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_OK && is_free == 0);
  EXPECT(tamis_detector_safe_step(detector, &step, 0.5, &safe) == TAMIS_OK);
  EXPECT(fabs(safe.toi_lower - 0.25) < 1e-6 && safe.has_pair == 1 && safe.pair.vertices[0] == 3 &&
         safe.pair.distance == 1);
  EXPECT(tamis_detector_safe_step(detector, &step, 1, &safe) == TAMIS_INVALID_OPTIONS);

  step.end = start;
  EXPECT(tamis_detector_earliest(detector, &step, &lower, &upper, &count) == TAMIS_OK);
  EXPECT(count == 0 && lower == 1 && upper == 1);
  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_OK && is_free == 1);
  EXPECT(tamis_detector_copy_contacts(detector, 0, 1, &contact, sizeof contact) == TAMIS_INVALID_ARGUMENT);
  tamis_detector_free(detector);
  tamis_detector_free(NULL);
}

/* Rows of four doubles whose last is not a number: reading one of them shows. */
static void strides(void) {
  double padded[24];
  int i;
  size_t count = 0;
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  for (i = 0; i < 24; ++i) padded[i] = i % 4 == 3 ? NAN : start[i / 4 * 3 + i % 4];
  step.start = padded;
  step.start_stride = 4;
  EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 1);
  step.end_stride = 2;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_detector_message(detector), "end_stride is 2");
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

static void bad_steps(void) {
  double bad[18];
  size_t count = 0;
  int is_free = 0;
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  tamis_detector_create(mesh, NULL, &detector);
  memcpy(bad, start, sizeof bad);
  bad[4] = NAN;
  step.start = bad;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_detector_message(detector), "vertex 1");
  step.start = NULL;
  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_INVALID_ARGUMENT);
  step = falling();
  step.vertex_count = 5;
  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_INVALID_STEP);
  step = falling();
  step.size = 0;
  EXPECT(tamis_detector_is_free(detector, &step, &is_free) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_detector_message(detector), "sizeof");
  EXPECT(tamis_detector_is_free(detector, NULL, &is_free) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_is_free(NULL, NULL, &is_free) == TAMIS_INVALID_ARGUMENT);
  step = falling();
  EXPECT(tamis_detector_is_free(detector, &step, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_contacts(detector, &step, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 1);
  EXPECT(strlen(tamis_detector_message(detector)) == 0);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

/* A caller of an older version knows a shorter struct, one of a newer version a longer one. */
static void structs_of_other_versions(void) {
  struct {
    tamis_step known;
    double later;
  } newer;
  size_t count = 0;
  tamis_contact contact, *longer = NULL;
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_detector_create(mesh, NULL, &detector);
  memset(&newer, 0, sizeof newer);
  newer.known = falling();
  newer.known.size = sizeof newer;
  EXPECT(tamis_detector_contacts(detector, &newer.known, &count) == TAMIS_OK && count == 1);
  newer.later = 1;
  EXPECT(tamis_detector_contacts(detector, &newer.known, &count) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_detector_message(detector), tamis_version());
  newer.known = falling();
  newer.known.size = offsetof(tamis_step, end) +
                     sizeof newer.known.end / 2; /* bug: half of a pointer was taken for a whole one, and read */
  EXPECT(tamis_detector_contacts(detector, &newer.known, &count) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_detector_message(detector), "sizeof");
  newer.known.size = offsetof(tamis_step, start_stride); /* as if strides had come later */
  EXPECT(tamis_detector_contacts(detector, &newer.known, &count) == TAMIS_OK && count == 1);

  memset(&contact, 0x5a, sizeof contact);
  EXPECT(tamis_detector_copy_contacts(detector, 0, 1, &contact, offsetof(tamis_contact, toi_upper)) == TAMIS_OK);
  EXPECT(contact.toi_lower > 0.49 && contact.toi_lower <= 0.5);
  EXPECT(memcmp(&contact.toi_upper, "\x5a\x5a\x5a\x5a", 4) == 0);
  longer = calloc(1, sizeof contact + 8);
  memset(longer, 0x5a, sizeof contact + 8);
  EXPECT(tamis_detector_copy_contacts(detector, 0, 1, longer, sizeof contact + 8) == TAMIS_OK);
  expect_the_one_contact(longer);
  EXPECT(((unsigned char*)longer)[sizeof contact] == 0);
  free(longer);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

static void at_rest(void) {
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  tamis_near_pair near[32];
  tamis_intersection crossing;
  size_t count = 0;
  int intersects = -1;
  size_t i;
  int found = 0;
  EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_pairs_within(detector, &step, 1, &count) == TAMIS_OK && count > 0 && count <= 32);
  EXPECT(tamis_detector_copy_pairs_within(detector, 0, count, near, sizeof near[0]) == TAMIS_OK);
  for (i = 0; i < count && i < 32; ++i)
    found += near[i].kind == TAMIS_VERTEX_FACE && near[i].vertices[0] == 3 && near[i].distance == 1 &&
             near[i].direction[2] == 1;
  EXPECT(found == 1);
  EXPECT(tamis_detector_pairs_within(detector, &step, -1, &count) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_detector_copy_pairs_within(detector, 0, 1, near, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_pairs_within(detector, &step, 1, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_copy_pairs_within(detector, 33, 1, near, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_detector_copy_pairs_within(detector, 0, 1, NULL, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);

  EXPECT(tamis_detector_has_intersection(detector, &step, &intersects) == TAMIS_OK && intersects == 0);
  EXPECT(tamis_detector_intersections(detector, &step, &count) == TAMIS_OK && count == 0);
  step.start = end;
  EXPECT(tamis_detector_has_intersection(detector, &step, &intersects) == TAMIS_OK && intersects == 1);
  EXPECT(tamis_detector_intersections(detector, &step, &count) == TAMIS_OK && count > 0);
  EXPECT(tamis_detector_copy_intersections(detector, 0, 1, &crossing, sizeof crossing) == TAMIS_OK);
  EXPECT(crossing.edge[0] < crossing.edge[1] && crossing.s_lower <= crossing.s_upper);
  EXPECT(crossing.face[0] == 0 || crossing.face[0] == 3);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

/* The same edges in another order and direction, as another library lists them, and one that the mesh has not. */
static void edges_of_another_list(void) {
  const int32_t others[] = {5, 4, 1, 0, 2, 5}, faces_of_it[] = {3, 4, 5, 1, 0, 2};
  int32_t places[3] = {-2, -2, -2};
  size_t count = 0;
  tamis_mesh* mesh = two_triangles();
  const int32_t* edges = tamis_mesh_edges(mesh, &count);
  EXPECT(tamis_mesh_find_edges(mesh, others, 3, places) == TAMIS_OK && places[2] == -1);
  EXPECT(places[0] >= 0 && edges[2 * places[0]] == 4 && edges[2 * places[0] + 1] == 5);
  EXPECT(places[1] >= 0 && edges[2 * places[1]] == 0 && edges[2 * places[1] + 1] == 1);
  EXPECT(tamis_mesh_find_faces(mesh, faces_of_it, 2, places) == TAMIS_OK && places[0] == 1 && places[1] == -1);
  EXPECT(tamis_mesh_find_edges(mesh, NULL, 0, NULL) == TAMIS_OK);
  EXPECT(tamis_mesh_find_edges(mesh, NULL, 1, places) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_mesh_find_faces(mesh, faces_of_it, 1, NULL) == TAMIS_INVALID_ARGUMENT);
  tamis_mesh_free(mesh);
}

static void signed_weights(void) {
  double weights[4] = {9, 9, 9, 9};
  EXPECT(tamis_weights_of(TAMIS_VERTEX_FACE, 0.25, 0.5, weights) == TAMIS_OK);
  EXPECT(weights[0] == 1 && weights[1] == -0.25 && weights[2] == -0.25 && weights[3] == -0.5);
  EXPECT(tamis_weights_of(4, 0.25, 0.5, weights) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_weights_of(TAMIS_EDGE_EDGE, 0.25, 0.5, NULL) == TAMIS_INVALID_ARGUMENT);
}

static void features_by_number(void) {
  tamis_mesh_input nothing = {sizeof nothing, 3, NULL, 0, NULL, 0, NULL, 0};
  const int32_t corner_and_face[] = {3, 0, 1, 2}, edges[] = {0, 1, 4, 5}, none[] = {3, 0, 1, 4};
  int32_t first = -2, second = -2;
  size_t count = 0;
  tamis_mesh *mesh = two_triangles(), *failed = NULL;
  const int32_t* all = tamis_mesh_edges(mesh, &count);
  EXPECT(tamis_mesh_features_of(mesh, TAMIS_VERTEX_FACE, corner_and_face, &first, &second) == TAMIS_OK);
  EXPECT(first == 3 && second == 0);
  EXPECT(tamis_mesh_features_of(mesh, TAMIS_EDGE_EDGE, edges, &first, &second) == TAMIS_OK);
  EXPECT(first >= 0 && all[2 * first] == 0 && all[2 * first + 1] == 1);
  EXPECT(second >= 0 && all[2 * second] == 4 && all[2 * second + 1] == 5);
  EXPECT(tamis_mesh_features_of(mesh, TAMIS_VERTEX_FACE, none, &first, &second) == TAMIS_INVALID_MESH);
  EXPECT_SAYS(tamis_mesh_message(mesh), "no face of the vertices 0, 1, 4");
  EXPECT(tamis_mesh_features_of(mesh, 4, edges, &first, &second) == TAMIS_INVALID_ARGUMENT);
  EXPECT_SAYS(tamis_mesh_message(mesh), "kind");
  EXPECT(tamis_mesh_features_of(mesh, TAMIS_EDGE_EDGE, NULL, &first, &second) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_mesh_features_of(mesh, TAMIS_EDGE_EDGE, edges, &first, NULL) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_mesh_features_of(NULL, TAMIS_EDGE_EDGE, edges, &first, &second) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_mesh_create(&nothing, &failed) == TAMIS_INVALID_MESH);
  EXPECT(tamis_mesh_features_of(failed, TAMIS_EDGE_EDGE, edges, &first, &second) == TAMIS_INVALID_MESH);
  tamis_mesh_free(failed);
  tamis_mesh_free(mesh);
}

int main(void) {
  EXPECT(strlen(tamis_version()) >= 5);
  meshes();
  questions();
  features_by_number();
  edges_of_another_list();
  signed_weights();
  strides();
  bad_steps();
  structs_of_other_versions();
  at_rest();
  return expect_failures > 0;
}
