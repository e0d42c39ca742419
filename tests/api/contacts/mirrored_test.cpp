// Exact symmetry: mirrored bodies with dyadic coordinates whose contacts all lie on symmetry planes. Plain floating
// point loses 2 to 10 % of these contacts; no method may lose one.
#include <gtest/gtest.h>

#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"

namespace tamis::test {
namespace {

struct MirroredScene {
  const char* name;
  Index triangles;
};

class Mirrored : public testing::TestWithParam<MirroredScene> {};

TEST_P(Mirrored, NoMethodMissesAContactOnASymmetryPlane) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const scenes::Scene scene = scenes::scene_by_name(GetParam().name, GetParam().triangles, seed);
    const PairSet truth = oracle_contacts(scene);
    EXPECT_GT(truth.size(), 100u) << "the scene does not touch";
    for (const Method method : kMethods) {
      yardstick::Options options;
      options.method = method;
      EXPECT_EQ(missing(truth, find_names(scene, options)), "") << "missed by " << name_of(method) << ", seed " << seed;
      EXPECT_EQ(missing(find_names(scene, options), truth), "") << "made up by " << name_of(method);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Mirrored,
                         testing::Values(MirroredScene{"touching-spheres", 400}, MirroredScene{"mirrored", 50}),
                         [](const testing::TestParamInfo<MirroredScene>& scene) {
                           return test_name(scene.param.name);
                         });

}  // namespace
}  // namespace tamis::test
