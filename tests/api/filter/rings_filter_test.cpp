// Pairs that are too few edges apart: every method leaves them out of every answer, and no other pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "search/topology/rings.hpp"
#include "support/as_new.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;
using yardstick::Method;

yardstick::Options with_rings(Method method, int rings) {
  yardstick::Options options = with(method, 0x1p-4);
  options.filter.rings = rings;
  return options;
}

/// The rows whose features are no neighbours. `first(row)`, `second(row)`: vertices of the features.
template <class Row, class First, class Second>
std::vector<Row> far_apart(std::vector<Row> rows, const Rings& rings, const First& first, const Second& second) {
  std::erase_if(rows, [&](const Row& row) { return rings.are_neighbours(first(row), second(row)); });
  return rows;
}

template <class Row>
std::vector<Row> far_apart(const std::vector<Row>& rows, const Rings& rings) {
  const auto all = [](const Row& r) { return std::span<const Index>(r.vertices.data(), vertex_count(r.kind)); };
  return far_apart(
      rows, rings, [&](const Row& r) { return all(r).first(second_feature(r.kind)); },
      [&](const Row& r) { return all(r).subspan(second_feature(r.kind)); });
}

template <class Row>
std::vector<PairName> names(std::span<const Row> rows) {
  std::vector<PairName> result;
  for (const Row& row : rows) result.push_back({row.kind, row.vertices});
  std::ranges::sort(result);
  return result;
}

class RingsOf : public testing::TestWithParam<Recipe> {
 protected:
  const Scene scene = GetParam().make(90, 37);
};

// Bugs: a question that does not ask for neighbours, or a method that bypasses the decision of a pair; neighbours that
// bound the search for the first contact; a pair that is left out although it is no neighbour.
TEST_P(RingsOf, LeaveOutNeighboursAlone) {
  const Mesh mesh = scene.mesh();
  constexpr double kNear = 0.25;
  std::size_t left_out = 0;
  for (const Method method : kMethods) {
    Detector all = yardstick::make_detector(mesh, with_rings(method, 1));
    const std::vector<Contact> contacts = copied(all.contacts(scene.step()));
    const std::vector<NearPair> near = copied(all.pairs_within(scene.end, kNear));
    const std::vector<Intersection> intersections = copied(all.intersections(scene.end));
    for (const int number : {2, 3}) {
      const Rings rings(mesh, number);
      Detector some = yardstick::make_detector(mesh, with_rings(method, number));
      const std::vector<Contact> far = far_apart(contacts, rings);
      EXPECT_EQ(bits_of(some.contacts(scene.step())), bits_of(far));
      EXPECT_EQ(some.is_free(scene.step()), far.empty());
      const EarliestContact first = some.earliest(scene.step());
      ASSERT_EQ(first.contact.has_value(), !far.empty());
      for (const Contact& c : far) EXPECT_LE(first.toi_lower, c.toi_upper);
      if (first.contact) {
        EXPECT_FALSE(far_apart(std::vector{*first.contact}, rings).empty());
      }
      EXPECT_EQ(names(some.pairs_within(scene.end, kNear)), names(std::span<const NearPair>(far_apart(near, rings))));
      const auto through = far_apart(
          intersections, rings, [](const Intersection& i) { return std::span<const Index>(i.edge); },
          [](const Intersection& i) { return std::span<const Index>(i.face); });
      EXPECT_EQ(some.intersections(scene.end).size(), through.size());
      EXPECT_EQ(some.has_intersection(scene.end), !through.empty());
      left_out +=
          contacts.size() - far.size() + near.size() - names(std::span<const NearPair>(far_apart(near, rings))).size();
    }
  }
  const bool is_connected = mesh.edges().size() < 3 * mesh.faces().size();
  if (GetParam().scales && is_connected) {
    EXPECT_GT(left_out, 0u);
  }
}

// Bugs: a neighbour ends the step, or nothing ends it because the first pair was a neighbour.
TEST_P(RingsOf, StepLengthsAreThoseOfEveryPair) {
  for (const int number : {1, 2, 3}) {
    const SafeStep truth =
        yardstick::make_detector(scene.mesh(), with_rings(Method::brute, number)).safe_step(scene.step(), 0.2);
    yardstick::Options options = with_rings(Method::tamis, number);
    options.threads = 2;
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    const SafeStep found = detector.safe_step(scene.step(), 0.2);
    EXPECT_EQ(found.toi_lower, truth.toi_lower);
    EXPECT_EQ(found.toi_upper, truth.toi_upper);
    const TruncatedStep to = detector.truncate(scene.step(), 0.2);
    EXPECT_EQ(to.is_free, detector.is_free({scene.start, scene.start}));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RingsOf, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

// Bug: a number of rings below one is accepted.
TEST(RingsFilter, IsOneOrMore) {
  const Mesh mesh(3, {{0, 1, 2}});
  for (const int rings : {0, -1})
    EXPECT_THROW(yardstick::make_detector(mesh, with_rings(Method::tamis, rings)), InvalidOptions);
}

/// With one thread: with more, the size of buffers depends on which threads got work.
std::uint64_t memory_of(const Scene& scene, Options options) {
  options.threads = 1;
  Detector detector(scene.mesh(), options);
  (void)detector.is_free({scene.start, scene.start});
  return detector.statistics().memory_bytes;
}

// Bug: the memory that a detector reports lacks that of neighbours, groups and radii.
TEST(Memory, NeighboursGroupsAndRadiiCount) {
  const Scene scene = scenes::scene_by_name("folded-cloth", 3000, 3);
  const auto vertices = static_cast<std::size_t>(scene.vertex_count());
  const std::uint64_t plain = memory_of(scene, {});
  Options options;
  options.filter.rings = 2;
  EXPECT_GE(memory_of(scene, options), plain + 2 * sizeof(Index) * scene.mesh().edges().size());
  options.filter.rings = 1;
  options.filter.group_of_vertex.assign(vertices, 0);
  EXPECT_GE(memory_of(scene, options), plain + sizeof(Index) * vertices);
  options.radii = {1e-6};
  EXPECT_GE(memory_of(scene, options), plain + (sizeof(Index) + sizeof(double)) * vertices);
}

}  // namespace
}  // namespace tamis::test
