#include <algorithm>
#include <cmath>

#include "bench/contenders/bodies/bodies.hpp"
#include "oracle/turning.hpp"
#include "tamis/mesh.hpp"

namespace tamis::bench {
namespace {

double length(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

/// No point of the body is faster.
double speed(const MovingBody& body) {
  double radius = 0;
  for (const Point& p : body.shape.points) radius = std::max(radius, length(p));
  const Point way{body.to[0] - body.from[0], body.to[1] - body.from[1], body.to[2] - body.from[2]};
  return radius * length(body.turn) + length(way);
}

/// Pairs of features, and a time before which they do not touch.
class Candidates {
 public:
  explicit Candidates(const MovingPair& pair) : speed_(speed(pair.first) + speed(pair.second)) {
    add_vertices(pair.first, pair.second);
    add_vertices(pair.second, pair.first);
    const std::vector<Edge> second = edges_of(pair.second);
    for (const Edge& e : edges_of(pair.first))
      for (const Edge& f : second)
        add({PairKind::edge_edge,
             {at(pair.first, e[0]), at(pair.first, e[1]), at(pair.second, f[0]), at(pair.second, f[1])},
             motion_of(pair.first),
             motion_of(pair.second)});
  }

  double first_contact() {
    std::ranges::sort(all_, {}, &Candidate::not_before);
    double first = kNever;
    for (const Candidate& candidate : all_) {
      if (candidate.not_before > first) break;
      first = std::min(first, static_cast<double>(oracle::apart_until(candidate.pair)));
    }
    return first;
  }

 private:
  struct Candidate {
    oracle::TurningPair pair;
    double not_before;
  };

  static oracle::Turning motion_of(const MovingBody& body) { return {{0, 0, 0}, body.turn, body.from, body.to}; }
  static const Point& at(const MovingBody& body, Index vertex) {
    return body.shape.points[static_cast<std::size_t>(vertex)];
  }
  static std::vector<Edge> edges_of(const MovingBody& body) {
    const Mesh mesh(static_cast<Index>(body.shape.points.size()), body.shape.faces);
    return {mesh.edges().begin(), mesh.edges().end()};
  }

  void add_vertices(const MovingBody& points, const MovingBody& faces) {
    for (const Point& p : points.shape.points)
      for (const Face& f : faces.shape.faces)
        add({PairKind::vertex_face,
             {p, at(faces, f[0]), at(faces, f[1]), at(faces, f[2])},
             motion_of(points),
             motion_of(faces)});
  }

  void add(const oracle::TurningPair& pair) {
    const double not_before = static_cast<double>(oracle::distance(pair, 0)) / speed_;
    if (not_before <= 1) all_.push_back({pair, not_before});
  }

  double speed_;
  std::vector<Candidate> all_;
};

}  // namespace

double true_first_contact(const MovingPair& pair) { return Candidates(pair).first_contact(); }

}  // namespace tamis::bench
