#include <stdio.h>
#include <tamis/tamis.h>

int main(void) {
  /* two triangles; the second one's corner 3 falls */
  const int32_t faces[] = {0, 1, 2, 3, 4, 5};
  const double start[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2};
  const double end[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, -1, 1, 0.5, 2, 0.5, 1, 2};
  const tamis_mesh_input input = {.size = sizeof input, .vertex_count = 6, .faces = faces, .face_count = 2};
  const tamis_step step = {.size = sizeof step, .vertex_count = 6, .start = start, .end = end};
  tamis_mesh* mesh;
  tamis_detector* detector = NULL;
  tamis_contact contact;
  size_t count = 0;

  if (tamis_mesh_create(&input, &mesh) != TAMIS_OK) puts(tamis_mesh_message(mesh));
  if (tamis_detector_create(mesh, NULL, &detector) != TAMIS_OK) puts(tamis_detector_message(detector));
  if (tamis_detector_contacts(detector, &step, &count) != TAMIS_OK) puts(tamis_detector_message(detector));
  for (size_t i = 0; i < count; ++i) {
    tamis_detector_copy_contacts(detector, i, 1, &contact, sizeof contact);
    printf("vertex %d meets the face in [%.6f, %.6f]\n", contact.vertices[0], contact.toi_lower, contact.toi_upper);
  }
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
  return 0;
}
