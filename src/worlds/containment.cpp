#include "worlds/containment.hpp"

#include <algorithm>

#include "pair/exact/ray_crossing.hpp"
#include "pair/exact/start_distance.hpp"
#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"
#include "worlds/body_bounds.hpp"

namespace tamis {
namespace {

/// A shape's seams are at rest. The seams of a body that does not deform stay together.
bool seams_hold(const Body& body) {
  return !body.deforming() || std::ranges::all_of(body.shape().closed_parts().seams, [&](const auto& seam) {
    return body.start_of(seam[0]) == body.start_of(seam[1]);
  });
}

/// Sums the faces of a body that a ray from a point crosses.
class InsideTest {
 public:
  InsideTest(const Body& outer, const Point& point)
      : outer_(outer),
        parts_(outer.shape().closed_parts()),
        boxes_(outer, 0, 0),
        point_(point),
        crossed_(at(parts_.count)) {}

  /// True if the point is in a closed part, or on it.
  bool run() {
    visit(outer_.shape().tree.root());
    return is_on_surface_ || crossed_[ClosedParts::kWound] != 0 ||
           std::any_of(crossed_.begin() + 1, crossed_.end(), [](int crossed) { return crossed % 2 != 0; });
  }

 private:
  /// False only if the ray surely misses the box.
  bool may_reach(const Box& box) const {
    return !(box.high[0] < point_[0] || box.low[1] > point_[1] || box.high[1] < point_[1] || box.low[2] > point_[2] ||
             box.high[2] < point_[2]);
  }

  void visit(Index node) {
    if (!may_reach(boxes_.bounds(node).start)) return;
    const BoxTree& tree = outer_.shape().tree;
    if (!tree.is_leaf(node)) {
      tree.for_each_child(node, [&](Index child) { visit(child); });
    } else {
      for (const Index item : tree.items_of(node))
        if (at(item) < parts_.part_of_face.size()) count(item);
    }
  }

  void count(Index item) {
    const Index part = parts_.part_of_face[at(item)];
    if (part == ClosedParts::kOpen) return;
    const Face& corners = outer_.shape().mesh.faces()[at(item)];
    const std::array<Point, 3> face{outer_.start_of(corners[0]), outer_.start_of(corners[1]),
                                    outer_.start_of(corners[2])};
    is_on_surface_ = is_on_surface_ || is_on(face);
    crossed_[at(part)] += ray_crossing(point_, face);
  }

  bool is_on(const std::array<Point, 3>& face) const {
    Box box;
    for (const Point& corner : face) box.include(corner);
    if (!may_meet(box, {point_, point_})) return false;
    const std::array<Point, 4> points{point_, face[0], face[1], face[2]};
    return starts_within(PairKind::vertex_face, {points, points}, 0);
  }

  const Body& outer_;
  const ClosedParts& parts_;
  const BodyOnPiece boxes_;
  const Point point_;
  std::vector<int> crossed_;  ///< for each part
  bool is_on_surface_ = false;
};

}  // namespace

bool is_closed(const Body& body) { return body.shape().closed_parts().is_closed() && seams_hold(body); }

bool encloses(const Body& outer, const Body& inner, const Options& options) {
  const auto is_near = [&](Index v) {
    const Point point = inner.start_of(v);
    return may_meet(outer.start_hull(), {point, point});
  };
  if (!outer.shape().closed_parts().encloses() || !seams_hold(outer)) return false;
  return std::ranges::any_of(inner.shape().closed_parts().one_vertex_of_each, [&](Index v) {
    if (!is_near(v)) return false;
    stop_if_cancelled(options);
    return InsideTest(outer, inner.start_of(v)).run();
  });
}

}  // namespace tamis
