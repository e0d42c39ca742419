/* Single pairs and lists of them from C, every status included. */
#include <math.h>
#include <tamis/tamis.h>

#include "expect.h"

static void pairs_of_features(void) {
  const double before[] = {0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double after[] = {0.2, 0.2, -3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, -3, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double crossed[] = {-1, 0, 1, 1, 0, 1, 0, -1, 0, 0, 1, 0}, past[] = {-1, 0, -1, 1, 0, -1, 0, -1, 0, 0, 1, 0};
  const double meeting[] = {0, 0, 1, -1, 0, 0, 1, 0, 0}, met[] = {0, 0, -1, -1, 0, 0, 1, 0, 0};
  const double apart[] = {0, 0, 1, 0, 0, 0}, passed[] = {0, 0, -3, 0, 0, 0};
  double bad[24];
  tamis_pair_result r[2];
  tamis_pairs* pairs = NULL;
  tamis_pair_options options = {sizeof options, 0, 0, NULL, NULL};
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
  EXPECT(tamis_vertex_face(pairs, 2, before, after, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[0].certainty == TAMIS_CERTIFIED && r[1].touches == 0);
  EXPECT(r[0].toi_lower <= 0.25 && 0.25 <= r[0].toi_upper && fabs(r[0].u - 0.2) < 1e-9);
  EXPECT(tamis_edge_edge(pairs, 1, crossed, past, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[0].toi_lower <= 0.5 && 0.5 <= r[0].toi_upper && fabs(r[0].v - 0.5) < 1e-9);
  EXPECT(tamis_vertex_edge(pairs, 1, meeting, met, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[0].toi_lower <= 0.5 && 0.5 <= r[0].toi_upper && fabs(r[0].u - 0.5) < 1e-9);
  EXPECT(tamis_vertex_vertex(pairs, 1, apart, passed, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[0].toi_lower <= 0.25 && 0.25 <= r[0].toi_upper);
  EXPECT(tamis_edge_edge(pairs, 0, NULL, NULL, NULL, 0) == TAMIS_OK);
  EXPECT(tamis_edge_edge(pairs, 1, NULL, past, r, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  memcpy(bad, before, sizeof bad);
  bad[15] = INFINITY;
  EXPECT(tamis_vertex_face(pairs, 2, bad, after, r, sizeof r[0]) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_pairs_message(pairs), "pair 1");
  tamis_pairs_free(pairs);

  EXPECT(tamis_pairs_create(NULL, &pairs) == TAMIS_OK);
  tamis_pairs_free(pairs);
  options.min_separation = -1;
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_pairs_message(pairs), "separation");
  EXPECT(tamis_vertex_face(pairs, 1, before, after, r, sizeof r[0]) == TAMIS_INVALID_OPTIONS);
  tamis_pairs_free(pairs);
  tamis_pairs_free(NULL);
}

static void lists_of_pairs(void) {
  const double start[] = {0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 1};
  const double end[] = {0.2, 0.2, -3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, -3};
  const double wide = 100;
  tamis_feature_pair list[] = {
      {TAMIS_VERTEX_FACE, {0, 1, 2, 3}}, {TAMIS_VERTEX_FACE, {4, 1, 2, 3}}, {TAMIS_VERTEX_VERTEX, {0, 4, -1, -1}}};
  tamis_step step = {sizeof step, 5, start, end, 0, 0, NULL, TAMIS_REPORT};
  tamis_pair_result r[3];
  tamis_pairs* pairs = NULL;
  tamis_pair_options options = {sizeof options, 0, 1, "baseline", NULL};
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
  EXPECT(tamis_narrow_phase(pairs, list, 3, &step, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[1].touches == 0 && r[2].touches == 0);
  EXPECT(r[0].toi_lower <= 0.25 && 0.25 <= r[0].toi_upper);
  step.min_separation = &wide;
  EXPECT(tamis_narrow_phase(pairs, list, 3, &step, r, sizeof r[0]) == TAMIS_OK);
  EXPECT(r[0].touches == 1 && r[1].touches == 1 && r[2].touches == 1 && r[2].toi_upper == 0);
  EXPECT(tamis_narrow_phase(pairs, NULL, 0, &step, NULL, 0) == TAMIS_OK);
  EXPECT(tamis_narrow_phase(pairs, NULL, 1, &step, r, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_narrow_phase(pairs, list, 3, NULL, r, sizeof r[0]) == TAMIS_INVALID_ARGUMENT);
  list[2].vertices[1] = 5;
  EXPECT(tamis_narrow_phase(pairs, list, 3, &step, r, sizeof r[0]) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_pairs_message(pairs), "pair 2: vertex 5 is not a row of the step's 5 positions");
  list[1].kind = 256;
  EXPECT(tamis_narrow_phase(pairs, list, 3, &step, r, sizeof r[0]) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_pairs_message(pairs), "pair 1: unknown kind");
  tamis_pairs_free(pairs);
  options.threads = -1;
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_INVALID_OPTIONS);
  tamis_pairs_free(pairs);
}

/* Would catch an option that is not handed on, and a default of 0 in place of 1. */
static void until_the_latest_time(void) {
  const double before[] = {0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double after[] = {0.2, 0.2, -3, 0, 0, 0, 1, 0, 0, 0, 1, 0}; /* they meet at 0.25 */
  const double times[] = {0, 0.2, 0.3, 1};
  const int touches[] = {0, 0, 1, 1};
  double latest;
  tamis_pair_options options = {sizeof options, 0, 0, NULL, NULL};
  const tamis_feature_pair pair = {TAMIS_VERTEX_FACE, {0, 1, 2, 3}};
  tamis_step step = {sizeof step, 4, before, after, 0, 0, NULL, TAMIS_REPORT};
  tamis_pairs* pairs = NULL;
  tamis_pair_result r;
  int i;
  options.latest = &latest;
  for (i = 0; i < 4; ++i) {
    latest = times[i];
    EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
    EXPECT(tamis_vertex_face(pairs, 1, before, after, &r, sizeof r) == TAMIS_OK && r.touches == touches[i]);
    EXPECT(tamis_narrow_phase(pairs, &pair, 1, &step, &r, sizeof r) == TAMIS_OK && r.touches == touches[i]);
    tamis_pairs_free(pairs);
  }
  latest = 1.5;
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_INVALID_OPTIONS);
  tamis_pairs_free(pairs);
  options.size = offsetof(tamis_pair_options, latest); /* a caller who does not know it */
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
  tamis_pairs_free(pairs);
}

static void distances(void) {
  const double at[] = {0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.2, 4};
  tamis_feature_pair list[] = {{TAMIS_VERTEX_FACE, {0, 1, 2, 3}}, {TAMIS_VERTEX_VERTEX, {0, 4, 7, 7}}};
  tamis_step step = {sizeof step, 5, at, NULL, 0, 0, NULL, TAMIS_REPORT};
  tamis_near_pair near[2];
  tamis_pairs* pairs = NULL;
  EXPECT(tamis_pairs_create(NULL, &pairs) == TAMIS_OK);
  EXPECT(tamis_distances_of(pairs, list, 2, &step, near, sizeof near[0]) == TAMIS_OK);
  EXPECT(near[0].kind == TAMIS_VERTEX_FACE && near[0].distance == 1);
  EXPECT(near[0].direction[2] == 1 && fabs(near[0].u - 0.2) < 1e-12);
  EXPECT(near[1].kind == TAMIS_VERTEX_VERTEX && near[1].distance == 3 && near[1].vertices[2] == -1);
  EXPECT(tamis_distances_of(pairs, NULL, 0, &step, NULL, 0) == TAMIS_OK);
  EXPECT(tamis_distances_of(pairs, NULL, 1, &step, near, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_distances_of(pairs, list, 1, &step, NULL, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_distances_of(pairs, list, 1, &step, near, 0) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_distances_of(pairs, list, 1, NULL, near, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_distances_of(NULL, list, 1, &step, near, sizeof near[0]) == TAMIS_INVALID_ARGUMENT);
  list[1].vertices[1] = 5;
  EXPECT(tamis_distances_of(pairs, list, 2, &step, near, sizeof near[0]) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_pairs_message(pairs), "pair 1: vertex 5");
  list[0].kind = -1;
  EXPECT(tamis_distances_of(pairs, list, 2, &step, near, sizeof near[0]) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_pairs_message(pairs), "pair 0: unknown kind");
  tamis_pairs_free(pairs);
}

static void kept_distance(void) {
  const double before[] = {0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double after[] = {0.2, 0.2, -3, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double latest = 0.1, half = 0.5;
  tamis_feature_pair pair = {TAMIS_VERTEX_FACE, {0, 1, 2, 3}};
  tamis_step step = {sizeof step, 4, before, after, 0, 0, NULL, TAMIS_REPORT};
  tamis_pair_options options = {sizeof options, 0, 0, NULL, NULL};
  tamis_safe_step safe = {sizeof safe};
  tamis_pairs* pairs = NULL;
  EXPECT(tamis_pairs_create(NULL, &pairs) == TAMIS_OK);
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 0.2, &safe) == TAMIS_OK);
  EXPECT(safe.has_pair == 1 && safe.pair.kind == TAMIS_VERTEX_FACE && safe.pair.vertices[3] == 3 &&
         safe.pair.distance == 1);
  EXPECT(safe.toi_lower <= 0.2 && safe.toi_lower > 0.19 && safe.toi_upper >= 0.2);
  step.min_separation = &half;
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 0, &safe) == TAMIS_OK);
  EXPECT(safe.toi_lower <= 0.125 && safe.toi_lower > 0.124);
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 1, &safe) == TAMIS_INVALID_OPTIONS);
  EXPECT(tamis_pair_safe_step(pairs, NULL, &step, 0, &safe) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_pair_safe_step(pairs, &pair, NULL, 0, &safe) == TAMIS_INVALID_ARGUMENT);
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 0, NULL) == TAMIS_INVALID_ARGUMENT);
  pair.vertices[3] = 4;
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 0, &safe) == TAMIS_INVALID_STEP);
  pair.vertices[3] = 3;
  tamis_pairs_free(pairs);

  options.latest = &latest;
  step.min_separation = NULL;
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
  EXPECT(tamis_pair_safe_step(pairs, &pair, &step, 0.2, &safe) == TAMIS_OK);
  EXPECT(safe.toi_lower == latest && safe.has_pair == 0);
  tamis_pairs_free(pairs);
}

int main(void) {
  pairs_of_features();
  lists_of_pairs();
  until_the_latest_time();
  distances();
  kept_distance();
  return expect_failures > 0;
}
