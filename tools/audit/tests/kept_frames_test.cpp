#include "audit/kept_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tamis::audit {
namespace {

constexpr std::size_t kVertices = 1000;
constexpr std::size_t kOneFrame = 2 * kVertices * sizeof(Point) + sizeof(FrameFindings);

FrameFindings frame(std::int64_t number, bool is_bad) {
  const auto positions = std::make_shared<const Frame>(Frame{"", std::vector<Point>(kVertices), nullptr});
  FrameFindings findings{number, positions, positions, {}, {}, {}, {}, {}};
  findings.answer.counts[0] = is_bad ? 1 : 0;
  return findings;
}

std::vector<std::int64_t> kept(std::size_t room, std::int64_t frames, std::int64_t bad_every) {
  KeptFrames keeper(room * kOneFrame);
  for (std::int64_t i = 0; i < frames; ++i) keeper.add(frame(i, i % bad_every == bad_every - 1));
  std::vector<std::int64_t> numbers;
  for (const FrameFindings& f : keeper.frames()) numbers.push_back(f.number);
  return numbers;
}

TEST(KeptFrames, AllWhereTheyFit) { EXPECT_EQ(kept(5, 5, 100), (std::vector<std::int64_t>{0, 1, 2, 3, 4})); }

// Bug: free frames take the room of bad ones; memory grows with the length of the motion.
TEST(KeptFrames, FreeOnesMakeRoom) {
  const auto numbers = kept(10, 1000, 250);
  EXPECT_LE(numbers.size(), 10u);
  for (const std::int64_t bad : {249, 499, 749, 999})
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), bad), 1) << bad;
  EXPECT_EQ(numbers.front(), 0);
  EXPECT_GE(numbers.size(), 6u) << "room is left unused";
}

TEST(KeptFrames, OfTooManyBadOnesTheFirst) {
  EXPECT_EQ(kept(4, 100, 1), (std::vector<std::int64_t>{0, 1, 2, 3}));
  EXPECT_TRUE(kept(0, 100, 1).empty());
}

}  // namespace
}  // namespace tamis::audit
