// Where a contact is: the features of its pair, and the weights of the point at which they touch.
#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "tamis/contact.hpp"
#include "tamis/proximity.hpp"

namespace tamis::io {

/// How the four vertices of a Contact are shared out: the first feature's, then the second's; the rest are unused.
struct PairShape {
  std::size_t first = 0;
  std::size_t second = 0;
};

PairShape shape_of(PairKind kind);

/// Weights of the first feature's vertices, then of the second's; each feature's add up to 1.
std::array<double, 4> weights_of(const Contact& contact);

/// Where a vertex is at time t of the step.
Point point_at(const Point& start, const Point& end, double t);

/// Where the touching point of the first feature is at time t.
Point contact_point(const Contact& contact, std::span<const Point> start, std::span<const Point> end, double t);

/// Of unit length; +z if the face has no area.
Point face_normal(const Face& face, std::span<const Point> positions);

/// Where the edge first meets the face.
Point intersection_point(const Intersection& intersection, std::span<const Point> positions);

}  // namespace tamis::io
