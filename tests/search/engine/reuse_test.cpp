// One detector over many steps: it refits, rebuilds when that pays, answers as a new one would, and once warm takes no
// more memory.
#include <gtest/gtest.h>

#include <atomic>

#include "scenes/scene_list.hpp"
#include "support/contact_bits.hpp"
#include "support/own_memory.hpp"
#include "tamis/tamis.hpp"

namespace tamis::test {
namespace {

std::atomic<long> g_allocations{0};

}  // namespace

void on_allocation() { ++g_allocations; }

namespace {

using scenes::Scene;

/// The same mesh, crumpled more and more: from refit to refit the old order gets poorer.
std::vector<Point> crumpled(const std::vector<Point>& points, double amount) {
  std::vector<Point> moved = points;
  for (std::size_t i = 0; i < moved.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) moved[i][k] += amount * double((i * 7919 + k * 104729) % 1000) / 1000;
  return moved;
}

TEST(Reuse, AnswersAsANewDetectorWould) {
  // Would catch a box, an order or a buffer left over from the step before.
  const Scene scene = scenes::scene_by_name("folded-cloth", 2000, 1);
  Detector kept(scene.mesh());
  for (double amount : {0.0, 0.01, 0.3, 0.0, 0.05}) {
    const auto start = crumpled(scene.start, amount), end = crumpled(scene.end, amount);
    Detector fresh(scene.mesh());
    EXPECT_EQ(bits_of(kept.contacts({start, end})), bits_of(fresh.contacts({start, end}))) << amount;
    EXPECT_EQ(kept.earliest({start, end}).toi_lower, fresh.earliest({start, end}).toi_lower) << amount;
    EXPECT_EQ(kept.is_free({start, end}), fresh.is_free({start, end})) << amount;
  }
}

TEST(Reuse, RefitsWhileTheOrderIsGoodAndRebuildsWhenItIsPoor) {
  // Would catch a detector that always builds, and one that never does.
  const Scene scene = scenes::scene_by_name("folded-cloth", 2000, 1);
  Detector detector(scene.mesh());
  (void)detector.contacts(scene.step());
  EXPECT_TRUE(detector.statistics().rebuilt);
  (void)detector.contacts(scene.step());
  EXPECT_FALSE(detector.statistics().rebuilt);
  // Every vertex goes elsewhere: neighbours in the old order are far apart.
  std::vector<Point> start = scene.start, end = scene.end;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const std::size_t other = (i * 7919) % start.size();
    start[i] = scene.start[other];
    end[i] = scene.end[other];
  }
  (void)detector.is_free({start, end});
  EXPECT_TRUE(detector.statistics().rebuilt);
}

/// Steps that part all neighbours, each in another way.
class LongStep : public testing::Test {
 protected:
  Step far(std::size_t way, double reach = 10) {
    end_ = scene_.start;
    for (std::size_t i = 0; i < end_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) end_[i][k] += reach * double(((i + k) * 7919 + way * 101) % 1000) / 1000;
    return {scene_.start, end_};
  }

  const Scene scene_ = scenes::scene_by_name("folded-cloth", 2000, 1);

 private:
  std::vector<Point> end_;
};

TEST_F(LongStep, SpoilsNothingForThoseAfterIt) {
  // Would catch an order by how far features go that is kept: what it sweeps over later is less, however poor it is.
  Detector kept(scene_.mesh()), fresh(scene_.mesh());
  // And one that is given up before it has cost what another one would.
  constexpr double kNear = 0.01;
  (void)kept.is_free(far(0));
  (void)fresh.contacts(far(1, kNear));
  const auto few = fresh.statistics().nodes_visited;
  std::size_t poor = 0;
  for ((void)kept.contacts(far(1, kNear)); !kept.statistics().rebuilt && poor < 10;
       (void)kept.contacts(far(1 + ++poor, kNear)))
    EXPECT_GT(kept.statistics().nodes_visited, 2 * few) << poor;
  EXPECT_GE(poor, 2u);
  EXPECT_LE(poor, 6u);
  EXPECT_LE(kept.statistics().nodes_visited, few + few / 8);
  (void)kept.contacts(far(20, kNear));
  EXPECT_FALSE(kept.statistics().rebuilt);
}

TEST_F(LongStep, IsSearchedInAnOrderOfItsStartByWhatAsksAboutThatAlone) {
  // Would catch questions that take turns and build anew each time; and one that has the other's order for ever.
  Detector kept(scene_.mesh());
  for (std::size_t way = 0; way < 4; ++way) {
    (void)kept.is_free(far(way));
    EXPECT_EQ(kept.statistics().rebuilt, way == 0);
    (void)kept.earliest(far(way));
    EXPECT_FALSE(kept.statistics().rebuilt);
  }
  const auto poor = kept.statistics().nodes_visited;
  int rebuilt = 0;
  for (std::size_t way = 4; way < 12; ++way) {
    (void)kept.earliest(far(way));
    rebuilt += kept.statistics().rebuilt;
  }
  EXPECT_EQ(rebuilt, 1);
  EXPECT_LT(kept.statistics().nodes_visited, poor);
  (void)kept.is_free(far(12));
  EXPECT_TRUE(kept.statistics().rebuilt) << "a whole step is searched in the order of its start";
}

TEST(Reuse, AWarmDetectorAllocatesNothing) {
  // Would catch a buffer made anew each step.
  const Scene scene = scenes::scene_by_name("folded-cloth", 5000, 1);
  Options options;
  options.threads = 1;
  Detector detector(scene.mesh(), options);
  // Buffers swap places, and what is remembered of the same step has settled by then.
  for (int i = 0; i < 8; ++i) (void)detector.contacts(scene.step());
  const long before = g_allocations;
  (void)detector.contacts(scene.step());
  // The names of the stages are the answer's own.
  EXPECT_LE(g_allocations - before, 1);
}

}  // namespace
}  // namespace tamis::test
