#include "files/output/contact_geometry.hpp"

#include <cmath>

namespace tamis::io {

PairShape shape_of(PairKind kind) {
  switch (kind) {
    case PairKind::vertex_face:
      return {1, 3};
    case PairKind::edge_edge:
      return {2, 2};
    case PairKind::vertex_edge:
      return {1, 2};
    case PairKind::vertex_vertex:
      return {1, 1};
  }
  return {};
}

std::array<double, 4> weights_of(const Contact& contact) {
  const double u = contact.u, v = contact.v;
  switch (contact.kind) {
    case PairKind::vertex_face:
      return {1, 1 - u - v, u, v};
    case PairKind::edge_edge:
      return {1 - u, u, 1 - v, v};
    case PairKind::vertex_edge:
      return {1, 1 - u, u, 0};
    case PairKind::vertex_vertex:
      return {1, 1, 0, 0};
  }
  return {};
}

Point point_at(const Point& start, const Point& end, double t) {
  Point point;
  for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = (1 - t) * start[axis] + t * end[axis];
  return point;
}

Point contact_point(const Contact& contact, std::span<const Point> start, std::span<const Point> end, double t) {
  const std::array<double, 4> weights = weights_of(contact);
  Point sum{};
  for (std::size_t i = 0; i < shape_of(contact.kind).first; ++i) {
    const auto vertex = static_cast<std::size_t>(contact.vertices[i]);
    const Point x = point_at(start[vertex], end[vertex], t);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weights[i] * x[axis];
  }
  return sum;
}

Point face_normal(const Face& face, std::span<const Point> positions) {
  const auto corner = [&](std::size_t i) { return positions[static_cast<std::size_t>(face[i])]; };
  Point ab{}, ac{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ab[axis] = corner(1)[axis] - corner(0)[axis];
    ac[axis] = corner(2)[axis] - corner(0)[axis];
  }
  const Point n{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0 && std::isfinite(length))) return {0, 0, 1};
  return {n[0] / length, n[1] / length, n[2] / length};
}

Point intersection_point(const Intersection& intersection, std::span<const Point> positions) {
  const auto [a, b] = intersection.edge;
  return point_at(positions[static_cast<std::size_t>(a)], positions[static_cast<std::size_t>(b)], intersection.s_upper);
}

}  // namespace tamis::io
