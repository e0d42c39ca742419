#include "scenes/simulation/tests/intersection.hpp"

#include <algorithm>
#include <set>

namespace tamis::test {
namespace {

using Real = long double;
using Row = std::array<Real, 3>;

Row minus(const Point& a, const Point& b) {
  return {Real(a[0]) - Real(b[0]), Real(a[1]) - Real(b[1]), Real(a[2]) - Real(b[2])};
}

/// Positive if d lies below the plane of a, b, c seen counter-clockwise.
Real side(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Row x = minus(a, d), y = minus(b, d), z = minus(c, d);
  return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
}

bool crosses(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  if (side(a, b, c, p) * side(a, b, c, q) >= 0) return false;
  const Real u = side(p, q, a, b), v = side(p, q, b, c), w = side(p, q, c, a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

struct Box {
  Point low, high;

  bool meets(const Box& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    return true;
  }
};

template <std::size_t Count>
Box box_of(const std::vector<Point>& positions, const std::array<Index, Count>& vertices) {
  Box box{positions[static_cast<std::size_t>(vertices[0])], positions[static_cast<std::size_t>(vertices[0])]};
  for (Index v : vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], positions[static_cast<std::size_t>(v)][i]);
      box.high[i] = std::max(box.high[i], positions[static_cast<std::size_t>(v)][i]);
    }
  return box;
}

bool share_vertex(const Edge& e, const Face& f) {
  return std::any_of(f.begin(), f.end(), [&](Index v) { return v == e[0] || v == e[1]; });
}

}  // namespace

std::optional<Crossing> find_crossing(const std::vector<Point>& positions, const std::vector<Face>& faces) {
  std::set<Edge> edges;
  for (const Face& f : faces)
    for (std::size_t i = 0; i < 3; ++i) edges.insert({std::min(f[i], f[(i + 1) % 3]), std::max(f[i], f[(i + 1) % 3])});
  std::vector<Box> boxes;
  for (const Face& f : faces) boxes.push_back(box_of(positions, f));
  const auto at = [&](Index v) -> const Point& { return positions[static_cast<std::size_t>(v)]; };
  for (const Edge& e : edges) {
    const Box box = box_of(positions, e);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Face& f = faces[i];
      if (!box.meets(boxes[i]) || share_vertex(e, f)) continue;
      if (crosses(at(e[0]), at(e[1]), at(f[0]), at(f[1]), at(f[2]))) return Crossing{e, f};
    }
  }
  return std::nullopt;
}

}  // namespace tamis::test
