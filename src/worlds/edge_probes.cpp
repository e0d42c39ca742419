// Looks for collisions at single times of an edge.
#include <algorithm>
#include <cmath>

#include "search/topology/at.hpp"
#include "worlds/edge_prover.hpp"

namespace tamis {

/// Looks at the end, then in the middles of the pieces of the first levels, as checks of single states do. Most edges
/// that collide are found here.
bool EdgeProver::collides_somewhere() {
  probe_all(kTimes - 1);
  if (stays_) return found_.collides;
  for (int level = 0; level < kProbedLevels && !found_.collides; ++level)
    for (std::size_t piece = 0; piece < (std::size_t{1} << level) && !found_.collides; ++piece)
      probe_all((2 * piece + 1) << (kFinest - level - 1));
  return found_.collides;
}

void EdgeProver::probe_all(std::size_t time) {
  for (Pair& pair : pairs_) {
    now_ = &pair;
    const Piece piece = piece_at(pair, {time, time, time}, 0);
    const Item roots{piece.a->shape().tree.root(), piece.b->shape().tree.root()};
    if (may_meet_in_middle(piece, roots)) probe(piece, roots);
    if (found_.collides) return;
  }
}

/// Looks for triangles of both nodes that surely pass through each other in the middle of the piece.
void EdgeProver::probe(const Piece& piece, const Item& item) {
  if (found_.collides || now_->is_open) return;
  ++now_->visits;
  const BodyShape &shape_a = piece.a->shape(), &shape_b = piece.b->shape();
  if (shape_a.tree.is_leaf(item.a) && shape_b.tree.is_leaf(item.b)) return probe_leaves(piece, item);
  for_each_part(piece, item, splits_first(piece, item), [&](const Item& part) {
    if (may_meet_in_middle(piece, part)) probe(piece, part);
  });
}

/// By balls, then by boxes.
bool EdgeProver::may_meet_in_middle(const Piece& piece, const Item& item) {
  const MiddleBox &a = piece.a->box(item.a), &b = piece.b->box(item.b);
  const RoundedTransform &at_a = piece.at_a[1]->place, &at_b = piece.at_b[1]->place;
  const Point way = difference(at_b.of(b.middle), at_a.of(a.middle));
  const double balls = a.radius + b.radius;
  return dot(way, way) <= balls * balls && gap_of(a, at_a, b, at_b).width <= 0;
}

void EdgeProver::probe_leaves(const Piece& piece, const Item& leaves) {
  const PlacedLeaf &a = piece.leaf_of_a(leaves.a, 1), &b = piece.leaf_of_b(leaves.b, 1);
  const std::size_t count_a = piece.a->shape().tree.items_of(leaves.a).size(),
                    count_b = piece.b->shape().tree.items_of(leaves.b).size();
  for (std::size_t i = 0; i < count_a; ++i) {
    if (!may_meet(a.boxes[i], b.all)) continue;
    for (std::size_t k = 0; k < count_b; ++k)
      if (may_meet(a.boxes[i], b.boxes[k]) && surely_meet(a.corners[i], b.corners[k], piece.margin[1]))
        return collide(piece);
  }
}

void EdgeProver::collide(const Piece& piece) {
  (ends_at_collision_ ? found_.collides : now_->is_open) = true;
  first_collision_ = std::min(first_collision_, piece.times[1]);
}

}  // namespace tamis
