// Compares the library and the yardstick with each other and with the oracle, on over two hundred generated meshes.
// Each difference is a contact that one of them misses or makes up.
#include <gtest/gtest.h>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

yardstick::Options method(Method m) {
  yardstick::Options options;
  options.method = m;
  return options;
}

std::string label(const Scene& scene, std::uint64_t seed) {
  return scene.name + " of " + std::to_string(scene.faces.size()) + " triangles, seed " + std::to_string(seed);
}

class Agreement : public testing::TestWithParam<Recipe> {};

TEST_P(Agreement, SmallMeshesAgreeWithTheOracle) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene scene = GetParam().make(4 + 2 * static_cast<Index>(seed), seed);
    const PairSet truth = oracle_contacts(scene);
    for (const Method m : kMethods) {
      const auto contacts = find_contacts(scene, method(m));
      const std::string where = std::string(name_of(m)) + " on " + label(scene, seed);
      EXPECT_EQ(missing(truth, names_of(contacts)), "") << "missed by " << where;
      EXPECT_EQ(missing(names_of(contacts), truth), "") << "made up by " << where;
      EXPECT_EQ(certified_names_of(contacts), truth) << "not certified by " << where;
    }
  }
}

TEST_P(Agreement, FindsTheSetOfAllPairs) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Scene scene = GetParam().make(60 + 40 * static_cast<Index>(seed), 100 + seed);
    const auto brute = find_contacts(scene, method(Method::brute));
    const auto found = find_contacts(scene, method(Method::tamis));
    const std::string where = label(scene, seed);
    EXPECT_EQ(missing(names_of(brute), names_of(found)), "") << "missed on " << where;
    EXPECT_EQ(missing(names_of(found), names_of(brute)), "") << "made up on " << where;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
