#include "integrations/bullet/throws/independent.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "integrations/bullet/mesh_of_shape.hpp"
#include "tamis/detector.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::bullet {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Six times the volume of the tetrahedron.
double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = minus(b, a), v = minus(c, a), w = minus(d, a);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// The motion from one of Bullet's transforms to another: origin straight, turn at constant speed about a fixed axis
/// (Rodrigues' formula).
class Turning {
 public:
  Turning(const btTransform& from, const btTransform& to)
      : from_(from), start_(point_of(from.getOrigin())), way_(minus(point_of(to.getOrigin()), start_)) {
    double turn[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) turn[i][j] = dot(point_of(to.getBasis()[i]), point_of(from.getBasis()[j]));
    axis_ = {turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1]};
    const double sine = std::sqrt(dot(axis_, axis_));  // sine, axis and cosine are all twice as large here
    angle_ = std::atan2(sine, turn[0][0] + turn[1][1] + turn[2][2] - 1);
    for (double& x : axis_) x = sine > 0 ? x / sine : 0;
  }

  Point at(double t, const Point& local) const {
    Point x;
    for (int i = 0; i < 3; ++i) x[static_cast<std::size_t>(i)] = dot(point_of(from_.getBasis()[i]), local);
    const double c = std::cos(t * angle_), s = std::sin(t * angle_), along = dot(axis_, x) * (1 - c);
    const Point across{axis_[1] * x[2] - axis_[2] * x[1], axis_[2] * x[0] - axis_[0] * x[2],
                       axis_[0] * x[1] - axis_[1] * x[0]};
    Point moved;
    for (std::size_t i = 0; i < 3; ++i)
      moved[i] = start_[i] + t * way_[i] + c * x[i] + s * across[i] + along * axis_[i];
    return moved;
  }

 private:
  static double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  btTransform from_;
  Point start_, way_, axis_;
  double angle_;
};

bool passes_through(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  if ((volume(p, a, b, c) > 0) == (volume(q, a, b, c) > 0)) return false;
  const bool side = volume(p, q, a, b) > 0;
  return (volume(p, q, b, c) > 0) == side && (volume(p, q, c, a) > 0) == side;
}

bool edges_pass(const std::vector<Point>& edges_of, const std::vector<Face>& with_edges,
                const std::vector<Point>& points, const std::vector<Face>& faces) {
  const auto at = [](const std::vector<Point>& all, Index i) -> const Point& {
    return all[static_cast<std::size_t>(i)];
  };
  return std::ranges::any_of(with_edges, [&](const Face& edges) {
    return std::ranges::any_of(faces, [&](const Face& face) {
      for (std::size_t i = 0; i < 3; ++i)
        if (passes_through(at(edges_of, edges[i]), at(edges_of, edges[(i + 1) % 3]), at(points, face[0]),
                           at(points, face[1]), at(points, face[2])))
          return true;
      return false;
    });
  });
}

}  // namespace

int touching_steps(std::span<const Triangles> bodies, const Places& places) {
  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<Index> body_of_vertex;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const auto first = static_cast<Index>(points.size());
    points.insert(points.end(), bodies[body].points.begin(), bodies[body].points.end());
    body_of_vertex.resize(points.size(), static_cast<Index>(body));
    for (const Face& face : bodies[body].faces) faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  }
  // Bullet keeps floats.
  for (Point& p : points)
    for (double& x : p) x = static_cast<btScalar>(x);
  Detector detector(Mesh(static_cast<Index>(points.size()), faces),
                    {.threads = 1, .filter = PairFilter::no_self_contact(body_of_vertex)});
  int touching = 0;
  for (std::size_t step = 0; step + 1 < places.size(); ++step) {
    std::vector<RigidChain> ways;
    for (std::size_t body = 0; body < bodies.size(); ++body)
      ways.push_back(chain_between(pose_of(places[step][body]), pose_of(places[step + 1][body])));
    touching += !detector.is_free(RigidPath(points, body_of_vertex, ways));
  }
  return touching;
}

Places places_of(const Flight& flight) {
  Places places;
  for (const btTransform& place : flight.places) places.push_back({btTransform::getIdentity(), place});
  return places;
}

int touching_steps(const Arena& arena, const Flight& flight) {
  return touching_steps(std::array{arena.fixed(), arena.flying()}, places_of(flight));
}

int sampled_crossings(const Arena& arena, const Flight& flight, int samples) {
  const Triangles &fixed = arena.fixed(), &flying = arena.flying();
  std::vector<Point> points(flying.points.size());
  int crossings = 0;
  for (std::size_t step = 0; step + 1 < flight.places.size(); ++step) {
    const Turning turning(flight.places[step], flight.places[step + 1]);
    bool crosses = false;
    for (int sample = 1; sample <= samples && !crosses; ++sample) {
      const double t = static_cast<double>(sample) / samples;
      for (std::size_t i = 0; i < points.size(); ++i) points[i] = turning.at(t, flying.points[i]);
      crosses = edges_pass(points, flying.faces, fixed.points, fixed.faces) ||
                edges_pass(fixed.points, fixed.faces, points, flying.faces);
    }
    crossings += crosses;
  }
  return crossings;
}

}  // namespace tamis::bullet
