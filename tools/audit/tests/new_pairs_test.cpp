#include "audit/new_pairs.hpp"

#include <gtest/gtest.h>

namespace tamis::audit {
namespace {

std::shared_ptr<const AuditedMesh> mesh() { return std::make_shared<const AuditedMesh>(Mesh(3, {{0, 1, 2}})); }

Finding contact(Index vertex, double toi_lower) {
  return {0, Kind::vertex_face, {vertex, 0, 1, 2, -1}, toi_lower, toi_lower, {0, 0}, 1, false};
}

Finding intersection(Index vertex) { return {0, Kind::edge_face, {vertex, 4, 0, 1, 2}, 1, 1, {0, 0}, 1, false}; }

/// Frames one after the other, each with the pairs that are given.
class Motion {
 public:
  std::vector<bool> add(std::vector<Finding> pairs, bool has_step = true, const std::string& problem = {}) {
    FrameFindings findings{0, nullptr, std::make_shared<const Frame>(Frame{"", {}, mesh_}), {}, {}, {}, {}, {}};
    findings.answer.has_step = has_step;
    findings.answer.problem = problem;
    findings.pairs = std::move(pairs);
    new_pairs_.mark(findings);
    std::uint64_t fresh = 0;
    for (const Finding& pair : findings.pairs) fresh += pair.is_new ? 1 : 0;
    EXPECT_EQ(findings.answer.fresh, fresh);
    return findings.is_new;
  }
  void change_topology() { mesh_ = mesh(); }

 private:
  std::shared_ptr<const AuditedMesh> mesh_ = mesh();
  NewPairs new_pairs_;
};

using Marks = std::vector<bool>;

// Bug: pairs that last are called new again and again, or those of the first frame are.
TEST(NewPairs, OfTheFirstFrameNoneIsAndThenThoseThatTheFrameBeforeDoesNotHave) {
  Motion motion;
  EXPECT_EQ(motion.add({intersection(7)}, false), (Marks{false}));
  EXPECT_EQ(motion.add({intersection(7), intersection(8)}), (Marks{false, true}));
  EXPECT_EQ(motion.add({intersection(8), intersection(7)}), (Marks{false, false}));
  EXPECT_EQ(motion.add({}), (Marks{}));
  EXPECT_EQ(motion.add({intersection(7)}), (Marks{true}));
}

// Bug: pairs that touch in every frame are new in the first step, as no step leads to the frame before.
TEST(NewPairs, InTheFirstStepOnlyContactsAfterItsStartAre) {
  Motion motion;
  motion.add({}, false);
  EXPECT_EQ(motion.add({contact(5, 0), contact(6, 0.25)}), (Marks{false, true}));
  EXPECT_EQ(motion.add({contact(5, 0), contact(6, 0), contact(7, 0)}), (Marks{false, false, true}));
}

// Bug: after a broken frame all pairs are new; after a change of topology, vertices of one mesh stand for another's.
TEST(NewPairs, AreComparedWithTheLastFrameOfTheSameTopology) {
  Motion motion;
  motion.add({intersection(7)}, false);
  motion.add({}, false, "the file ends here");
  EXPECT_EQ(motion.add({intersection(7)}, false), (Marks{false}));
  motion.change_topology();
  EXPECT_EQ(motion.add({intersection(7)}, false), (Marks{true}));
}

}  // namespace
}  // namespace tamis::audit
