#include "oracle/bodies.hpp"

#include <algorithm>
#include <set>

namespace tamis::oracle {
namespace {

Real way(const Point& a, const Point& b) { return std::hypot(Real(b[0]) - a[0], Real(b[1]) - a[1], Real(b[2]) - a[2]); }

struct Vertex {
  const MovingBody* body;
  Index number;

  const Point& start() const { return body->points[static_cast<std::size_t>(number)]; }
  const Point& end() const {
    return body->points_at_end.empty() ? start() : body->points_at_end[static_cast<std::size_t>(number)];
  }
};

RealPoint position(const Vertex& vertex, Real t) {
  RealPoint x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = (1 - t) * vertex.start()[k] + t * vertex.end()[k];
  for (auto link = vertex.body->links.rbegin(); link != vertex.body->links.rend(); ++link) x = position(*link, x, t);
  return x;
}

/// A bound of the vertex' speed: each link, with |x| <= r in its frame, adds at most |theta'| r + |p'| to it.
Real speed(const Vertex& vertex) {
  constexpr Point kOrigin{0, 0, 0};
  Real speed = way(vertex.start(), vertex.end()),
       reach = std::max(way(kOrigin, vertex.start()), way(kOrigin, vertex.end()));
  for (auto link = vertex.body->links.rbegin(); link != vertex.body->links.rend(); ++link) {
    speed += way(link->theta0, link->theta1) * reach + way(link->p0, link->p1);
    reach += std::max(way(kOrigin, link->p0), way(kOrigin, link->p1));
  }
  return speed;
}

/// A pair of features, and a time before which it does not touch.
struct Candidate {
  PairKind kind;
  std::array<Vertex, 4> vertices;
  Real fastest, not_before;

  Real distance(Real t) const {
    std::array<RealPoint, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = position(vertices[i], t);
    return oracle::distance(kind, x);
  }
};

class Candidates {
 public:
  Candidates(const MovingBody& first, const MovingBody& second, Real separation) : separation_(separation) {
    add_vertices(first, second);
    if (&first != &second) add_vertices(second, first);
    const auto edges = edges_of(first), others = edges_of(second);
    for (const auto& [a, b] : edges)
      for (const auto& [c, d] : others)
        if (&first != &second || std::pair(a, b) < std::pair(c, d))
          add(PairKind::edge_edge, {{{&first, a}, {&first, b}, {&second, c}, {&second, d}}});
  }

  Real first_touch() {
    std::ranges::sort(all_, {}, &Candidate::not_before);
    Real first = 2;
    for (const Candidate& candidate : all_) {
      if (candidate.not_before > first) break;
      const auto distance = [&](Real t) { return candidate.distance(t); };
      first = std::min(first, apart_until(distance, candidate.fastest, separation_));
    }
    return first;
  }

 private:
  static std::set<std::array<Index, 2>> edges_of(const MovingBody& body) {
    std::set<std::array<Index, 2>> edges;
    for (const Face& face : body.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({face[k], face[(k + 1) % 3]});
        edges.insert({low, high});
      }
    return edges;
  }

  void add_vertices(const MovingBody& points, const MovingBody& faces) {
    for (Index p = 0; p < static_cast<Index>(points.points.size()); ++p)
      for (const auto& [a, b, c] : faces.faces)
        add(PairKind::vertex_face, {{{&points, p}, {&faces, a}, {&faces, b}, {&faces, c}}});
  }

  void add(PairKind kind, const std::array<Vertex, 4>& vertices) {
    const std::size_t second = kind == PairKind::vertex_face ? 1 : 2;
    Real of_first = 0, of_second = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      Real& fastest = i < second ? of_first : of_second;
      fastest = std::max(fastest, speed(vertices[i]));
      for (std::size_t j = second; i < second && j < 4; ++j)
        if (vertices[i].body == vertices[j].body && vertices[i].number == vertices[j].number) return;
    }
    Candidate candidate{kind, vertices, of_first + of_second, 0};
    const Real apart = candidate.distance(0) - separation_;
    if (apart > candidate.fastest) return;
    if (apart > 0) candidate.not_before = apart / candidate.fastest;
    all_.push_back(candidate);
  }

  Real separation_;
  std::vector<Candidate> all_;
};

/// A box that contains the vertices at all times.
struct Reached {
  RealPoint low{1e300L, 1e300L, 1e300L}, high{-1e300L, -1e300L, -1e300L};

  explicit Reached(const MovingBody& body) {
    for (Index v = 0; v < static_cast<Index>(body.points.size()); ++v) {
      const RealPoint x = position({&body, v}, 0);
      const Real far = speed({&body, v});
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], x[k] - far);
        high[k] = std::max(high[k], x[k] + far);
      }
    }
  }
};

bool are_far(const Reached& a, const Reached& b, Real separation) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] - b.high[k] > separation || b.low[k] - a.high[k] > separation) return true;
  return false;
}

}  // namespace

Real first_touch(const MovingBody& first, const MovingBody& second, Real separation) {
  if (are_far(Reached(first), Reached(second), separation)) return 2;
  return Candidates(first, second, separation).first_touch();
}

Real first_touch(const MovingBody& body, Real separation) { return Candidates(body, body, separation).first_touch(); }

}  // namespace tamis::oracle
