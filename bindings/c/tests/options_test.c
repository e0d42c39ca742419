/* Options as C gives them: each one reaches the library, and what it calls back gets what it should. */
#include "expect.h"
#include "scene.h"

/* Contacts of the falling triangle with these options; -1 and a note if they are refused. */
static long contacts_with(const tamis_options* options) {
  size_t count = 0;
  long answer = -1;
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  if (tamis_detector_create(mesh, options, &detector) == TAMIS_OK &&
      tamis_detector_contacts(detector, &step, &count) == TAMIS_OK)
    answer = (long)count;
  else
    printf("refused: %s\n", tamis_detector_message(detector));
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
  return answer;
}

static void by_name(void) {
  tamis_options options = {sizeof options};
  options.isa = "baseline";
  options.threads = 1;
  EXPECT(contacts_with(&options) == 1);
  options.isa = "perhaps";
  EXPECT(contacts_with(&options) == -1);
}

static void separation(void) {
  tamis_options options = {sizeof options};
  options.min_separation = 3; /* the second triangle is within it at t=0: more pairs */
  EXPECT(contacts_with(&options) > 1);
  options.min_separation = -1;
  EXPECT(contacts_with(&options) == -1);
  options.min_separation = 0;
  options.threads = -1;
  EXPECT(contacts_with(&options) == -1);
}

/* Radii of groups, and a separation of one question: both make the triangle stop earlier. */
static void radii(void) {
  const int32_t group_of_vertex[] = {0, 0, 0, 1, 1, 1};
  const double radii[] = {0.1, 0.2}, more = 0.2;
  double lower = 0, upper = 0;
  size_t count = 0;
  tamis_options options = {sizeof options};
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  options.group_of_vertex = group_of_vertex;
  options.group_count = 2;
  options.radii = radii;
  EXPECT(tamis_detector_create(mesh, &options, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_earliest(detector, &step, &lower, &upper, &count) == TAMIS_OK);
  EXPECT(lower <= 0.35 && 0.35 <= upper && upper - lower < 1e-6);
  step.min_separation = &more;
  EXPECT(tamis_detector_earliest(detector, &step, &lower, &upper, &count) == TAMIS_OK);
  EXPECT(lower <= 0.25 && 0.25 <= upper && upper - lower < 1e-6);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

static void groups(void) {
  const int32_t group_of_vertex[] = {0, 0, 0, 1, 1, 1};
  const uint8_t only_within[] = {1, 0, 0, 1}, all[] = {1, 1, 1, 1}, lopsided[] = {1, 0, 1, 1};
  tamis_options options = {sizeof options};
  options.group_of_vertex = group_of_vertex;
  options.group_count = 2;
  options.groups_may_touch = only_within;
  EXPECT(contacts_with(&options) == 0);
  options.groups_may_touch = all;
  EXPECT(contacts_with(&options) == 1);
  options.groups_may_touch = lopsided;
  EXPECT(contacts_with(&options) == -1);
  options.group_count = -2;
  EXPECT(contacts_with(&options) == -1);
}

struct caller {
  int asked, answer, saw_the_pair, reentry_status;
  tamis_detector* detector;
};

static int accepts(void* user, int32_t kind, const int32_t* vertices) {
  struct caller* caller = user;
  ++caller->asked;
  if (kind == TAMIS_VERTEX_FACE && vertices[0] == 3 && vertices[3] == 2) caller->saw_the_pair = 1;
  if (caller->detector) {
    size_t count = 0;
    const tamis_step step = falling();
    caller->reentry_status = tamis_detector_contacts(caller->detector, &step, &count);
  }
  return caller->answer;
}

static int is_cancelled(void* user) {
  ++((struct caller*)user)->asked;
  return ((struct caller*)user)->answer;
}

static void callbacks(void) {
  struct caller caller = {0, 0, 0, 0, NULL};
  tamis_options options = {sizeof options};
  options.threads = 1;
  options.user = &caller;
  options.accepts = accepts;
  EXPECT(contacts_with(&options) == 0 && caller.asked > 0 && caller.saw_the_pair);
  caller.answer = 1;
  EXPECT(contacts_with(&options) == 1);
  options.accepts = NULL;
  options.is_cancelled = is_cancelled;
  EXPECT(contacts_with(&options) == -1);
  caller.answer = caller.asked = 0;
  EXPECT(contacts_with(&options) == 1 && caller.asked > 0);
}

/* A filter that asks its own detector would wait for itself for ever. */
static void reentry(void) {
  struct caller caller = {0, 1, 0, TAMIS_OK, NULL};
  tamis_options options = {sizeof options};
  tamis_mesh* mesh = two_triangles();
  tamis_step step = falling();
  size_t count = 0;
  options.user = &caller;
  options.accepts = accepts;
  EXPECT(tamis_detector_create(mesh, &options, &caller.detector) == TAMIS_OK);
  EXPECT(tamis_detector_contacts(caller.detector, &step, &count) == TAMIS_OK && count == 1);
  EXPECT(caller.reentry_status == TAMIS_BUSY);
  tamis_detector_free(caller.detector);
  tamis_mesh_free(mesh);
}

/* The detector may be asked again after a question that was cancelled. */
static void cancelled(void) {
  struct caller caller = {0, 1, 0, 0, NULL};
  tamis_options options = {sizeof options};
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  size_t count = 0;
  options.user = &caller;
  options.is_cancelled = is_cancelled;
  EXPECT(tamis_detector_create(mesh, &options, &detector) == TAMIS_OK);
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_CANCELLED);
  caller.answer = 0;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 1);
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

/* Within a separation of 3 all pairs touch at the start, and stay so. */
static void at_start(void) {
  const double wide = 3;
  size_t count = 9;
  tamis_statistics statistics = {sizeof statistics};
  tamis_mesh* mesh = two_triangles();
  tamis_detector* detector = NULL;
  tamis_step step = falling();
  step.min_separation = &wide;
  EXPECT(tamis_detector_create(mesh, NULL, &detector) == TAMIS_OK);
  step.at_start = TAMIS_IGNORE;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_OK && count == 0);
  EXPECT(tamis_detector_statistics(detector, &statistics) == TAMIS_OK && statistics.ignored == 15);
  step.at_start = TAMIS_FAIL;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_INVALID_STEP);
  EXPECT_SAYS(tamis_detector_message(detector), "vertex 0 and face 3 4 5 touch at the start");
  step.at_start = 256;
  EXPECT(tamis_detector_contacts(detector, &step, &count) == TAMIS_INVALID_OPTIONS);
  EXPECT_SAYS(tamis_detector_message(detector), "TAMIS_IGNORE");
  tamis_detector_free(detector);
  tamis_mesh_free(mesh);
}

/* No edge leads from the one triangle to the other: no number of rings leaves out what touches. */
static void rings(void) {
  tamis_options options = {sizeof options};
  options.rings = 100;
  EXPECT(contacts_with(&options) == 1);
  options.rings = -1;
  EXPECT(contacts_with(&options) == -1);
}

int main(void) {
  by_name();
  separation();
  radii();
  groups();
  callbacks();
  reentry();
  cancelled();
  at_start();
  rings();
  return expect_failures > 0;
}
