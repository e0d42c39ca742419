// A shape, which bodies share: a mesh with its points in a frame of its own, and a hierarchy over its items.
#pragma once
#include <mutex>
#include <optional>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/topology/closed_parts.hpp"
#include "search/topology/loose_features.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "worlds/box_tree.hpp"

namespace tamis {

/// Contacts are between items. Items are numbered: first the faces, then the loose edges, then the loose points.
struct BodyShape {
  /// Throws InvalidMesh, and InvalidOptions if this machine lacks the instruction set.
  BodyShape(Mesh m, std::vector<Point> at_rest, Isa isa);

  Index item_count() const {
    return static_cast<Index>(mesh.faces().size() + loose.edges.size() + loose.points.size());
  }
  /// The item's vertices; an edge or a point repeats the last one.
  Face corners_of(Index item) const;
  /// The box around the item's vertices; `at(vertex)` is a vertex' position, a Point.
  template <class F>
  Box box_of(Index item, const F& at) const {
    Box box;
    for (const Index v : corners_of(item)) box.include(at(v));
    return box;
  }
  Box box_at_rest(Index item) const {
    return box_of(item, [&](Index v) -> const Point& { return points[static_cast<std::size_t>(v)]; });
  }
  /// Found when first requested, then kept. Threads may request it at the same time.
  const ClosedParts& closed_parts() const;
  std::uint64_t memory_bytes() const;

  const Mesh mesh;
  const std::vector<Point> points;
  const LooseFeatures loose;
  BoxTree tree;
  std::vector<Box> boxes;  ///< of its nodes
  double radius = 0;       ///< no vertex in use is farther from the origin of the frame
  double edge = 0;         ///< the mean edge

 private:
  mutable std::mutex mutex_;  ///< held to find and to read closed_parts_
  mutable std::optional<ClosedParts> closed_parts_;
};

}  // namespace tamis
