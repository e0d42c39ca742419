// Proves that pairs of bodies stay apart along an edge, by nodes of their hierarchies, before any detector is made.
//
// On a piece of the edge each vertex stays within a bound of its chord. So two sets of vertices stay apart if there is
// one direction along which, at both ends of the piece, the gap between them is more than both bounds: along a
// direction the distance of two points on their chords is linear in time. Where that fails, nodes are replaced by their
// children, or the piece is halved. In the middle of each piece triangles may surely pass through each other: then the
// edge is not free.
#pragma once
#include <memory>
#include <set>
#include <vector>

#include "worlds/convex_gap.hpp"
#include "worlds/edge_motion.hpp"
#include "worlds/near_bodies.hpp"

namespace tamis {

/// What is known of an edge.
struct ProvenEdge {
  bool collides = false;           ///< surely; then nothing else is said
  std::vector<BodyPair> open;      ///< pairs about which nothing is known; ascending
  std::vector<BodyPair> at_start;  ///< other pairs whose convex hulls may meet at the start; ascending
};

class EdgeProver {
 public:
  /// Keeps references to the bodies and the tree. REQUIRES: bodies that the tree does not carry keep their motions, and
  /// those that it carries are not Static.
  EdgeProver(const BodyList& bodies, const LinkageTree& tree, const std::set<BodyPair>& excluded, double separation);

  /// `ends_at_collision`: stops at a proof that the edge is not free. Otherwise a pair that surely collides is open,
  /// and other pairs are proven apart until then. Throws Cancelled.
  const ProvenEdge& run(std::span<const double> start, std::span<const double> end, bool ends_at_collision,
                        const Options& options);

 private:
  /// A body that may meet a carried one: another carried one, as the frame of the last link that carries both sees
  /// them; or any other body that does not deform.
  struct Pair {
    std::size_t carried;  ///< the place of the first body in the linkage
    BodyId other;
    Index frame;
    bool is_open, is_near, is_apart_at_start;
    int visits;
  };
  /// Two nodes, or two items: -1 - item.
  struct Item {
    Index a, b;
  };
  /// A pair on a piece of the edge, whose items in front_[first, last) are not proven apart.
  struct Task {
    std::size_t pair, piece, first, last;
  };
  /// A pair on a piece: its bodies at both ends and in the middle.
  struct Piece {
    BodyOnEdge *a, *b;
    std::array<const PlaceOnEdge*, 3> at_a, at_b;
    std::array<double, 3> margin;
    double separation;
    int level;
    std::array<std::size_t, 3> times;

    const PlacedLeaf& leaf_of_a(Index leaf, std::size_t i) const {
      return a->leaf_at(times[i], at_a[i]->place, leaf, i);
    }
    const PlacedLeaf& leaf_of_b(Index leaf, std::size_t i) const {
      return b->leaf_at(times[i], at_b[i]->place, leaf, i);
    }

    double deviation(double reach_a, double reach_b) const {
      return a->bend().deviation(reach_a, level) + b->bend().deviation(reach_b, level);
    }
    /// True if the gap at both ends, computed, proves the pair apart on the piece.
    bool proves(double at_start, double at_end, double deviation) const {
      const double needed = (separation + deviation) * kRoundedUp;
      return at_start - margin[0] > needed && at_end - margin[2] > needed;
    }
  };

  /// Levels whose middles are probed for collisions before anything is proven.
  static constexpr int kProbedLevels = 2;

  void begin(std::span<const double> start, std::span<const double> end);
  void find_pairs();
  void add_pair(std::size_t carried, BodyId other, Index frame);
  BodyOnEdge& carried_in(std::size_t carried, Index frame);
  const PlaceOnEdge& place_of(const Pair& pair, bool is_second, std::size_t time);
  BodyOnEdge& body_of(const Pair& pair, bool is_second);
  Piece piece_of(const Task& task, int level);
  Piece piece_at(const Pair& pair, const std::array<std::size_t, 3>& times, int level);
  Box hull_of(std::size_t carried);
  bool collides_somewhere();
  /// Looks for triangles that surely pass through each other at a time.
  void probe_all(std::size_t time);
  /// Tests the items of a task. Adds those that are not proven to next_.
  void prove(const Task& task, int level);
  void visit(const Piece& piece, const Item& item);
  void visit_leaves(const Piece& piece, const Item& leaves);
  void visit_items(const Piece& piece, const Item& items);
  static bool splits_first(const Piece& piece, const Item& item);
  template <class F>
  static void for_each_part(const Piece& piece, const Item& item, bool splits_a, const F& f) {
    if (splits_a)
      piece.a->shape().tree.for_each_child(item.a, [&](Index child) { f(Item{child, item.b}); });
    else
      piece.b->shape().tree.for_each_child(item.b, [&](Index child) { f(Item{item.a, child}); });
  }
  static double support(const BodyOnEdge& body, const RoundedTransform& place, Index leaf, const Point& direction);
  static bool may_meet_in_middle(const Piece& piece, const Item& item);
  void probe(const Piece& piece, const Item& item);
  void probe_leaves(const Piece& piece, const Item& leaves);
  void collide(const Piece& piece);
  void conclude();

  const BodyList& bodies_;
  const LinkageTree& tree_;
  const double separation_;
  LinksOnEdge links_;
  std::vector<std::vector<char>> may_meet_;                       ///< of each carried body with each body
  std::vector<std::vector<Index>> common_;                        ///< the last link that carries two carried bodies
  std::vector<Index> carried_of_;                                 ///< of each body its place in the linkage, or -1
  std::vector<std::unique_ptr<BodyOnEdge>> others_;               ///< of each body; null for carried ones
  std::vector<BodyId> moving_;                                    ///< bodies besides that move
  std::vector<std::vector<std::unique_ptr<BodyOnEdge>>> frames_;  ///< by frame + 1, then place in the linkage
  BodyTree still_;
  bool ends_at_collision_ = false;
  bool stays_ = false;                    ///< the edge leads nowhere
  std::size_t first_collision_ = kTimes;  ///< a time at which a pair surely collides
  std::vector<Pair> pairs_;
  std::vector<Item> front_, next_, stack_;
  std::vector<Task> tasks_, later_;
  Pair* now_ = nullptr;
  ProvenEdge found_;
};

}  // namespace tamis
