// The answer must not depend on the number of threads, the instruction set, the unit of length, the order of vertices,
// mirroring, or earlier questions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "scenes/random.hpp"
#include "search/topology/mean_edge.hpp"
#include "support/contact_bits.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/every_question.hpp"
#include "support/kernels_here.hpp"
#include "support/shortened.hpp"
#include "support/test_names.hpp"
#include "support/threads.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Random, scenes::Recipe, scenes::Scene;

void expect_same_bits(std::span<const Contact> a, std::span<const Contact> b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(bits_of(a[i]), bits_of(b[i])) << what << ", contact " << i;
}

class Invariance : public testing::TestWithParam<Recipe> {
 protected:
  Scene scene(Index triangles, std::uint64_t seed) const { return GetParam().make(triangles, seed); }
};

// Bugs: an answer that depends on the thread that found it, on which part of a shared loop came first, or on the parts.
TEST_P(Invariance, AnyNumberOfThreadsGivesTheSameBitsOfEveryQuestion) {
  constexpr int kThreads = 5;
  const AllowedThreads allowed(kThreads);
  EnginePool pool(kThreads - 1);
  // So many vertices, blocks and pairs that threads share all loops.
  const Scene whole = scene(GetParam().scales ? 20000 : 800, 5);
  const double distance = 0.1 * mean_edge(whole.mesh(), whole.start);
  Detector one(whole.mesh(), {.threads = 1}), many(whole.mesh(), {.threads = kThreads});
  Detector lent(whole.mesh(), {.threads = kThreads, .parallel_for = pool.lend()});
  for (const double part : {1.0, 0.5, 0.25}) {
    const Scene s = shortened(whole, part);
    for (const AnyQuestion& question : questions_of(s, distance)) {
      const auto expected = question.ask(one);
      EXPECT_EQ(question.ask(many), expected) << question.name << " to " << part;
      EXPECT_EQ(question.ask(lent), expected) << question.name << " to " << part << ", lent threads";
      EXPECT_EQ(many.statistics().threads, has_threads() ? kThreads : 1);
      EXPECT_EQ(lent.statistics().threads, kThreads);
    }
  }
}

TEST_P(Invariance, InstructionSetsGiveTheSameBits) {
  const Scene s = scene(600, 6);
  Options options;
  options.isa = Isa::baseline;
  const auto baseline = find_contacts(s, options);
  for (Isa isa : every_isa()) {
    options.isa = isa;
    try {
      expect_same_bits(baseline, find_contacts(s, options), std::string(name_of(isa)));
    } catch (const InvalidOptions&) {
      GTEST_SKIP() << "this machine has no " << name_of(isa);
    }
  }
}

TEST_P(Invariance, EarlierQuestionsDoNotChangeTheAnswer) {
  const Scene s = scene(300, 7);
  Detector used(s.mesh());
  (void)used.contacts({s.end, s.start});
  (void)used.contacts({s.end, s.end});
  expect_same_bits(contacts_of(Detector(s.mesh()), s.step()), used.contacts(s.step()), "refitted");
}

TEST_P(Invariance, ContactsComeInTheirDocumentedOrder) {
  const Scene s = scene(300, 8);
  Detector detector(s.mesh());
  const auto& contacts = detector.contacts(s.step());
  EXPECT_TRUE(std::is_sorted(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.vertices < b.vertices;
  }));
}

TEST_P(Invariance, PowersOfTwoAsUnitOfLengthChangeNoDecision) {
  const Scene s = scene(100, 9);
  const auto reference = find_contacts(s, {});
  for (int exponent : {-200, -100, -30, 30, 100, 200}) {
    Scene scaled = s;
    for (auto* points : {&scaled.start, &scaled.end})
      for (Point& p : *points)
        for (double& x : p) x = std::ldexp(x, exponent);
    EXPECT_EQ(names_of(reference), names_of(find_contacts(scaled, {}))) << exponent;
  }
}

/// Renames vertex v to order[v] in a pair, and puts the vertices into the order that contacts have.
PairName renamed(PairName name, const std::vector<Index>& order) {
  auto& v = name.vertices;
  for (Index& index : v)
    if (index >= 0) index = order[static_cast<std::size_t>(index)];
  if (name.kind == PairKind::vertex_face) {
    std::sort(v.begin() + 1, v.end());  // faces are compared as sets, because shuffled() changes windings
  } else if (name.kind == PairKind::vertex_edge) {
    std::sort(v.begin() + 1, v.begin() + 3);
  } else if (name.kind == PairKind::vertex_vertex) {
    std::sort(v.begin(), v.begin() + 2);
  } else {
    std::sort(v.begin(), v.begin() + 2);
    std::sort(v.begin() + 2, v.end());
    if (std::array{v[2], v[3]} < std::array{v[0], v[1]}) std::swap(v[0], v[2]), std::swap(v[1], v[3]);
  }
  return name;
}

PairSet renamed(const PairSet& names, const std::vector<Index>& order) {
  PairSet result;
  for (const PairName& name : names) result.insert(renamed(name, order));
  return result;
}

/// Vertices renumbered, faces in another order and each with another winding, y and z exchanged, x mirrored.
Scene shuffled(const Scene& s, const std::vector<Index>& order, Random& random) {
  Scene result = s;
  for (std::size_t v = 0; v < order.size(); ++v) {
    const auto turned = [](const Point& p) { return Point{-p[0], p[2], p[1]}; };
    result.start[static_cast<std::size_t>(order[v])] = turned(s.start[v]);
    result.end[static_cast<std::size_t>(order[v])] = turned(s.end[v]);
  }
  const auto rename = [&](Index& v) { v = order[static_cast<std::size_t>(v)]; };
  for (Face& f : result.faces) {
    for (Index& v : f) rename(v);
    std::rotate(f.begin(), f.begin() + random.below(3), f.end());
    if (random.coin()) std::swap(f[0], f[1]);
  }
  for (Edge& e : result.loose_edges)
    for (Index& v : e) rename(v);
  for (Index& v : result.loose_points) rename(v);
  std::reverse(result.faces.begin(), result.faces.end());
  return result;
}

TEST_P(Invariance, OrderWindingAndMirrorChangeNoExactAnswer) {
  const Scene s = scene(120, 10);
  Random random(11);
  std::vector<Index> same(s.start.size());
  std::iota(same.begin(), same.end(), 0);
  std::vector<Index> order = same;
  for (std::size_t i = order.size(); i-- > 1;)
    std::swap(order[i], order[static_cast<std::size_t>(random.below(static_cast<Index>(i) + 1))]);
  const Scene other = shuffled(s, order, random);
  EXPECT_EQ(renamed(find_names(s, {}), order), renamed(find_names(other, {}), same));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Invariance, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
