/* parallel_for: a program in C lends its threads. Bug: a body called in another way than C++ expects, a user pointer
 * that is not passed on, an answer that depends on who computes. */
#include <pthread.h>
#include <stdlib.h>

#include "expect.h"
#include "scene.h"

enum { THREADS = 3, SIDE = 40, VERTICES = 2 * SIDE * SIDE, FACES = 4 * (SIDE - 1) * (SIDE - 1) };

/* A loop that new threads run, one body each. */
struct task {
  tamis_loop_body body;
  void* loop;
  int32_t i;
};
struct engine {
  int loops, most;
};

static void* run_task(void* given) {
  struct task* task = given;
  task->body(task->loop, task->i);
  return NULL;
}

static void parallel_for(void* user, int32_t count, tamis_loop_body body, void* loop) {
  struct engine* engine = user;
  struct task tasks[THREADS];
  pthread_t threads[THREADS];
  int is_started[THREADS];
  ++engine->loops;
  if (count > engine->most) engine->most = count;
  for (int32_t i = 0; i < count; ++i) {
    tasks[i].body = body, tasks[i].loop = loop, tasks[i].i = i;
    is_started[i] = pthread_create(&threads[i], NULL, run_task, &tasks[i]) == 0;
    if (!is_started[i]) run_task(&tasks[i]); /* a system without threads */
  }
  for (int32_t i = 0; i < count; ++i)
    if (is_started[i]) pthread_join(threads[i], NULL);
}

/* Two wavy sheets, of which the upper falls through the lower. */
static double positions[2][3 * VERTICES];
static int32_t sheet_faces[3 * FACES];

static void make_sheets(void) {
  int32_t* face = sheet_faces;
  for (int v = 0; v < VERTICES; ++v) {
    const int sheet = v / (SIDE * SIDE), x = v % SIDE, y = v / SIDE % SIDE;
    for (int at_end = 0; at_end < 2; ++at_end) {
      double* p = &positions[at_end][3 * v];
      p[0] = x + 0.3 * sheet, p[1] = y + 0.2 * sheet;
      p[2] = 0.25 * ((x * 7 + y * 5) % 4) + (sheet ? (at_end ? -1.5 : 1.5) : 0);
    }
    if (x + 1 == SIDE || y + 1 == SIDE) continue;
    *face++ = v, *face++ = v + 1, *face++ = v + SIDE;
    *face++ = v + 1, *face++ = v + SIDE + 1, *face++ = v + SIDE;
  }
}

static tamis_contact* contacts_with(const tamis_options* options, size_t* count, int* threads) {
  tamis_mesh_input input = {sizeof input};
  tamis_step step = {sizeof step};
  tamis_statistics statistics = {sizeof statistics};
  tamis_mesh* mesh = NULL;
  tamis_detector* detector = NULL;
  tamis_contact* contacts = NULL;
  input.vertex_count = VERTICES, input.faces = sheet_faces, input.face_count = FACES;
  step.vertex_count = VERTICES, step.start = positions[0], step.end = positions[1];
  EXPECT(tamis_mesh_create(&input, &mesh) == TAMIS_OK);
  EXPECT(tamis_detector_create(mesh, options, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_contacts(detector, &step, count) == TAMIS_OK);
  contacts = calloc(*count + 1, sizeof *contacts);
  EXPECT(tamis_detector_copy_contacts(detector, 0, *count, contacts, sizeof *contacts) == TAMIS_OK);
  EXPECT(tamis_detector_statistics(detector, &statistics) == TAMIS_OK);
  *threads = (int)statistics.threads;
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
  return contacts;
}

static void detectors(void) {
  struct engine engine = {0, 0};
  tamis_options alone = {sizeof alone}, lent = {sizeof lent};
  size_t count = 0, lent_count = 0;
  int threads = 0;
  tamis_contact *expected, *found;
  alone.threads = 1;
  lent.threads = THREADS, lent.parallel_for = parallel_for, lent.user = &engine;
  expected = contacts_with(&alone, &count, &threads);
  EXPECT(threads == 1 && count > 1000);
  found = contacts_with(&lent, &lent_count, &threads);
  EXPECT(threads == THREADS && engine.loops > 0 && engine.most == THREADS);
  EXPECT(lent_count == count && memcmp(found, expected, count * sizeof *found) == 0);
  free(found);
  engine.loops = 0;
  lent.threads = 1;
  found = contacts_with(&lent, &lent_count, &threads);
  EXPECT(threads == 1 && engine.loops == 0 && lent_count == count);
  free(found);
  free(expected);
}

/* Loops that are too short to share stay with the thread that asks. */
static void few_triangles(void) {
  struct engine engine = {0, 0};
  tamis_options options = {sizeof options};
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  const tamis_step step = falling();
  size_t count = 0;
  options.threads = THREADS, options.parallel_for = parallel_for, options.user = &engine;
  EXPECT(tamis_detector_create(mesh, &options, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 1 && engine.loops == 0);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

static void lists_of_pairs(void) {
  enum { COUNT = 20000 };
  struct engine engine = {0, 0};
  tamis_pair_options options = {sizeof options};
  tamis_pairs* pairs = NULL;
  tamis_feature_pair* list = calloc(COUNT, sizeof *list);
  tamis_pair_result* results = calloc(COUNT, sizeof *results);
  const tamis_step step = falling();
  int touching = 0;
  for (int i = 0; i < COUNT; ++i) {
    list[i].kind = TAMIS_VERTEX_FACE;
    list[i].vertices[0] = 3;
    for (int32_t c = 0; c < 3; ++c) list[i].vertices[c + 1] = c;
  }
  options.threads = THREADS, options.parallel_for = parallel_for, options.user = &engine;
  EXPECT(tamis_pairs_create(&options, &pairs) == TAMIS_OK);
  EXPECT(tamis_narrow_phase(pairs, list, COUNT, &step, results, sizeof *results) == TAMIS_OK);
  for (int i = 0; i < COUNT; ++i) touching += results[i].touches != 0;
  EXPECT(touching == COUNT && engine.loops > 0);
  tamis_pairs_free(pairs);
  free(results);
  free(list);
}

static void worlds(void) {
  tamis_world_options options = {sizeof options};
  tamis_world* world = NULL;
  int is_free = 0;
  struct engine engine = {0, 0};
  options.threads = THREADS, options.parallel_for = parallel_for, options.user = &engine;
  EXPECT(tamis_world_create(&options, &world) == TAMIS_OK);
  EXPECT(tamis_world_is_free(world, NULL, &is_free) == TAMIS_OK && is_free);
  tamis_world_free(world);
}

int main(void) {
  make_sheets();
  EXPECT(tamis_has_threads() == 0 || tamis_has_threads() == 1);
  detectors();
  few_triangles();
  lists_of_pairs();
  worlds();
  return expect_failures != 0;
}
