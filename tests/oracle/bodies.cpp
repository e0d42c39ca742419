#include "oracle/bodies.hpp"

#include <algorithm>
#include <set>

namespace tamis::oracle {
namespace {

Real way(const Point& a, const Point& b) { return std::hypot(Real(b[0]) - a[0], Real(b[1]) - a[1], Real(b[2]) - a[2]); }

/// From its origin, of the farthest point.
Real radius(const TurningBody& body) {
  Real radius = 0;
  for (const Point& p : body.points) radius = std::max(radius, way({0, 0, 0}, p));
  return radius;
}

/// No point of the body is faster.
Real speed(const TurningBody& body) {
  const Turning& motion = body.motion;
  return radius(body) * way(motion.theta0, motion.theta1) + way(motion.p0, motion.p1);
}

std::set<std::array<Index, 2>> edges_of(const TurningBody& body) {
  std::set<std::array<Index, 2>> edges;
  for (const Face& face : body.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({face[k], face[(k + 1) % 3]});
      edges.insert({low, high});
    }
  return edges;
}

/// Pairs of features, each with a time before which it does not touch.
class Candidates {
 public:
  Candidates(const TurningBody& first, const TurningBody& second, Real separation)
      : speed_(speed(first) + speed(second)), separation_(separation) {
    if (way(first.motion.p0, second.motion.p0) > radius(first) + radius(second) + separation + speed_) return;
    add_vertices(first, second);
    add_vertices(second, first);
    const auto others = edges_of(second);
    for (const auto& [a, b] : edges_of(first))
      for (const auto& [c, d] : others)
        add({PairKind::edge_edge,
             {at(first, a), at(first, b), at(second, c), at(second, d)},
             first.motion,
             second.motion});
  }

  Real first_touch() {
    std::ranges::sort(all_, {}, &Candidate::not_before);
    Real first = 2;
    for (const Candidate& candidate : all_) {
      if (candidate.not_before > first) break;
      first = std::min(first, apart_until(candidate.pair, separation_));
    }
    return first;
  }

 private:
  struct Candidate {
    TurningPair pair;
    Real not_before;
  };

  static const Point& at(const TurningBody& body, Index vertex) {
    return body.points[static_cast<std::size_t>(vertex)];
  }

  void add_vertices(const TurningBody& points, const TurningBody& faces) {
    for (const Point& p : points.points)
      for (const auto& [a, b, c] : faces.faces)
        add({PairKind::vertex_face, {p, at(faces, a), at(faces, b), at(faces, c)}, points.motion, faces.motion});
  }

  void add(const TurningPair& pair) {
    const Real apart = distance(pair, 0) - separation_;
    if (apart <= speed_) all_.push_back({pair, speed_ > 0 ? apart / speed_ : 0});
  }

  Real speed_, separation_;
  std::vector<Candidate> all_;
};

}  // namespace

Real first_touch(const TurningBody& first, const TurningBody& second, Real separation) {
  return Candidates(first, second, separation).first_touch();
}

}  // namespace tamis::oracle
