// Would catch: a kernel that reads or writes outside its arrays, as lanes of empty features once did (vertex -1), and
// compressed stores past the padding. Every array of a kernel lies against a forbidden page.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "scenes/random.hpp"
#include "search/kernels/kernels.hpp"
#include "support/guarded.hpp"
#include "support/kernels_here.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis {
namespace {

using test::Guard;
using test::Guarded;

struct Soup {
  std::vector<Index> points;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<Point> start, end;
};

/// Triangles without a common vertex, close enough for all to meet.
Soup soup_of(int triangles) {
  scenes::Random random(static_cast<std::uint64_t>(triangles));
  Soup soup;
  for (Index f = 0; f < triangles; ++f) {
    const Index v = 3 * f;
    soup.faces.push_back({v, v + 1, v + 2});
    for (const Edge& edge : {Edge{v, v + 1}, Edge{v, v + 2}, Edge{v + 1, v + 2}}) soup.edges.push_back(edge);
    for (Index c = 0; c < 3; ++c) {
      soup.points.push_back(v + c);
      for (auto* positions : {&soup.start, &soup.end}) positions->push_back(random.point_between(-1, 1));
    }
  }
  return soup;
}

/// A tree's arrays, each against a forbidden page.
class GuardedTree {
 public:
  GuardedTree(const BlockTree& tree, Guard guard) : view_(tree.view()) {
    std::size_t blocks = static_cast<std::size_t>(view_.leaf_blocks);
    corners_ = std::make_unique<Guarded<CornerBlock>>(std::span(view_.corners, blocks), guard);
    view_.corners = corners_->data();
    for (int level = 0; level < view_.level_count; ++level) {
      levels_.emplace_back(std::span(view_.levels[level], blocks), guard);
      view_.levels[level] = levels_.back().data();
      residuals_.emplace_back(std::span(view_.residuals[level], blocks), guard);
      view_.residuals[level] = residuals_.back().data();
      groups_.emplace_back(std::span(view_.groups.of[level], blocks), guard);
      view_.groups.of[level] = groups_.back().data();
      blocks = (blocks + kBlock - 1) / kBlock;
    }
  }
  const TreeView& view() const { return view_; }

 private:
  TreeView view_;
  std::unique_ptr<Guarded<CornerBlock>> corners_;
  std::deque<Guarded<BoxBlock>> levels_, residuals_;
  std::deque<Guarded<Index>> groups_;
};

/// The lists that a kernel decides a buffer into.
class GuardedDecisions {
 public:
  explicit GuardedDecisions(Guard guard)
      : touching_(std::vector<TouchingPair>(PairBuffer::kCapacity), guard),
        undecided_(std::vector<std::int32_t>(PairBuffer::kCapacity), guard) {}
  LaneDecisions lists() const { return {touching_.data(), undecided_.data()}; }

 private:
  const Guarded<TouchingPair> touching_;
  const Guarded<std::int32_t> undecided_;
};

/// Searches from every leaf block of search.a; pairs go to `pairs`.
void find(Search& search, void (*kernel)(Search&, int), PairBuffer& pairs) {
  search.pairs = &pairs;
  search.flush = [](Search&) { FAIL() << "the soup is too large for one buffer"; };
  for (int block = 0; block < search.a.leaf_blocks; ++block) kernel(search, block);
}

/// Numbers of pairs that the kernels leave after search, clip, filters and roots.
std::array<int, 4> run(const Kernels& kernels, PairKind kind, const GuardedTree& a, const GuardedTree& b,
                       const MotionView& motion, Guard guard) {
  const auto empty = std::make_unique<PairBuffer>();
  const Guarded<PairBuffer> boxes({empty.get(), 1}, guard), slab({empty.get(), 1}, guard),
      filtered({empty.get(), 1}, guard);
  const auto unused = std::make_unique<DecisionScratch>();
  const GuardedDecisions room(guard);
  LaneDecisions decisions = room.lists();
  const Guarded<DecisionScratch> scratch({unused.get(), 1}, guard);
  Search search{a.view(), b.view()};
  find(search, kernels.of(kind).search, *boxes.data());
  kernels.of(kind).slab(motion, *boxes.data(), *slab.data());
  kernels.of(kind).filter(motion, *slab.data(), *filtered.data());
  MotionView touching = motion;
  touching.separation = {};
  kernels.of(kind).decide(touching, 1, *filtered.data(), *scratch.data(), decisions);
  const int left = decisions.touching_count + decisions.undecided_count;
  return {boxes.data()->count, slab.data()->count, filtered.data()->count, left};
}

/// The search at rest: the number of pairs that it finds.
int run_at_rest(const Kernels& kernels, PairKind kind, const GuardedTree& a, const GuardedTree& b, Guard guard) {
  const auto empty = std::make_unique<PairBuffer>();
  const Guarded<PairBuffer> at_rest({empty.get(), 1}, guard);
  Search search{a.view(), b.view()};
  search.widened = 0x1p-10f;
  find(search, kernels.of(kind).search_at_rest, *at_rest.data());
  return at_rest.data()->count;
}

/// The kernels of step lengths: the number of pairs that the search finds, and of those that may end the step.
std::array<int, 2> run_near(const Kernels& kernels, PairKind kind, const GuardedTree& a, const GuardedTree& b,
                            const MotionView& motion, Guard guard) {
  const auto empty = std::make_unique<PairBuffer>();
  const Guarded<PairBuffer> boxes({empty.get(), 1}, guard), near({empty.get(), 1}, guard);
  Search search{a.view(), b.view()};
  search.keep = {0.25f, 1.5f, 1.0f, 10.0f, {2.25f, 0, 0, 1}};
  find(search, kernels.of(kind).search_step_ends, *boxes.data());
  const int found = boxes.data()->count;
  kernels.of(kind).may_end_step(motion, search.keep, *boxes.data(), *near.data());
  return {found, near.data()->count};
}

/// Each pair's place must be named once, or not at all.
void expect_each_once(const LaneDecisions& decisions, int pairs) {
  std::vector<std::int32_t> places(decisions.undecided, decisions.undecided + decisions.undecided_count);
  for (int i = 0; i < decisions.touching_count; ++i) places.push_back(decisions.touching[i].pair);
  std::ranges::sort(places);
  EXPECT_TRUE(std::ranges::adjacent_find(places) == places.end());
  EXPECT_TRUE(places.empty() || (0 <= places.front() && places.back() < pairs));
}

/// The kernel of pair lists.
void run_list(const Kernels& kernels, std::size_t kind, const PairBuffer& in, const Soup& soup, Guard guard) {
  const Guarded<Point> start(soup.start, guard), end(soup.end, guard);
  const StepRows vertices{start.data()->data(), end.data()->data(), 3, 3};
  const auto unused = std::make_unique<DecisionScratch>();
  for (const double min_separation : {0.0, 0.5}) {
    const GuardedDecisions room(guard);
    LaneDecisions decisions = room.lists();
    const Guarded<DecisionScratch> scratch({unused.get(), 1}, guard);
    kernels.of_kind[kind].decide_rows(vertices, min_separation, 1, in, *scratch.data(), decisions);
    expect_each_once(decisions, in.count);
  }
}

/// The kernels with a separation.
void run_within(const Kernels& kernels, std::size_t kind, const PairBuffer& pairs, MotionView motion, Guard guard) {
  const auto empty = std::make_unique<PairBuffer>();
  const auto unused = std::make_unique<DecisionScratch>();
  for (const float separation : {0x1p-20f, 0.5f}) {
    const Guarded<PairBuffer> in({&pairs, 1}, guard), left({empty.get(), 1}, guard);
    const Guarded<DecisionScratch> scratch({unused.get(), 1}, guard);
    const GuardedDecisions room(guard);
    LaneDecisions decisions = room.lists();
    motion.separation.fixed = motion.box_separation.fixed = separation;
    kernels.of_kind[kind].cull_apart(motion, *in.data(), *left.data());
    EXPECT_LE(left.data()->count, in.data()->count) << kind;
    EXPECT_LE(in.data()->count, pairs.count) << kind;
    kernels.of_kind[kind].decide(motion, 1, *left.data(), *scratch.data(), decisions);
    expect_each_once(decisions, left.data()->count);
    EXPECT_GT(separation < 0.5f ? 1 : decisions.touching_count, 0) << kind;
  }
}

/// The clips of the kinds that cannot cross, and distances at rest, for pairs of the soup's vertices in any order.
void run_other_kinds(const Kernels& kernels, const Soup& soup, MotionView motion, Guard guard) {
  const auto count = static_cast<int>(soup.start.size());
  const auto pairs = std::make_unique<PairBuffer>(), empty = std::make_unique<PairBuffer>();
  for (pairs->count = 0; pairs->count < count; ++pairs->count)
    for (int corner = 0; corner < 4; ++corner)
      pairs->corner[corner][pairs->count] = static_cast<std::int32_t>((corner + 3 * pairs->count) % count);
  for (int i = 0; i < count; ++i) pairs->t_out[i] = 1;
  const Guarded<PairBuffer> in({pairs.get(), 1}, guard);
  for (const auto slab : {kernels.of(PairKind::vertex_edge).slab, kernels.of(PairKind::vertex_vertex).slab}) {
    const Guarded<PairBuffer> out({empty.get(), 1}, guard);
    motion.box_separation.fixed = 4;
    slab(motion, *in.data(), *out.data());
    EXPECT_GT(out.data()->count, 0);
  }
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    const Guarded<PairBuffer> near({empty.get(), 1}, guard), unsure({empty.get(), 1}, guard);
    motion.separation.fixed = 8;
    kernels.of_kind[kind].find_within_at_rest(motion, *in.data(), *near.data(), *unsure.data());
    EXPECT_EQ(near.data()->count + unsure.data()->count, count) << kind;
    const Guarded<NearPair> rest(std::vector<NearPair>(PairBuffer::kCapacity), guard);
    kernels.of_kind[kind].measure(motion.vertices, *in.data(), rest.data());
    run_list(kernels, kind, *in.data(), soup, guard);
    run_within(kernels, kind, *in.data(), motion, guard);
  }
}

class GuardPages : public testing::TestWithParam<Isa> {};

TEST_P(GuardPages, NoKernelReadsOrWritesOutsideItsArrays) {
  const Kernels* kernels = nullptr;
  try {
    kernels = &tamis::kernels(GetParam());
  } catch (const InvalidOptions& error) {
    GTEST_SKIP() << error.what();
  }
  for (const int triangles : {2, 3, 5, 6, 7, 11, 16, 17}) {
    const Soup soup = soup_of(triangles);
    PackedMotion motion;
    motion.assign({soup.start, soup.end}, soup.points, {});
    BlockTree points, edges, faces;
    points.set_features(std::span<const Index>(soup.points));
    edges.set_features(std::span<const Edge>(soup.edges));
    faces.set_features(std::span<const Face>(soup.faces));
    motion.residuals = motion.box_vertices;
    // The kernels read groups, but all groups may touch: so they change no answer.
    std::vector<Index> group_of_vertex;
    for (const Index v : soup.points) group_of_vertex.push_back(v / 3 % 2);
    const std::vector<std::uint8_t> may_touch(4, 1);
    for (BlockTree* tree : {&points, &edges, &faces}) {
      tree->set_groups(group_of_vertex, may_touch, 2);
      tree->build(motion, {}, kernels->bound_leaf);
      tree->refit_residuals(motion, kernels->bound_leaf);
    }
    for (const Guard guard : {Guard::before, Guard::behind}) {
      const Guarded<PackedVertex> vertices(motion.vertices, guard);
      const Guarded<BoxVertex> box_vertices(motion.box_vertices, guard);
      const GuardedTree p(points, guard), e(edges, guard), f(faces, guard);
      MotionView guarded{vertices.data(), {0, true}, box_vertices.data(), {0x1p-22f, true}};
      const auto vf = run(*kernels, PairKind::vertex_face, p, f, guarded, guard);
      const auto ee = run(*kernels, PairKind::edge_edge, e, e, guarded, guard);
      EXPECT_GT(vf[0], 0);
      EXPECT_LE(vf[0], 3 * triangles * (triangles - 1));
      EXPECT_GT(ee[0], 0);
      EXPECT_LE(ee[0], 9 * triangles * (triangles - 1) / 2);
      for (const auto& counts : {vf, ee})
        for (std::size_t stage = 1; stage < counts.size(); ++stage) EXPECT_LE(counts[stage], counts[stage - 1]);
      guarded.box_separation.fixed = 0x1p-20f;
      for (const auto& [kind, a, b] : {std::tuple(PairKind::vertex_face, &p, &f), {PairKind::edge_edge, &e, &e}}) {
        const auto near = run_near(*kernels, kind, *a, *b, guarded, guard);
        EXPECT_GT(near[0], 0);
        EXPECT_LE(near[1], near[0]);
        EXPECT_GT(run_at_rest(*kernels, kind, *a, *b, guard), 0);
      }
      run_other_kinds(*kernels, soup, guarded, guard);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Isas, GuardPages, testing::ValuesIn(test::every_isa()),
                         [](const auto& isa) { return std::string(name_of(isa.param)); });

}  // namespace
}  // namespace tamis
