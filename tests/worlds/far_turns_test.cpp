// Bodies that turn far, near each other, against each pair of features decided by itself on its curves: what halving
// the step in lanes proves free must be free, and what touches must be found.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "worlds/random_world.hpp"

namespace tamis::test {
namespace {

Shape turning_cube() {
  const scenes::Shape shape = scenes::unit_cube(1);
  return {Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points};
}

Rigid far_turn(Random& random, const Point& place) {
  const Point by = random.point(0.8);
  const Pose start{place, random.point(3)};
  Pose end{{place[0] + by[0], place[1] + by[1], place[2] + by[2]}, start.rotation};
  for (double& w : end.rotation) w += random.in(-5, 5);
  return {interpolated_chain(start, end)};
}

/// The first time at which each pair of features of two bodies may touch: of those that do.
std::map<NamedPair, PairResult> each_by_itself(const TestWorld& world, const OneMesh& mesh, double separation) {
  std::map<NamedPair, PairResult> found;
  PairOptions options;
  options.min_separation = separation;
  const Mesh& cube = world.bodies[0].shape.mesh();
  const auto count = static_cast<Index>(world.bodies[0].shape.points().size());
  const auto add = [&](PairKind kind, const std::array<Index, 4>& v) {
    const PairResult r =
        kind == PairKind::vertex_face ? vertex_face(mesh.path, v, options) : edge_edge(mesh.path, v, options);
    if (r.touches) found[named(Contact{kind, r.certainty, v, 0, 0, 0, 0, {}}, mesh)] = r;
  };
  for (const Index first : {0, count})
    for (const Index p : cube.points())
      for (const Face& f : cube.faces()) {
        const Index other = count - first;
        add(PairKind::vertex_face, {first + p, other + f[0], other + f[1], other + f[2]});
      }
  for (const Edge& a : cube.edges())
    for (const Edge& b : cube.edges()) add(PairKind::edge_edge, {a[0], a[1], count + b[0], count + b[1]});
  return found;
}

/// Returns how many pairs touch.
std::size_t compare(std::uint64_t seed, double separation) {
  Random random(seed);
  Options options = one_thread();
  options.min_separation = separation;
  TestWorld world(options);
  world.add(turning_cube(), far_turn(random, {0, 0, 0}));
  world.add(turning_cube(), far_turn(random, {random.in(1.8, 3), random.in(-1, 1), 0}));
  const OneMesh mesh(world, options);
  const auto pairs = each_by_itself(world, mesh, separation);
  const std::vector<BodyContact> contacts = world.world.contacts();
  std::set<NamedPair> named_contacts;
  for (const BodyContact& c : contacts) {
    named_contacts.insert(named(c));
    const auto alone = pairs.find(named(c));
    EXPECT_NE(alone, pairs.end());
    if (alone == pairs.end()) continue;
    EXPECT_LE(c.toi_lower, alone->second.toi_upper);  // brackets of one first touch
    EXPECT_GE(c.toi_upper, alone->second.toi_lower);
  }
  for (const auto& [pair, result] : pairs) EXPECT_TRUE(named_contacts.contains(pair)) << "at " << result.toi_lower;
  double first = 1;
  for (const auto& [pair, result] : pairs) first = std::min(first, result.toi_upper);
  const EarliestBodyContact earliest = world.world.earliest();
  EXPECT_EQ(earliest.contact.has_value(), !pairs.empty());
  EXPECT_LE(earliest.toi_lower, first);
  EXPECT_EQ(world.world.is_free(), pairs.empty());
  return pairs.size();
}

void expect_agreement(std::uint64_t worlds, double separation) {
  std::size_t touching = 0;
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    SCOPED_TRACE(seed);
    touching += compare(seed, separation);
  }
  EXPECT_GT(touching, 100U);
}

TEST(World, AgreesWithEachPairWhereBodiesTurnFar) { expect_agreement(12, 0); }

TEST(World, AgreesWithEachPairWithinASeparationWhereBodiesTurnFar) { expect_agreement(6, 0.05); }

}  // namespace
}  // namespace tamis::test
