// Many features in one place: every pair touches at the start. Would catch: questions that store all contacts although
// one decides the answer, and a search that goes on when nothing can change the answer any more.
#include <gtest/gtest.h>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

/// Triangles without common vertices, all in one place. They move by one triangle's length.
scenes::Scene pile_of(Index triangles) {
  scenes::Scene pile;
  for (Index f = 0; f < triangles; ++f) {
    for (const Point& corner : {Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}})
      pile.add_vertex(corner, {corner[0] + 1, corner[1], 0}, f);
    pile.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return pile;
}

class Coincident : public testing::TestWithParam<Method> {
 protected:
  Coincident() { options.method = GetParam(); }
  yardstick::Options options;
};

TEST_P(Coincident, TheFirstOfMillionsOfContactsNeedsLittleMemoryAndFewDecisions) {
  const Index triangles = GetParam() == Method::brute ? 100 : 600;
  const scenes::Scene pile = pile_of(triangles);
  const auto contacts =
      std::uint64_t(triangles) * static_cast<std::uint64_t>(triangles - 1) * 15 / 2;  // 9 ee / 2, 3 vf
  Detector detector = yardstick::make_detector(pile.mesh(), options);
  EXPECT_FALSE(detector.is_free(pile.step()));
  const auto decided = [&] {
    const PrecisionCount& by = detector.statistics().decided_by;
    return by.scalar + by.exact;
  };
  EXPECT_LE(decided(), 1024u) << "is_free went on after a contact";
  EXPECT_LE(detector.statistics().memory_bytes, contacts * sizeof(Contact) / 8);
  const EarliestContact first = detector.earliest(pile.step());
  EXPECT_EQ(first.toi_lower, 0);
  EXPECT_LE(detector.statistics().memory_bytes, contacts * sizeof(Contact) / 8);
  EXPECT_EQ(first.toi_upper, 0);
  EXPECT_LE(decided(), contacts / 16) << "what comes behind a pair that touches at the start was decided";
  ASSERT_TRUE(first.contact);
  EXPECT_EQ(first.contact->kind, PairKind::vertex_face);
  EXPECT_EQ(first.contact->vertices, (std::array<Index, 4>{0, 3, 4, 5}));
}

TEST_P(Coincident, AllMethodsAndThreadsNameTheSameFirstContact) {
  const scenes::Scene pile = pile_of(40);
  for (const int threads : {1, 4}) {
    options.threads = threads;
    const EarliestContact first = yardstick::make_detector(pile.mesh(), options).earliest(pile.step());
    ASSERT_TRUE(first.contact);
    EXPECT_EQ(first.contact->vertices, (std::array<Index, 4>{0, 3, 4, 5}));
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Coincident, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

}  // namespace
}  // namespace tamis::test
