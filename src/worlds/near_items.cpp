#include "worlds/near_items.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>

#include "numbers/assert.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "worlds/body_bounds.hpp"

namespace tamis {
namespace {

/// The nodes that have all their items in a set, each tested when first requested. Items added later do not count.
class WholeNodes {
 public:
  WholeNodes(const BoxTree& tree, const IndexSet& near) : tree_(tree), near_(near), answers_(at(tree.node_count())) {}

  bool has(Index node) {
    std::optional<bool>& answer = answers_[at(node)];
    if (!answer) answer = is_whole(node);
    return *answer;
  }

 private:
  bool is_whole(Index node) {
    if (tree_.is_leaf(node)) return near_.has_all(tree_.items_of(node));
    bool has_all = true;
    tree_.for_each_child(node, [&](Index child) { has_all = has_all && has(child); });
    return has_all;
  }

  const BoxTree& tree_;
  const IndexSet& near_;
  std::vector<std::optional<bool>> answers_;
};

class PairWalk {
 public:
  struct Side {
    BoundsOnPiece& boxes;
    IndexSet& near;
    WholeNodes& whole;
  };

  PairWalk(const Side& a, const Side& b, double separation, const Options& options)
      : a_(a), b_(b), separation_(separation), options_(options) {}

  /// Adds the items that may meet. Returns true if there are any, or if `found`: some were found before.
  bool run(bool found) {
    found_ = found;
    const Node a = root_of(a_), b = root_of(b_);
    if (meet(a.bounds, b.bounds)) visit(a, b);
    return found_;
  }

 private:
  struct Node {
    Index number;
    const MovingBounds& bounds;
  };

  static const BoxTree& tree_of(const Side& side) { return side.boxes.shape().tree; }
  static Node node_of(const Side& side, Index number) { return {number, side.boxes.bounds(number)}; }
  static Node root_of(const Side& side) { return node_of(side, tree_of(side).root()); }
  bool meet(const MovingBounds& a, const MovingBounds& b) const { return may_meet(a, b, separation_); }

  /// Descends into the larger node. REQUIRES: the nodes meet.
  void visit(const Node& a, const Node& b) {
    if (found_ && a_.whole.has(a.number) && b_.whole.has(b.number)) return;
    if (++visited_ % kVisitsPerCheck == 0) stop_if_cancelled(options_);
    const bool is_a_leaf = tree_of(a_).is_leaf(a.number), is_b_leaf = tree_of(b_).is_leaf(b.number);
    if (is_a_leaf && is_b_leaf) {
      mark(a, b);
    } else if (is_b_leaf || (!is_a_leaf && a.bounds.start.extent() >= b.bounds.start.extent())) {
      for_each_child_near(a_, a, b, [&](const Node& child) { visit(child, b); });
    } else {
      for_each_child_near(b_, b, a, [&](const Node& child) { visit(a, child); });
    }
  }

  template <class F>
  void for_each_child_near(const Side& side, const Node& node, const Node& other, const F& f) const {
    tree_of(side).for_each_child(node.number, [&](Index number) {
      if (const Node child = node_of(side, number); meet(child.bounds, other.bounds)) f(child);
    });
  }

  /// Adds the items of two leaves that may meet each other.
  void mark(const Node& node_a, const Node& node_b) {
    const auto items_a = tree_of(a_).items_of(node_a.number), items_b = tree_of(b_).items_of(node_b.number);
    const ItemBounds& a = a_.boxes.items(node_a.number);
    if (!meet(a.all, node_b.bounds)) return;
    const ItemBounds& b = b_.boxes.items(node_b.number);
    if (!meet(a.all, b.all)) return;
    std::array<std::size_t, kBlock> near_b;
    std::size_t count = 0;
    for (std::size_t j = 0; j < items_b.size(); ++j)
      if (meet(b.of_item[j], a.all)) near_b[count++] = j;
    for (std::size_t i = 0; count > 0 && i < items_a.size(); ++i) {
      if (!meet(a.of_item[i], b.all)) continue;
      for (const std::size_t j : std::span(near_b).first(count)) {
        if (found_ && a_.near.has(items_a[i]) && b_.near.has(items_b[j])) continue;
        if (!meet(a.of_item[i], b.of_item[j])) continue;
        found_ = true;
        a_.near.add(items_a[i]);
        b_.near.add(items_b[j]);
      }
    }
  }

  static constexpr int kVisitsPerCheck = 1 << 12;  // well below a millisecond

  const Side a_, b_;
  const double separation_;
  const Options& options_;
  bool found_ = false;
  int visited_ = 0;
};

}  // namespace

bool NearItems::includes(const NearItems& other) const {
  if (!std::ranges::includes(pairs, other.pairs)) return false;
  return std::ranges::all_of(other.of_body, [this](const auto& one) {
    const auto mine = of_body.find(one.first);
    return mine != of_body.end() && mine->second.includes(one.second);
  });
}

std::size_t NearItems::count() const {
  std::size_t count = 0;
  for (const auto& [id, set] : of_body) count += set.size();
  return count;
}

void add_near_items(const BodyList& bodies, const std::vector<BodyPair>& pairs, const NearDistance& distance,
                    std::span<const double> times, const Options& options, NearItems& near) {
  const auto body = [&](BodyId id) -> const Body& { return *bodies[at(id)]; };
  const auto items_of = [&](BodyId id) -> IndexSet& {
    return near.of_body.try_emplace(id, body(id).shape().item_count()).first->second;
  };
  TAMIS_ASSERT(std::ranges::is_sorted(pairs));
  std::map<BodyId, BoundsOnPiece> of_still, of_moving;
  std::vector<char> is_near;
  for (const BodyPair& pair : pairs) is_near.push_back(static_cast<char>(std::ranges::binary_search(near.pairs, pair)));
  // On so many pieces together curves deviate by a fourth of an edge at most. This gathers only a few items more.
  constexpr std::size_t kPiecesTogether = 4;
  for (std::size_t first = 0, last = 0; first + 1 < times.size(); first = last) {
    last = std::min(first + kPiecesTogether, times.size() - 1);
    std::map<BodyId, WholeNodes> whole;
    const auto side = [&](BodyId id) {
      auto& bounds = body(id).motion_kind() == MotionKind::still ? of_still : of_moving;
      BoundsOnPiece& boxes = bounds.try_emplace(id, body(id), times[first], times[last]).first->second;
      IndexSet& items = items_of(id);
      return PairWalk::Side{boxes, items, whole.try_emplace(id, body(id).shape().tree, items).first->second};
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      // Pairs of bodies before `a` are done. Their memory, which is in the caches, serves the pairs that follow.
      of_moving.erase(of_moving.begin(), of_moving.lower_bound(a));
      stop_if_cancelled(options);
      PairWalk walk(side(a), side(b), distance.between(body(a), body(b)), options);
      if (walk.run(is_near[i])) is_near[i] = true;
    }
    of_moving.clear();
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (is_near[i]) near.pairs.push_back(pairs[i]);
  std::ranges::sort(near.pairs);
  near.pairs.erase(std::unique(near.pairs.begin(), near.pairs.end()), near.pairs.end());
  std::set<BodyId> in_pairs;
  for (const BodyPair& pair : near.pairs) in_pairs.insert(pair.begin(), pair.end());
  std::erase_if(near.of_body, [&](const auto& one) { return !in_pairs.contains(one.first); });
}

}  // namespace tamis
