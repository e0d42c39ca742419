/* Two triangles; corner 3 of the second falls through the first, at half of the step. */
#ifndef TAMIS_TESTS_C_SCENE_H
#define TAMIS_TESTS_C_SCENE_H
#include <tamis/tamis.h>

static const int32_t faces[] = {0, 1, 2, 3, 4, 5};
static const double start[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2};
static const double end[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, -1, 1, 0.5, 2, 0.5, 1, 2};

static tamis_mesh* two_triangles(void) {
  tamis_mesh_input input = {sizeof input, 6, faces, 2, NULL, 0, NULL, 0};
  tamis_mesh* mesh = NULL;
  tamis_mesh_create(&input, &mesh);
  return mesh;
}

static tamis_step falling(void) {
  tamis_step step = {sizeof step, 6, start, end, 0, 0, NULL, TAMIS_REPORT};
  return step;
}

#endif
