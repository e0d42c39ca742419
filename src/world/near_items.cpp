#include "world/near_items.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace tamis {
namespace {

class PairWalk {
 public:
  PairWalk(const CarriedBoxes& a, const CarriedBoxes& b, double separation, ItemSet& items_a, ItemSet& items_b)
      : a_{a, items_a}, b_{b, items_b}, separation_(separation) {}

  /// True if any items may meet.
  bool run() {
    const Node a = root_of(a_), b = root_of(b_);
    if (meet(a.bounds, b.bounds)) visit(a, b);
    return found_;
  }

 private:
  struct Side {
    const CarriedBoxes& boxes;
    ItemSet& items;
  };
  struct Node {
    int level;
    Index block;
    MovingBounds bounds;
    PlacedBox placed;
  };

  static Node root_of(const Side& side) {
    return node_of(side, side.boxes.root_level(), 0, side.boxes.of_block(side.boxes.root_level(), 0));
  }
  static Node node_of(const Side& side, int level, Index block, const MovingBounds& bounds) {
    return {level, block, bounds, side.boxes.placed_block(level, block, bounds)};
  }
  bool meet(const MovingBounds& a, const MovingBounds& b) const { return may_meet(a, b, separation_); }

  /// The larger one is opened. REQUIRES: two that meet.
  void visit(const Node& a, const Node& b) {
    if (a.level == 0 && b.level == 0) {
      mark(a, b);
    } else if (b.level == 0 || (a.level > 0 && a.bounds.start.extent() >= b.bounds.start.extent())) {
      for_each_child_near(a_, a, b, [&](const Node& child) { visit(child, b); });
    } else {
      for_each_child_near(b_, b, a, [&](const Node& child) { visit(a, child); });
    }
  }

  template <class F>
  void for_each_child_near(const Side& side, const Node& node, const Node& other, const F& f) const {
    const auto boxes = side.boxes.body().shape().boxes.level(node.level - 1);
    const Box seen = side.boxes.seen(other.placed, separation_);
    const Index first = node.block * kBlock, last = std::min(first + kBlock, static_cast<Index>(boxes.size()));
    for (Index child = first; child < last; ++child) {
      if (!may_meet(boxes[static_cast<std::size_t>(child)], seen)) continue;
      const MovingBounds bounds = side.boxes.of_block(node.level - 1, child);
      if (meet(bounds, other.bounds)) f(node_of(side, node.level - 1, child, bounds));
    }
  }

  struct Candidates {
    int count = 0;
    std::array<Index, kBlock> items;
    std::array<MovingBounds, kBlock> bounds;
  };

  /// Items of two blocks of items that may meet each other.
  void mark(const Node& a, const Node& b) {
    const Candidates of_a = candidates(a_, a, b);
    if (of_a.count == 0) return;
    const Candidates of_b = candidates(b_, b, a);
    for (int i = 0; i < of_a.count; ++i)
      for (int j = 0; j < of_b.count; ++j)
        if (meet(of_a.bounds[static_cast<std::size_t>(i)], of_b.bounds[static_cast<std::size_t>(j)])) {
          a_.items.add(of_a.items[static_cast<std::size_t>(i)]);
          b_.items.add(of_b.items[static_cast<std::size_t>(j)]);
          found_ = true;
        }
  }

  /// Items of a block of items that may meet `other`.
  Candidates candidates(const Side& side, const Node& node, const Node& other) const {
    const BodyShape& shape = side.boxes.body().shape();
    const Box seen = side.boxes.seen(other.placed, separation_);
    Candidates found;
    for (const Index item : shape.order.items_of(node.block)) {
      if (!may_meet(shape.box_at_rest(item), seen)) continue;
      const auto place = static_cast<std::size_t>(found.count);
      found.items[place] = item;
      found.bounds[place] = side.boxes.of_item(item);
      found.count += meet(found.bounds[place], other.bounds);
    }
    return found;
  }

  const Side a_, b_;
  const double separation_;
  bool found_ = false;
};

}  // namespace

bool NearItems::includes(const NearItems& other) const {
  if (!std::ranges::includes(pairs, other.pairs)) return false;
  return std::ranges::all_of(other.of_body, [this](const auto& one) {
    const auto mine = of_body.find(one.first);
    return one.second.items().empty() || (mine != of_body.end() && mine->second.includes(one.second));
  });
}

void NearItems::add(const NearItems& other) {
  std::vector<BodyPair> all;
  std::ranges::set_union(pairs, other.pairs, std::back_inserter(all));
  pairs = std::move(all);
  for (const auto& [id, set] : other.of_body) {
    const auto mine = of_body.find(id);
    if (mine == of_body.end())
      of_body.emplace(id, set);
    else
      for (const Index item : set.items()) mine->second.add(item);
  }
}

std::size_t NearItems::count() const {
  std::size_t count = 0;
  for (const auto& [id, set] : of_body) count += set.items().size();
  return count;
}

std::uint64_t NearItems::memory_bytes() const {
  std::uint64_t bytes = pairs.capacity() * sizeof(BodyPair);
  for (const auto& [id, items] : of_body) bytes += items.memory_bytes();
  return bytes;
}

NearItems find_near_items(const BodyList& bodies, const std::vector<BodyPair>& pairs,
                          const std::function<double(const Body&, const Body&)>& reach,
                          const std::vector<double>& times) {
  NearItems near;
  const auto body = [&](BodyId id) -> const Body& { return *bodies[static_cast<std::size_t>(id)]; };
  const auto items_of = [&](BodyId id) -> ItemSet& {
    return near.of_body.try_emplace(id, body(id).shape().item_count()).first->second;
  };
  for (const BodyPair& pair : pairs) {
    const Body &first = body(pair[0]), &second = body(pair[1]);
    const double separation = reach(first, second);
    bool is_near = false;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const CarriedBoxes a(first, times[i], times[i + 1]), b(second, times[i], times[i + 1]);
      is_near |= PairWalk(a, b, separation, items_of(pair[0]), items_of(pair[1])).run();
    }
    if (is_near) near.pairs.push_back(pair);
  }
  std::set<BodyId> in_pairs;
  for (const BodyPair& pair : near.pairs) in_pairs.insert(pair.begin(), pair.end());
  std::erase_if(near.of_body, [&](const auto& one) { return !in_pairs.contains(one.first); });
  return near;
}

}  // namespace tamis
