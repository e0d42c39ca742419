// Memory runs out at each place of every call that changes a world or a detector: the call fails as a whole, and what
// it was to change answers as before. Bug: a body with half of its new motion; the next question crashes.
#include <gtest/gtest.h>

#include <functional>
#include <new>

#include "support/own_memory.hpp"
#include "tamis/detector.hpp"
#include "tamis/tamis.h"
#include "worlds/simple_shapes.hpp"
#include "worlds/world_numbers.hpp"

namespace tamis::test {
namespace {

constexpr long kNever = -1;
thread_local long left = kNever;  ///< pieces until there are no more

}  // namespace

void on_allocation() {
  if (left == 0) throw std::bad_alloc();
  if (left != kNever) --left;
}

namespace {

/// f() with memory for `pieces` pieces. Was that enough?
bool suffices(long pieces, const std::function<void()>& f) {
  left = pieces;
  try {
    f();
    left = kNever;
    return true;
  } catch (const std::bad_alloc&) {
    left = kNever;
    return false;
  }
}

/// Calls check(made, suffices) after each lack: with memory for 0, 1, 2, ... pieces, until that is enough; of more than
/// `each`, only some.
template <class Make, class Call, class Check>
void for_each_lack(const Make& make, const Call& call, const Check& check, long each = 1'000) {
  constexpr long kMost = 100'000;
  for (long pieces = 0; pieces < kMost; pieces += pieces < each ? 1 : pieces / 4) {
    auto made = make();
    const bool is_enough = suffices(pieces, [&] { call(made); });
    SCOPED_TRACE(testing::Message() << "memory for " << pieces << " pieces");
    check(made, is_enough);
    if (is_enough || testing::Test::HasFailure()) return;
  }
  ADD_FAILURE() << "it never suffices";
}

Options alone() {
  Options options;
  options.threads = 1;
  return options;
}

std::vector<Point> moved(std::vector<Point> points, const Point& by) {
  for (Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return points;
}

/// Motions of a tetrahedron, one of each sort.
const Shape kBody(Mesh(4, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});

std::vector<BodyMotion> motions_at(double x) {
  const Pose here{{x, 0, 0}, {}}, near{{x, 0, 0.1}, {0, 0, 0.5}};
  return {Static{here}, Rigid{interpolated_chain(here, {{x + 1.5, 0, 0}, {}})}, Rigid{interpolated_chain(here, near)},
          Rigid{chain_between(here, near)},
          Deforming{moved(kBody.points(), here.position), moved(kBody.points(), {x + 0.75, 0.1, 0})}};
}

constexpr double kApart = 2;
/// A question takes thousands of pieces.
constexpr long kEach = 8;

/// Bodies in a row, each as all motions are, and another that meets some.
World world_of_all() {
  World world(alone());
  double x = 0;
  for (std::size_t i = 0; i < 5; ++i, x += kApart) world.add(kBody, motions_at(x)[i]);
  world.set_may_touch(0, 3, false);
  return world;
}
const std::vector<BodyId> kAll{0, 1, 2, 3, 4};

/// Asks each detector of the world, and where all bodies are.
Numbers all_numbers(World& world) {
  Numbers numbers;
  for (const BodyContact& c : world.contacts({.tolerance = 1e-3})) append(numbers, c);
  for (const BodyNearPair& pair : world.pairs_within(0.25)) append(numbers, pair);
  for (const BodyId body : kAll) {
    numbers.push_back(static_cast<double>(world.motion(body).index()));
    for (const Point& p : world.points_at(body, 0.375).points) numbers.insert(numbers.end(), p.begin(), p.end());
  }
  return numbers;
}

using Change = std::function<void(World&)>;

/// The change is made as a whole or not at all; also where questions were asked before, which the world keeps data of.
void expect_whole(const char* what, const Change& change, const std::function<Numbers(World&)>& ask) {
  SCOPED_TRACE(what);
  World untouched = world_of_all(), changed = world_of_all();
  change(changed);
  const Numbers before = ask(untouched), after = ask(changed);
  const auto make = [&] {
    World world = world_of_all();
    ask(world);
    return world;
  };
  for_each_lack(make, change, [&](World& world, bool is_made) { EXPECT_EQ(ask(world), is_made ? after : before); });
  // The first question after the change.
  const auto make_changed = [&] {
    World world = make();
    change(world);
    return world;
  };
  for_each_lack(
      make_changed, [](World& world) { static_cast<void>(world.earliest({.tolerance = 1e-3})); },
      [&](World& world, bool) { EXPECT_EQ(ask(world), after); }, kEach);
}

TEST(NoMemory, ABodyIsMovedAsAWhole) {
  for (const BodyId body : {0, 3, 4})
    for (const BodyMotion& motion : motions_at(kApart * body + 0.125))
      expect_whole(
          "move", [&](World& world) { world.move(body, motion); }, all_numbers);
}

TEST(NoMemory, ManyBodiesAreMovedAsAWhole) {
  std::vector<BodyMotion> motions = motions_at(0.5);
  std::swap(motions[0], motions[4]);
  expect_whole(
      "move_many", [&](World& world) { world.move_many(kAll, motions); }, all_numbers);
}

TEST(NoMemory, BodiesAreAddedAsAWhole) {
  const auto ask = [](World& world) {
    Numbers numbers = all_numbers(world);
    const BodyId next = world.add(kBody, Static{{{0, 50, 0}, {}}});
    numbers.push_back(next);
    world.remove(next);
    return numbers;
  };
  World untouched = world_of_all();
  const Numbers before = ask(untouched);
  const auto expect_none = [&](World& world, bool is_made) {
    if (is_made) return;
    EXPECT_EQ(ask(world), before);
  };
  for (const BodyMotion& motion : motions_at(0.5))
    for_each_lack(
        world_of_all, [&](World& world) { world.add(kBody, motion); }, expect_none);
  for_each_lack(
      world_of_all, [&](World& world) { world.add_many(kBody, motions_at(0.5)); }, expect_none);
}

TEST(NoMemory, OtherChangesAreMadeAsAWhole) {
  expect_whole(
      "set_radius", [](World& world) { world.set_radius(4, 0.25); }, all_numbers);
  expect_whole(
      "set_enabled", [](World& world) { world.set_enabled(1, false); }, all_numbers);
  expect_whole(
      "set_may_touch", [](World& world) { world.set_may_touch(1, 2, false); }, all_numbers);
  expect_whole(
      "touch again", [](World& world) { world.set_may_touch(0, 3, true); }, all_numbers);
  const std::vector<std::array<BodyId, 2>> pairs{{4, 4}, {1, 2}, {2, 3}};
  expect_whole(
      "set_may_touch of many", [&](World& world) { world.set_may_touch(pairs, false); }, all_numbers);
  const auto without_one = [](World& world) { return contacts_of(world); };
  expect_whole(
      "remove", [](World& world) { world.remove(1); }, without_one);
}

TEST(NoMemory, AQuestionThatFailsChangesNothing) {
  World asked = world_of_all();
  const Numbers expected = all_numbers(asked);
  const std::vector<BodyMotion> others = motions_at(2);
  const std::vector<Change> questions{
      [](World& w) { static_cast<void>(w.contacts()); },
      [](World& w) { static_cast<void>(w.is_free()); },
      [](World& w) { static_cast<void>(w.safe_step(0.25)); },
      [](World& w) { static_cast<void>(w.pairs_within(0.25)); },
      [](World& w) { static_cast<void>(w.intersections()); },
      [&](World& w) { static_cast<void>(w.earliest_many(std::vector<BodyId>{1}, others)); }};
  for (const Change& question : questions)
    for_each_lack(
        world_of_all, question, [&](World& world, bool) { EXPECT_EQ(all_numbers(world), expected); }, kEach);
}

TEST(NoMemory, ADetectorAnswersAsBefore) {
  const Mesh mesh(8, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {4, 5, 6}, {4, 5, 7}, {4, 6, 7}, {5, 6, 7}});
  std::vector<Point> start = kBody.points(), end = kBody.points();
  for (const Point& p : moved(kBody.points(), {1.25, 0.125, 0.0625})) start.push_back(p);
  for (const Point& p : moved(kBody.points(), {0.5, 0.125, 0.0625})) end.push_back(p);
  const Step step{start, end};
  const auto ask = [&](Detector& detector) {
    Numbers numbers;
    for (const Contact& c : detector.contacts(step))
      numbers.insert(numbers.end(), {c.toi_lower, c.toi_upper, c.u, c.v});
    const TruncatedStep truncated = detector.truncate(step);
    for (const Point& p : truncated.positions) numbers.insert(numbers.end(), p.begin(), p.end());
    for (const NearPair& p : detector.pairs_within(start, 0.5)) numbers.push_back(p.distance);
    const SafeStep safe = detector.safe_step(step);
    numbers.insert(numbers.end(), {safe.toi_lower, safe.toi_upper, double(detector.intersections(end).size())});
    return numbers;
  };
  Detector untouched(mesh, alone());
  const Numbers expected = ask(untouched);
  for_each_lack([&] { return 0; }, [&](int) { Detector(mesh, alone()); }, [](int, bool) {});
  for (const bool is_warm : {false, true}) {
    const auto make = [&] {
      Detector detector(mesh, alone());
      if (is_warm) static_cast<void>(ask(detector));
      return detector;
    };
    for_each_lack(
        make, [&](Detector& detector) { static_cast<void>(ask(detector)); },
        [&](Detector& detector, bool) { EXPECT_EQ(ask(detector), expected); }, kEach);
  }
}

/// The same through the C interface, whose calls change many bodies at once.
TEST(NoMemory, TheCInterfaceChangesAsAWhole) {
  const std::int32_t faces[]{0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
  const double points[]{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  tamis_mesh_input input{};
  input.size = sizeof input;
  input.vertex_count = 4;
  input.faces = faces;
  input.face_count = 4;
  tamis_mesh* mesh = nullptr;
  tamis_shape* shape = nullptr;
  ASSERT_EQ(tamis_mesh_create(&input, &mesh), TAMIS_OK);
  ASSERT_EQ(tamis_shape_create(mesh, points, nullptr, &shape), TAMIS_OK);
  const auto links_at = [](double x, double way) {
    tamis_rigid_link link{};
    link.start.position[0] = x;
    link.end.position[0] = x + way;
    return link;
  };
  const tamis_rigid_link first[]{links_at(0, 3), links_at(2, 0), links_at(8, 0)};
  const tamis_rigid_link second[]{links_at(0, 1), links_at(5, 0), links_at(8, -4)};
  const auto motions_of = [](const tamis_rigid_link* links) {
    tamis_motions motions{};
    motions.size = sizeof motions;
    motions.count = 3;
    motions.links = links;
    motions.links_of_each = 1;
    return motions;
  };
  const tamis_motions before = motions_of(first), after = motions_of(second);
  const auto ask = [](tamis_world* world) {
    double lower = 0, upper = 0;
    std::size_t count = 0;
    EXPECT_EQ(tamis_world_earliest(world, nullptr, &lower, &upper, &count), TAMIS_OK);
    return Numbers{lower, upper, double(count)};
  };
  std::int32_t bodies[3]{};
  const auto make = [&](const tamis_motions& motions) {
    tamis_world* world = nullptr;
    EXPECT_EQ(tamis_world_create(nullptr, &world), TAMIS_OK);
    EXPECT_EQ(tamis_world_add(world, shape, &motions, bodies), TAMIS_OK);
    return world;
  };
  tamis_world *untouched = make(before), *changed = make(after);
  const Numbers of_before = ask(untouched), of_after = ask(changed);
  ASSERT_NE(of_before, of_after);
  const std::int32_t apart[]{0, 1, 0, 2};
  for (const bool is_move : {true, false})
    for (long pieces = 0, is_over = 0; !is_over && pieces < 1000; ++pieces) {
      tamis_world* world = make(before);
      ask(world);
      left = pieces;
      const tamis_status status =
          is_move ? tamis_world_move(world, bodies, &after) : tamis_world_set_may_touch(world, apart, 2, 0);
      left = kNever;
      is_over = status == TAMIS_OK;
      EXPECT_EQ(status, is_over ? TAMIS_OK : TAMIS_OUT_OF_MEMORY);
      EXPECT_EQ(ask(world), !is_over ? of_before : is_move ? of_after : (Numbers{1, 1, 0})) << pieces;
      tamis_world_free(world);
    }
  tamis_world_free(untouched);
  tamis_world_free(changed);
  tamis_shape_free(shape);
  tamis_mesh_free(mesh);
}

}  // namespace
}  // namespace tamis::test
