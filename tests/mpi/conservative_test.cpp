// The guarantee `conservative`, where pairs that doubles cannot decide may be unresolved on one number of ranks and
// proven free on another: what is promised nevertheless.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "mpi/same_answers.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;
using Keys = std::set<std::tuple<PairKind, std::array<Index, 4>>>;

std::vector<Contact> certified_of(std::vector<Contact> contacts) {
  std::erase_if(contacts, [](const Contact& c) { return c.certainty != Certainty::certified; });
  return contacts;
}

Keys keys_of(const std::vector<Contact>& contacts) {
  Keys keys;
  for (const Contact& c : contacts) keys.insert({c.kind, c.vertices});
  return keys;
}

bool has_all(const Keys& all, const Keys& some) { return std::ranges::includes(all, some); }

class Conservative : public testing::TestWithParam<Recipe> {
 protected:
  const Scene scene_ = GetParam().make(200, 1);

  /// Collective. Would catch a pair that a rank leaves out because another one could not decide it.
  void expect_what_is_promised(double min_separation) {
    Options options = one_thread();
    options.min_separation = min_separation;
    Detector exact(scene_.mesh(), options);
    options.guarantee = Guarantee::conservative;
    Detector one(scene_.mesh(), options);
    const auto touching = exact.contacts(scene_.step()), of_one = one.contacts(scene_.step());
    const EarliestContact first = exact.earliest(scene_.step());
    const double safe = exact.keep_distance(scene_.step(), 0.1).lower;
    for (const Cut& cut : cuts()) {
      const Part part = part_of(scene_, cut);
      distributed::Detector many(MPI_COMM_WORLD, part.mesh, options);
      many.contacts(part.step());
      const auto found = many.gather_contacts(0);
      if (rank_of() == 0) {
        expect_same(certified_of(of_one), certified_of(found), cut.name);
        EXPECT_TRUE(has_all(keys_of(found), keys_of(touching))) << cut.name << ": a touching pair is missed";
      }
      EXPECT_LE(many.earliest(part.step()).toi_lower, first.toi_upper) << cut.name;
      EXPECT_FALSE(many.is_free(part.step()) && !touching.empty()) << cut.name;
      EXPECT_EQ(many.keep_distance(part.step(), 0.1).lower, safe) << cut.name << ": the guarantee matters for 0 only";
    }
  }
};

TEST_P(Conservative, TouchingPairsAreNeverMissedAndCertifiedOnesAreThoseOfOneProcess) { expect_what_is_promised(0); }
TEST_P(Conservative, WithASeparationToo) { expect_what_is_promised(1e-3); }

INSTANTIATE_TEST_SUITE_P(Scenes, Conservative, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
