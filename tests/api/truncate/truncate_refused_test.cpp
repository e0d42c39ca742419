// Truncation refuses steps that cannot be stored as floats, and invalid fractions.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "api/truncate/truncated.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

/// The message that refuses to truncate the scene's step to floats; empty if it is not refused.
std::string refusal(const Scene& scene) {
  try {
    (void)Detector(scene.mesh()).truncate(scene.step(), 0.1, {}, StoredType::float32);
  } catch (const InvalidStep& error) {
    return error.what();
  }
  return "";
}

TEST(Truncate, RefusesAStartThatIsNoFloatAndAnEndBeyondAll) {
  Scene scene = two_falls(1, 0.1);
  scene.start = as_floats(scene.start);
  scene.start[3][2] = 0.1;
  EXPECT_NE(refusal(scene).find("vertex 3 at the start of the step has the coordinate 0.1, which is not float32"),
            std::string::npos)
      << refusal(scene);
  scene.start[3][2] = 1;
  scene.end[1][0] = 1e39;
  EXPECT_NE(refusal(scene).find("vertex 1 at the end of the step"), std::string::npos) << refusal(scene);
  scene.end[1][0] = 1;
  EXPECT_EQ(refusal(scene), "");
}

TEST(Truncate, RefusesFractionsThatAreNone) {
  const Scene scene = two_falls(0.5, 1);
  Detector detector(scene.mesh());
  for (const double fraction : {0.0, -0.1, 1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW((void)detector.truncate(scene.step(), fraction), InvalidOptions) << fraction;
  EXPECT_THROW((void)detector.truncate(scene.step(), 0.1, {.min_separation = -1.0}), InvalidOptions);
}

}  // namespace
}  // namespace tamis::test
