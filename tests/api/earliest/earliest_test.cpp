// Compares earliest and is_free with all contacts and the oracle. Both stop early and prune by time: pruning too much
// would miss a contact.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/flat_sheets.hpp"
#include "support/shortened.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

void check_questions(const Scene& scene, const yardstick::Options& options) {
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  const std::vector<Contact> contacts = copied(detector.contacts(scene.step()));
  EXPECT_EQ(detector.is_free(scene.step()), contacts.empty());
  const EarliestContact earliest = detector.earliest(scene.step());
  ASSERT_EQ(earliest.contact.has_value(), !contacts.empty());
  ASSERT_LE(0, earliest.toi_lower);
  ASSERT_LE(earliest.toi_lower, earliest.toi_upper);
  ASSERT_LE(earliest.toi_upper, 1);
  if (contacts.empty()) {
    EXPECT_EQ(earliest.toi_lower, 1);
    return;
  }
  EXPECT_TRUE(names_of(contacts).contains({earliest.contact->kind, earliest.contact->vertices}));

  double first_lower = 1, first_upper = 1;
  for (const Contact& c : contacts) {
    first_lower = std::min(first_lower, c.toi_lower);
    first_upper = std::min(first_upper, c.toi_upper);
    if (c.toi_lower < earliest.toi_lower) {
      EXPECT_FALSE(oracle::touches(c.kind, motion_of(scene, c.vertices), {0, earliest.toi_lower, true}))
          << "free until " << earliest.toi_lower << ", it says, but one touches from " << c.toi_lower;
    }
  }
  constexpr double kCrowd = 0x1p-37;  // a crowd counts as touching from the beginning of a time so long
  EXPECT_GE(earliest.toi_lower, first_lower * (1 - kCrowd)) << "not that of any contact";
  EXPECT_LE(earliest.toi_lower, first_lower) << "beyond a contact";
  EXPECT_GE(earliest.toi_upper, first_lower);
  EXPECT_NEAR(earliest.toi_upper, first_upper, 1e-9);
}

class Questions : public testing::TestWithParam<Recipe> {};

TEST_P(Questions, EarliestAndFreeAgreeWithAllContacts) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = GetParam().make(150, 12 + seed);
    for (const double part : {1.0, 0.125, 0.0}) {
      SCOPED_TRACE(scene.name + ", seed " + std::to_string(12 + seed) + ", part " + std::to_string(part));
      check_questions(shortened(scene, part), {});
    }
  }
}

TEST_P(Questions, ThreadsChangeNoBitOfTheEarliestContact) {
  const Scene scene = GetParam().make(GetParam().scales ? 5000 : 400, 31);
  yardstick::Options options;
  options.threads = 1;
  const EarliestContact one = yardstick::make_detector(scene.mesh(), options).earliest(scene.step());
  options.threads = 2;
  for (int repetition = 0; repetition < 3; ++repetition) {
    const EarliestContact two = yardstick::make_detector(scene.mesh(), options).earliest(scene.step());
    EXPECT_EQ(one.toi_lower, two.toi_lower);
    EXPECT_EQ(one.toi_upper, two.toi_upper);
    ASSERT_EQ(one.contact.has_value(), two.contact.has_value());
    if (one.contact) {
      EXPECT_EQ(one.contact->vertices, two.contact->vertices);
    }
  }
}

// Bug: pairs that all touch at one time were decided in integers twice. A flat sheet that falls on another one touches
// it everywhere at once.
TEST(Earliest, DecidesPairsThatTouchAtOneTimeOnce) {
  const Scene scene = flat_sheets(8, 1, 0);
  Detector detector(scene.mesh());
  EXPECT_GT(detector.contacts(scene.step()).size(), 100u);
  const std::uint64_t of_all = detector.statistics().decided_by.exact;
  EXPECT_GT(of_all, 100u);
  EXPECT_TRUE(detector.earliest(scene.step()).contact);
  EXPECT_LE(detector.statistics().decided_by.exact, of_all);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Questions, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
